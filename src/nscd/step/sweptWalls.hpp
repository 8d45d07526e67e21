// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Outlined walls that fast grains meet within a step: the first on their way, and nothing behind it.
// Tested by tests/unit/nscd/step/sweptWallsTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/movingWalls.hpp"
#include "nscd/search/wallHit.hpp"

namespace nscd
{

/// Where outlined walls are over a step.
struct WallsOfStep
{
    Scene scene;
    const WallSearch& search;
    const MovingWalls& moving;
};

/// The haste of each grain in a list: swept are those that it lets go more than half a radius in a step, relative to walls that move, and whose reach
/// holds an outlined wall. Slower ones are told by their nearest points. Held grains and members of clumps are none.
/// `speed`, `reach`: per grain [m/s], [m]. Empty: none of all grains is in haste.
std::vector<Haste> findHaste
(
    const WallsOfStep& walls, const std::vector<double>& speed, const std::vector<double>& reach, const std::vector<WallReach>& wallReach, double deltaT
);

/// Whether an own body moves by more than half its radius in a step with its present velocity, and the list does not know.
bool isAnyHasty(const ContactList& list, double deltaT);

/// A contact of a grain with a wall that it meets on its way.
struct WallOnWay
{
    WallHit hit;        ///< normal as the wall is now; time as share of the way
    double gap = 0.0;   ///< of the center at the start of the way, along that normal: less the radius it is the contact's [m]
    Vec3 held = Vec3::Zero();  ///< way to the place where it touches, and with the wall on from there [m]
};

/// The first outlined wall that a sphere meets whose center moves from `x` by `way` in the step, through periodic sides too; walls move as chords.
/// Gap: g = distance - R - t n.d, d the way relative to the wall: with it the law lets the grain come to where it touches, as in the chord.
/// `radius`: less than the grain's, so that what glides along a wall meets no edges of its triangles.
WallOnWay firstOnWay(const WallsOfStep& walls, const Vec3& x, const Vec3& way, double radius);

/// Fills the slots of swept bodies: walls that they touch now, then the first on the ways of the bodies' present velocities.
void aimSwept(ContactList& list, const WallsOfStep& walls, double deltaT);

/// Adds the first wall on the way that a solve ended with, which is not met where the law of the others held. Returns whether there is any, on this rank.
bool aimFurther(ContactList& list, const WallsOfStep& walls, double deltaT);

/// A body that stops short on its way.
struct HeldBody
{
    int body;
    double time;    ///< share of the way that it goes
    Vec3 way;       ///< that it goes [m]
};

/// Swept bodies whose way leads through a wall in spite of all, to where they touch it, and own bodies that would run into these. Velocities stay: the next step has
/// the contact.
std::vector<HeldBody> findHeld(const ContactList& list, const WallsOfStep& walls, double deltaT);

} // namespace nscd
