// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which grains of other ranks could touch one of this rank.
#pragma once

#include "nscd/scene/exchange.hpp"
#include "parallel/rankTree.hpp"

namespace nscd
{

/// Grains of other ranks whose sphere of radius + reach meets, in a periodic image perhaps, the box around this rank's spheres.
/// Equation: sum over axes of (smallest gap of an image's center to the box)^2 <= (radius + reach)^2
/// Shapes:   reach [owned.nOwned] [m]
/// Cost:     2 to 4 messages per level of the tree. Boxes go up it, half by half; grains go down it, each to one rank of a half
///           whose box it meets, so that it comes at most once
/// Errors:   std::invalid_argument where `reach` has not one value for each grain owned
/// Ensures:  sorted by owner and index, positions wrapped into the periodic box; none of this rank's own
std::vector<GhostGrain> findGhosts
(
    const RankTree& tree, const Grains& owned, const std::vector<double>& reach, const PeriodicBox& box
);

} // namespace nscd
