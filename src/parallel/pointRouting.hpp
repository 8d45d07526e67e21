// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Points to the ranks in whose boxes they lie.
#pragma once

#include "nscd/base/vec3.hpp"
#include "parallel/rankTree.hpp"

#include <array>

namespace nscd
{

/// A point that looks for its place.
struct RoutedPoint
{
    std::array<double, 3> position;  ///< [m]
    int origin;                      ///< the rank that asks
    int index;                       ///< its number there
};

/// The points of all ranks that lie in the box of this rank; a point on several boxes' borders comes to each of them.
/// Cost:     2 to 4 messages per level of the tree, as findGhosts(): boxes go up it, points down it
/// Ensures:  ordered by origin and index; an empty box gets none
std::vector<RoutedPoint> routePoints(const RankTree& tree, const std::vector<Vec3>& points, const Eigen::AlignedBox3d& own);

} // namespace nscd
