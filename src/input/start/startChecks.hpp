// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What no run can start from.
#pragma once

#include "input/scene/scene.hpp"

#include "nscd/search/overlaps.hpp"

namespace input
{

/// Materials that grains are made of, those that are to enter included.
std::vector<int> usedMaterials(const Scene& scene, const nscd::Grains& grains);

/// The largest of the grains and of those that are to enter [m]; 0 where there are none.
double largestDiameter(const Scene& scene, const nscd::Grains& grains);

/// Refuses periods that are not longer than a grain, with the place that speaks of periods.
void checkPeriods(const nscd::PeriodicBox& box, double largestDiameter, const Place& place);

struct DescribedOverlap
{
    double share;        ///< depth over the diameter of the smaller body
    std::string text;    ///< as "grains 3 and 7 overlap by 0.2 at (0 0 1)"
};

/// The worst few of some overlaps, the worst first.
std::vector<DescribedOverlap> worstOverlaps(std::vector<nscd::Overlap> overlaps, const nscd::Grains& grains, const nscd::Walls& walls);

/// Refuses overlaps of more than `maxShare` with their number and the worst of them; does nothing where there are none.
void refuseOverlaps(std::size_t number, std::vector<DescribedOverlap> worst, const Scene& scene, double maxShare);

/// Overlaps of more than `maxShare` with other grains and with walls, and grains of one center.
std::vector<nscd::Overlap> findOverlaps(const nscd::Grains& grains, const nscd::PeriodicBox& box, const nscd::Walls& walls, double maxShare);

/// Largest share that a restart may find: a run leaves less behind, more comes of walls and files that were changed since. A larger
/// maxInitialOverlap counts, so that everything can be gone on with.
double maxOverlapOfRestart(const Scene& scene);

} // namespace input
