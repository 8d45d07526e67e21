// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs that move by much of their size in a step, and meet, or pass one another, within it.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Notes the pairs of grains that may move by much of their size in a step, after the list was built; none in slow scenes.
void findFastPairs(ContactList& list);

/// Gives fast pairs the normal n they have when they meet, or are nearest, in the free motion (the bodies' velocities), and the gap n.x - R_A - R_B
/// along it. In the free motion they then stop where they touch, and pass where they miss; whatever else happens to them, they
/// stay on two sides of a plane: n.x >= R_A + R_B before, and after by the gap rule.
void aimFastPairs(ContactList& list, const PeriodicBox& box, double deltaT);

} // namespace nscd
