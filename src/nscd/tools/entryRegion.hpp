// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where grains may enter, as any program can say it: places drawn at random, the same on all ranks.
// Tested by tests/unit/nscd/tools/grainEntryTest.cpp, tests/foam/program/meshEntryTest.C
#pragma once

#include "nscd/tools/regions.hpp"

namespace nscd
{

/// A place that a source tries, and the part of its region that it was drawn in, for regions that are made of parts.
struct EntryTry
{
    Vec3 position;            ///< [m]
    std::size_t part = 0;
};

/// Where a source tries to put the centers of its grains. A program that knows more of space than Region does fills in the functions.
struct EntryRegion
{
    EntryRegion() = default;
    /// Uniform over a region.
    EntryRegion(const Region& region);

    Eigen::AlignedBox3d bounds;   ///< around all places [m]

    /// Before places of a step are drawn; false: there are none now, and grains wait. The same on all ranks; collective.
    std::function<bool()> begin = [] { return true; };

    /// The same on all ranks for the same random numbers.
    std::function<EntryTry(const RandomNumbers&)> draw;

    /// Whether a place that was drawn lies in the region, as far as this rank knows; one that no rank knows is no place.
    std::function<bool(const EntryTry&)> holds = [](const EntryTry&) { return true; };
};

} // namespace nscd
