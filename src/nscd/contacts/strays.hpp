// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that go otherwise than a list expects: while they are few, the list is mended for them and not built anew.
// Tested by tests/unit/nscd/contacts/straysTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Own bodies that leave what the list allows for if all move on with their present velocities for deltaT, ascending; no more than `most` + 1 of them.
std::vector<int> findStrays(const ContactList& list, double deltaT, std::size_t most);

/// Whether a list's time is long enough for one more step: what is expected of it says nothing about later ones.
bool isWithinTime(const ContactList& list, double deltaT);

/// Gives bodies a path from where they are, with their present velocities and the slack that they have, and lists the pairs that may meet for it.
/// These come into the list's free blocks, with geometry and without impulses; all pairs of a stray are fast ones then. Where the list is without
/// paths its slack lets a stray go on as fast until the list's time is over, or for a step of deltaT at least. For lists within their time, without
/// general bodies and walls that move.
/// Returns whether that was possible. It is not where a velocity is not finite, a stray comes to walls that are not listed for it, or may reach
/// further than half a period, or to where grains of other ranks may be, or the pairs have no room: then paths may have changed, and the list is to be
/// built anew.
bool followStrays
(
    ContactList& list, const std::vector<int>& strays, const Scene& scene, const WallSearch& wallSearch, const Exchange& exchange, double deltaT
);

/// Whether any pair of the blocks first .. list.freeBlock - 1 touches, or comes into the range of laws, within deltaT at the present velocities.
bool doAnyTouch(const ContactList& list, const Scene& scene, std::size_t first, double deltaT);

} // namespace nscd
