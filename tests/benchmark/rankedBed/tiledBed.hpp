// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Beds of spheres with periodic sides for benchmarks: a lattice, or tiles of a settled bed side by side. A rank makes its own
// grains only.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <fstream>
#include <random>
#include <stdexcept>

namespace scenes
{

constexpr double radius = 1.25e-3, density = 2526.0, deltaT = 1e-3, friction = 0.3;

/// A floor under `width` times `depth` [m].
inline Scene emptyBed(double width, double depth)
{
    Scene scene(3, friction, 0.0);
    scene.box.length = Vec3(width, depth, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

/// A jittered lattice of perSide x perSide x layers, 1.1 d apart; another one for each seed.
inline Scene latticeBed(int perSide, int layers, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = 2.2*radius;
    Scene scene = emptyBed(perSide*spacing, perSide*spacing);
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        const Vec3 shake = 0.09*radius*Vec3(unit(random), unit(random), unit(random));
        scene.addGrain(spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake, radius, density);
    }
    return scene;
}

/// A settled bed as a file: the two periods, then a position a line.
inline void writeBed(const std::string& path, const nscd::PeriodicBox& box, const std::vector<Vec3>& positions)
{
    std::ofstream file(path);
    file.precision(17);
    file << box.length[0] << " " << box.length[1] << "\n";
    for (const Vec3& x : positions) file << x.transpose() << "\n";
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path);
}

/// A settled bed that lies side by side with copies of itself.
struct TiledBed
{
    double width = 0.0, depth = 0.0;
    std::vector<Vec3> tile;
    int tilesX = 1, tilesY = 1;

    /// Of a file of writeBed().
    TiledBed(const std::string& path, int tilesX, int tilesY)
    :
        tilesX(tilesX),
        tilesY(tilesY)
    {
        std::ifstream file(path);
        if (!(file >> width >> depth)) throw std::runtime_error("cannot read " + path);
        for (Vec3 x; file >> x[0] >> x[1] >> x[2];) tile.push_back(x);
    }

    std::size_t size() const { return tile.size()*tilesX*tilesY; }

    Scene whole() const { return part(0, size()); }

    /// The bed with the grains first .. last - 1.
    Scene part(std::size_t first, std::size_t last) const
    {
        Scene scene = emptyBed(tilesX*width, tilesY*depth);
        for (std::size_t id = first; id < std::min(last, size()); ++id)
        {
            const std::size_t place = id/tile.size();
            const Vec3 x = tile[id % tile.size()] + Vec3(place % tilesX*width, place/tilesX*depth, 0);
            scene.grains.add(x, radius, density, 0, static_cast<std::int64_t>(id));
        }
        return scene;
    }
};

} // namespace scenes
