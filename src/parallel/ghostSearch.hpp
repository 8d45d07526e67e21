// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which grains of other ranks could touch one of this rank.
#pragma once

#include "nscd/scene/exchange.hpp"
#include "parallel/halfBoxes.hpp"
#include "parallel/rankTree.hpp"

namespace nscd
{

/// Boxes around the spheres of ranks, as findGhosts() has them.
class CoveredBoxes
{
public:
    /// No other ranks.
    CoveredBoxes() = default;

    CoveredBoxes(std::vector<HalfBoxes> halves, const PeriodicBox& box) : halves_(std::move(halves)), box_(box) {}

    /// Whether a sphere around a place in the periodic box lies in the box around this rank's spheres, and meets no box around those of other ranks.
    bool isOfThisRankAlone(const Vec3& center, double size) const;

private:
    std::vector<HalfBoxes> halves_;
    PeriodicBox box_;
};

/// Grains of other ranks whose sphere meets, in a periodic image perhaps, the box around this rank's spheres. A sphere lies around the middle of
/// a path, with size = radius + range + slack + |path - meanPath|/2: see searchSpheres().
/// Equation: sum over axes of (smallest gap of an image's center to the box)^2 <= size^2
/// Shapes:   slack [owned.nOwned], path the same or empty [m]
/// Cost:     2 to 4 messages per level of the tree. Boxes go up it, half by half; grains go down it, each to one rank of a half
///           whose box it meets, so that it comes at most once
/// Errors:   std::invalid_argument where there is not one slack for each grain owned, or paths and not one for each
/// Ensures:  `covered` has the boxes around the spheres of all ranks; ghosts sorted by owner and index, positions wrapped into the periodic box; none of this rank's own
std::vector<GhostGrain> findGhosts
(
    const RankTree& tree, const Grains& owned, const GrainPaths& paths, const PeriodicBox& box, CoveredBoxes& covered
);

} // namespace nscd
