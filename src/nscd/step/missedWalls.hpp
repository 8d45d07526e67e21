// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fast grains that come to walls which the list does not have for them.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/step/groupMotion.hpp"

namespace nscd
{

/// Whether a grain that sees only near walls may come to others on this way [m].
bool mayMissWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<GroupMotion>& motions, int body, const Vec3& way);

/// The own bodies that are near walls of many regions which the list may not have for them, at the end of the step.
std::vector<int> bodiesAtMissedWalls(const ContactList& list, const WallsOfStep& walls);

/// How deep the deepest of these bodies is in any outlined wall at the end of the step [m]; 0 where none is.
double deepestInMissedWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies);

/// Moves bodies that are deeper in outlined walls than `allowed` [m] to where they touch these, without a change of their velocities: the
/// nearest point of each wall in turn, a few times.
void pushOutOfMissedWalls(ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies, double allowed);

} // namespace nscd
