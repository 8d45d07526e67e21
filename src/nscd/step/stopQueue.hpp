// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that would run into others which stopped on their way stop behind them.
// Tested by tests/unit/nscd/step/stopsOnWayTest.cpp
#pragma once

#include "nscd/step/waysOfStep.hpp"

namespace nscd
{

/// Adds those own bodies to `stops` whose ways lead through the place of one that stopped earlier in the step, and others behind these.
/// All as seen from the wall that the first one stopped at, which takes them along.
/// Method:   the earliest stop first, as in Dijkstra's shortest paths: who runs into it stops later than it, or at once.
/// Cost:     linear in the number of bodies and the lengths of their ways.
void addQueue(const WaysOfStep& ways, std::vector<Stop>& stops);

} // namespace nscd
