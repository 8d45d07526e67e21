// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlaps of grains with each other and with walls, found in linear time.
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/scene/grains.hpp"
#include "nscd/scene/walls.hpp"

#include <vector>

namespace nscd
{

/// Two bodies that interpenetrate.
struct Overlap
{
    std::size_t grain;
    long partner;        ///< index of the other grain, or -1 - index of a wall region
    double share;        ///< depth over the diameter of the smaller body
    bool isCoincident;   ///< centers of two grains in one point
};

/// When as many are found the search ends: grains everywhere in one another may have more overlaps than memory holds.
constexpr std::size_t mostOverlaps = 100000;

/// Overlaps between grains of more than `maxShare`, and coincident centers; all of them where they are fewer than mostOverlaps.
std::vector<Overlap> grainOverlaps(const Grains& grains, const PeriodicBox& box, double maxShare);

/// Overlaps of more than `maxShare` between grains whose centers lie in the domain and walls; likewise.
std::vector<Overlap> wallOverlaps(const Grains& grains, const Walls& walls, double maxShare);

} // namespace nscd
