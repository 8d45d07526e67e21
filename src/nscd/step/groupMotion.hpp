// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Outlined walls over a step: groups that move together, at its start and at its end.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/movingWalls.hpp"
#include "nscd/search/wallSearch.hpp"

namespace nscd
{

/// In a step a grain may get this share of its radius into walls, all the same whether it is slow or fast: less than what takes its center to
/// the other side. The next step has the contact.
constexpr double deepestInWalls = 0.5;

/// Outlined walls over a step, and grains that may run into them.
struct WallsOfStep
{
    Scene scene;
    const WallSearch& search;
    const MovingWalls& moving;
    const std::vector<double>& reachToMany;  ///< as of reachesToMany()
    double tolerance;                        ///< depth of contacts that are no overlap [m]
    double reachAtRest;                      ///< of grains [m]
};

/// A group of outlined walls now and at the end of the step.
struct GroupMotion
{
    int group;
    bool isMoving;
    WallPose now, next;
    double way;           ///< of any of its points [m]
    double wayFromBuild;  ///< since the list was built, to the end of the step [m]

    GroupMotion(const ContactList& list, const WallsOfStep& walls, int number);

    Vec3 before(const Vec3& x) const { return isMoving ? Vec3(now.linear().transpose()*(x - now.translation())) : x; }
    Vec3 after(const Vec3& x) const { return isMoving ? Vec3(next.linear().transpose()*(x - next.translation())) : x; }
    /// Of a vector in the group's frame at the end of the step.
    Vec3 turned(const Vec3& v) const { return isMoving ? Vec3(next.linear()*v) : v; }
};

/// Of all groups with outlined walls.
std::vector<GroupMotion> motionsOf(const ContactList& list, const WallsOfStep& walls);

} // namespace nscd
