// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fast grains whose way leads through an outlined wall stop where they touch it, and those behind them.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/movingWalls.hpp"
#include "nscd/search/wallSearch.hpp"
#include "nscd/step/waysOfStep.hpp"

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

/// Whether any grain may go further than that share relative to walls before the list is stale; on this rank.
bool areAnyFast(const Grains& grains, const std::vector<double>& reach, const std::vector<WallReach>& wallReach);

/// Of each grain: how far away walls of many regions are listed [m]. Grains whose speeds [m/s] take them further than that share in one step see only
/// those nearby, so that a list does not grow with the triangles in their reach; others all in it (infinite). Empty: all grains see all.
/// Planes, and groups of few regions, are seen by all: these make most boxes, and what is listed is met at the right time within the step.
std::vector<double> reachesToMany(const Grains& grains, const WallSearch& search, const std::vector<double>& speed, double deltaT, double reachAtRest);

/// The own bodies that stop in this step, with their present velocities. All ranks together.
std::vector<Stop> findStops(const ContactList& list, const WallsOfStep& walls, double deltaT);

/// Whether a grain that sees only near walls has come to some that the list may not have.
bool areWallsMissed(const ContactList& list, const WallsOfStep& walls);

} // namespace nscd
