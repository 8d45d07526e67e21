// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The scenes that peers run too: a settled bed with periodic sides, the same between two walls, and after one of these is taken away.
#pragma once

#include "benchmark/rankedBed/tiledBed.hpp"

#include "nscd/search/overlaps.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"

#include <algorithm>
#include <stdexcept>

namespace scenes
{

/// Floor, walls and periods by name; no grains. bed: periodic along x and y. box: walls across x in place of the period there, a radius
/// outside so that they hold the bed's grains as they lie. collapse: the box without its wall at the far end.
inline Scene columnScene(const std::string& kind, double width, double depth, double restitution = 0.0)
{
    if (kind != "bed" && kind != "box" && kind != "collapse") throw std::invalid_argument("scene is bed, box or collapse, not " + kind);
    Scene scene = emptyBed(width, depth);
    for (int a = 0; a < 2; ++a) scene.materials.setPair(0, a, {friction, restitution});
    if (kind == "bed") return scene;
    scene.box.length[0] = 0.0;
    scene.addPlane(Vec3(-radius, 0, 0), Vec3::UnitX());
    if (kind == "box") scene.addPlane(Vec3(width + radius, 0, 0), -Vec3::UnitX());
    return scene;
}

inline double wrapped(double x, double period) { return x - period*std::floor(x/period); }

/// The scene with the grains of a file of `rankedBed settle`, each inside the periods.
inline Scene columnOfBed(const std::string& kind, const TiledBed& bed)
{
    Scene scene = columnScene(kind, bed.width, bed.depth);
    for (const Vec3& x : bed.tile) scene.addGrain(Vec3(wrapped(x[0], bed.width), wrapped(x[1], bed.depth), x[2]), radius, density);
    return scene;
}

/// What is compared of a state of any program.
struct ColumnFigures
{
    double overlapMax = 0.0;   ///< of pairs and of grains with walls, in d
    double overlapMean = 0.0;  ///< over those that overlap, in d
    Vec3 massCenter = Vec3::Zero();
    double runOut99 = 0.0;     ///< place along x that 99 % of the grains' centers are behind [m]
    double runOut90 = 0.0;
};

inline double quantile(std::vector<double>& values, double share)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share*static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

inline ColumnFigures columnFigures(const Scene& scene, const nscd::Grains& grains)
{
    ColumnFigures figures;
    std::vector<nscd::Overlap> overlaps = nscd::grainOverlaps(grains, scene.box, 0.0);
    for (const nscd::Overlap& overlap : nscd::wallOverlaps(grains, scene.walls, 0.0)) overlaps.push_back(overlap);
    for (const nscd::Overlap& overlap : overlaps)
    {
        figures.overlapMax = std::max(figures.overlapMax, overlap.share);
        figures.overlapMean += overlap.share/static_cast<double>(overlaps.size());
    }
    figures.massCenter = nscd::massCenter(grains);
    std::vector<double> x;
    for (const Vec3& position : grains.position) x.push_back(position[0]);
    figures.runOut99 = quantile(x, 0.99);
    figures.runOut90 = quantile(x, 0.90);
    return figures;
}

} // namespace scenes
