// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checking grains before the first step.
#include "input/start/startChecks.hpp"

#include <algorithm>
#include <set>

namespace input
{

namespace
{

constexpr std::size_t nShown = 5;
constexpr double largestOverlapOfRun = 0.1;   // in diameters of the smaller body

std::string inWords(const nscd::Overlap& overlap, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const std::string at = " at " + describe(grains.position[overlap.grain]);
    const std::int64_t id = grains.id[overlap.grain];
    if (overlap.partner < 0)
    {
        const std::string& wall = walls.patches[walls.regions[-1 - overlap.partner].patch].name;
        return textOf("grain ", id, " and the wall ", wall, " overlap by ", overlap.share, at);
    }
    const std::int64_t other = grains.id[overlap.partner];
    if (overlap.isCoincident) return textOf("grains ", id, " and ", other, " have the same center", at);
    return textOf("grains ", id, " and ", other, " overlap by ", overlap.share, at);
}

} // namespace

std::vector<int> usedMaterials(const Scene& scene, const nscd::Grains& grains)
{
    std::set<int> used(grains.material.begin(), grains.material.end());
    for (const nscd::EntrySource& entry : scene.entries) used.insert(entry.material);
    return {used.begin(), used.end()};
}

double largestDiameter(const Scene& scene, const nscd::Grains& grains)
{
    double diameter = 0.0;
    for (const double radius : grains.radius) diameter = std::max(diameter, 2*radius);
    for (const nscd::EntrySource& entry : scene.entries) diameter = std::max(diameter, entry.sizes.largest);
    return diameter;
}

void checkPeriods(const nscd::PeriodicBox& box, double largestDiameter, const Place& place)
{
    for (int k = 0; k < 3; ++k)
    {
        if (!box.isPeriodic(k) || box.length[k] > largestDiameter) continue;
        const std::string value = textOf(box.length[k], " along ", "xyz"[k]);
        throw InputError({place, "makes a period shorter than a grain", value, textOf("more than the largest diameter, ", largestDiameter)});
    }
}

std::vector<nscd::Overlap> findOverlaps(const nscd::Grains& grains, const nscd::PeriodicBox& box, const nscd::Walls& walls, double maxShare)
{
    std::vector<nscd::Overlap> overlaps = nscd::grainOverlaps(grains, box, maxShare);
    const std::vector<nscd::Overlap> withWalls = nscd::wallOverlaps(grains, walls, maxShare);
    overlaps.insert(overlaps.end(), withWalls.begin(), withWalls.end());
    return overlaps;
}

std::vector<DescribedOverlap> worstOverlaps(std::vector<nscd::Overlap> overlaps, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const std::size_t shown = std::min(nShown, overlaps.size());
    const auto isWorse = [](const nscd::Overlap& a, const nscd::Overlap& b) { return a.share > b.share; };
    std::partial_sort(overlaps.begin(), overlaps.begin() + static_cast<std::ptrdiff_t>(shown), overlaps.end(), isWorse);
    std::vector<DescribedOverlap> worst;
    for (std::size_t k = 0; k < shown; ++k) worst.push_back({overlaps[k].share, inWords(overlaps[k], grains, walls)});
    return worst;
}

void refuseOverlaps(std::size_t number, std::vector<DescribedOverlap> worst, const Scene& scene, double maxShare)
{
    if (number == 0) return;
    const auto isWorse = [](const DescribedOverlap& a, const DescribedOverlap& b) { return a.share > b.share; };
    std::stable_sort(worst.begin(), worst.end(), isWorse);
    std::string list;
    for (std::size_t k = 0; k < std::min(nShown, worst.size()); ++k) list += (k ? "; " : "") + worst[k].text;
    if (number > nShown) list += "; ...";
    const std::string allowed = textOf("overlaps up to ", maxShare, " of the smaller diameter, distinct centers");
    const char* const orMore = number < nscd::mostOverlaps ? "" : "at least ";
    throw InputError({scene.overlapPlace, textOf("is exceeded by ", orMore, number, " pairs"), list, allowed});
}

double maxOverlapOfRestart(const Scene& scene) { return std::max(scene.maxInitialOverlap, largestOverlapOfRun); }

} // namespace input
