// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The boxes of the tree of ranks: what they hold is found by going down it.
#pragma once

#include "parallel/rankTree.hpp"

#include <Eigen/Geometry>

namespace nscd
{

/// The boxes of a group's halves, this rank's and the other.
struct HalfBoxes
{
    Eigen::AlignedBox3d own, other;
};

/// Of each level of the tree, from the box of each rank. Collective.
/// Cost: one or two messages per level
std::vector<HalfBoxes> boxesOfHalves(const RankTree& tree, Eigen::AlignedBox3d own);

} // namespace nscd
