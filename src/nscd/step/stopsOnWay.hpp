// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fast grains whose way leads through an outlined wall stop where they touch it, and those behind them.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/step/groupMotion.hpp"
#include "nscd/step/waysOfStep.hpp"

namespace nscd
{

/// Whether any grain may go further than that share relative to walls before the list is stale; on this rank.
bool areAnyFast(const Grains& grains, const std::vector<double>& reach, const std::vector<WallReach>& wallReach);
/// The same, of some own bodies of a list.
bool areAnyFast(const ContactList& list, const std::vector<int>& bodies);

/// Of each grain: how far away walls of many regions are listed [m]. Grains whose speeds [m/s] take them further than that share in one step see only
/// those nearby, so that a list does not grow with the triangles in their reach; others all in it (infinite). Empty: all grains see all.
/// Planes, and groups of few regions, are seen by all: these make most boxes, and what is listed is met at the right time within the step.
std::vector<double> reachesToMany(const Grains& grains, const WallSearch& search, const std::vector<double>& speed, double deltaT, double reachAtRest);

/// The own bodies that stop in this step, with their present velocities. All ranks together.
std::vector<Stop> findStops(const ContactList& list, const WallsOfStep& walls, double deltaT);

} // namespace nscd
