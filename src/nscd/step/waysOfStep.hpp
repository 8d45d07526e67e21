// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways of bodies within a step, as walls see them, and where they touch others.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// A body that stops on its way, and keeps its velocity.
struct Stop
{
    int body;
    double time;    ///< share of the step after which it does not go on
    Vec3 way;       ///< to where it is at the end of the step [m]
    int wall;       ///< group of walls that takes it along from then on, its own or that of the body that it stopped behind
};

/// What moves with a wall over a step, where things are at the step's start.
struct StepFrame
{
    bool isMoving = false;
    WallPose forth = WallPose::Identity(), back = WallPose::Identity();

    /// A way of a body at x as the wall sees it, and back [m].
    Vec3 seen(const Vec3& x, const Vec3& way) const { return isMoving ? Vec3(back*(x + way) - x) : way; }
    Vec3 unseen(const Vec3& x, const Vec3& way) const { return isMoving ? Vec3(forth*(x + way) - x) : way; }
};

/// What queues are made of.
struct WaysOfStep
{
    const ContactList& list;
    const PeriodicBox& box;
    const std::vector<StepFrame>& frames;   ///< of each group of walls
    double deltaT;
    double tolerance;                       ///< overlap that is none [m]

    Vec3 start(int body) const { return box.wrap(list.position[body]); }
};

/// Two bodies that are no nearer than touching, to within a tolerance.
struct Touch
{
    double radii;
    double margin;   ///< as along walls: what touches to within the tolerance of contacts may pass

    Touch(const ContactList& list, int a, int b, double tolerance)
    :
        radii(list.radius[a] + list.radius[b]),
        margin(std::min(tolerance, 0.1*std::min(list.radius[a], list.radius[b])))
    {}
};

/// No time of a step.
constexpr double never = 2.0;

/// The time between `from` and `to`, shares of the step, at which a body that goes on by `way` a step has to stop, since it touches one that
/// is where it starts are seen from; never, if not. `start`: where it is at `from`.
double timeOfTouch(const Vec3& start, const Vec3& way, double from, double to, const Touch& touch);

/// Whether a body moves by itself: neither held nor a member of a general body.
bool fliesAlone(const ContactList& list, int body);

} // namespace nscd
