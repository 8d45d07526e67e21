// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Who should own each grain: recursive coordinate bisection on weights.
#pragma once

#include "nscd/base/vec3.hpp"
#include "parallel/rankTree.hpp"

namespace nscd
{

/// The rank that should own each of this rank's grains, so that ranks have equal weights and compact shares.
/// Equation: in each group of ranks, the longest axis of its grains' box is cut where the weight below comes nearest to
///           W nLow/n (Berger & Bokhari 1987); W the group's weight, n its ranks, nLow those of the low half, which get x < cut
/// Shapes:   position, weight [own grains], weight >= 0 in any unit; ranks without grains, and fewer grains than ranks, are fine
/// Cost:     per level of the tree at most 15 reductions of up to 32 numbers, and 1 or 2 messages with (position, weight, home) of
///           the grains that change the half; then one message per rank concerned and a barrier
/// Errors:   std::invalid_argument for a weight that is negative or not finite, a position that is not, or unequal lengths
/// Ensures:  a cut misses its share by half of one grain's weight, a rank by less than 1.5 weights (less than 1 up to 8 ranks),
///           unless grains share the coordinate of a cut: they stay on one side. The same result for the same grains and owners
std::vector<int> partitionGrains(const RankTree& tree, const std::vector<Vec3>& position, const std::vector<double>& weight);

/// Largest over mean load of all ranks; 1 where there is none.
double imbalance(const Communicator& all, double load);

} // namespace nscd
