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

/// Gives bodies a path from where they are, with their present velocities and as much slack as before, and lists the pairs that may meet for it. These are
/// appended as fast pairs, with geometry and without impulses. The list is that of a search by this process alone, without general bodies, within its time.
/// Returns whether that was possible. It is not where a stray comes to walls that the list lacks for it, or the list's memory is full: then it is to be built anew.
bool followStrays(ContactList& list, const std::vector<int>& strays, const Scene& scene, const WallSearch& wallSearch, double deltaT);

/// Whether any pair of the blocks from `first` on touches, or comes into the range of laws, within deltaT at the present velocities.
bool doAnyTouch(const ContactList& list, const Scene& scene, std::size_t first, double deltaT);

} // namespace nscd
