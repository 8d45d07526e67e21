// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where a sphere that moves on a straight way first runs into an outlined wall region.
// Tested by tests/unit/nscd/search/wallHitTest.cpp
#pragma once

#include "nscd/search/wallSearch.hpp"

namespace nscd
{

/// A straight way of a sphere's center: x + t d, t from 0 to 1.
struct Way
{
    Vec3 start;              ///< [m]
    Vec3 displacement;       ///< [m]
    double radius;           ///< [m]
    double allowance = 0.0;  ///< what leads no deeper than this into a piece of a wall runs into nothing [m]
};

/// The first place on a way at which a sphere touches a wall that it then goes too deep into.
struct WallHit
{
    double time = 2.0;              ///< share of the way; above 1: none
    int region = -1;
    Vec3 normal = Vec3::Zero();     ///< unit, from the wall to the center
    double distance = 0.0;          ///< from the center to the wall there: the radius, less where they overlap from the start [m]

    bool isAny() const { return region >= 0; }
};

/// Changes `first` to the place where a way runs into a region, if that comes earlier.
/// Equation: the center enters the region swollen by the radius, which is the prism over its outline and a capsule around each edge: at time t, with
///           normal n. Distances to convex pieces are convex along a way, so it gets no deeper into this one than radius - distance - (1 - t) n.d:
///           not more than the allowance is no hit. A region of two sides is met on the side that the start is on, one of one side from its
///           front; from half a radius behind the plane on it is not there.
void meet(const WallRegion& region, int number, const Way& way, WallHit& first);

/// The first of a group's outlined regions on a way, in the group's frame. Regions whose normal lies along `emptyAxis` are left out; -1: none.
/// Cost: a look-up for each stretch as long as a grid cell, within the group's bounds and up to the hit.
WallHit firstHit(const Walls& walls, const WallSearch& search, int group, const Way& way, int emptyAxis);

/// Whether a region's normal lies along an axis that a scene in the plane does not have; -1: it has all.
bool liesAlong(const WallRegion& region, int axis);

/// The time at which a point x + t d comes to within a radius of the origin; 2 where it does not, or starts there.
double timeToOrigin(const Vec3& x, const Vec3& d, double radius);

} // namespace nscd
