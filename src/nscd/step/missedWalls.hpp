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

/// A body at a wall that the list lacks: as for a contact of the list, without a law.
struct WallGap
{
    int body;
    Vec3 normal;    ///< unit, from the wall to the body
    double gap;     ///< [m], below 0 where it is in the wall
};

/// Those of bodies that are nearer to outlined walls than half their radius at the end of the step: of each body the nearest wall, and others whose
/// face is nearest to it, not their edge.
std::vector<WallGap> gapsToMissedWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies);

/// Of the deepest one [m]; 0 where none is in a wall.
double deepestOf(const std::vector<WallGap>& gaps);

} // namespace nscd
