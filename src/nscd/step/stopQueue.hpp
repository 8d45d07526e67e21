// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that would run into others which stopped on their way stop behind them.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/step/stopsOnWay.hpp"

namespace nscd
{

/// Adds those own bodies to `stops` whose ways lead through the place of one that stopped earlier in the step, and others behind these. `tolerance`:
/// overlap that is none [m].
/// Method:   the earliest stop first, as in Dijkstra's shortest paths: who runs into it stops later than it, or at once.
/// Cost:     linear in the number of bodies and the lengths of their ways.
void addQueue(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops);

/// On several ranks: makes own bodies stop behind those of other ranks, and tells other ranks of theirs. Returns whether any had to, on any rank:
/// then others may have to stop behind them.
bool stopBehindOtherRanks(const ContactList& list, const PeriodicBox& box, double deltaT, double tolerance, std::vector<Stop>& stops);

/// Whether a body moves by itself: neither held nor a member of a clump.
bool fliesAlone(const ContactList& list, int body);

} // namespace nscd
