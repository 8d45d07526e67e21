// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that every rank knows, so that each can judge by brute force what its library told it.
#pragma once

#include "nscd/scene/exchange.hpp"
#include "parallel/communicator.hpp"

#include <random>
#include <string>

namespace nscd
{

/// All grains of a scene, and who owns which.
struct SharedScene
{
    Grains all;
    std::vector<double> reach;
    std::vector<Vec3> path;   ///< empty: none
    Vec3 meanPath = Vec3::Zero();
    double range = 0.0;
    std::vector<int> owner;
    PeriodicBox box;

    /// Grains of a rank, by their index in `all`.
    std::vector<int> of(int rank) const
    {
        std::vector<int> members;
        for (std::size_t i = 0; i < owner.size(); ++i)
        {
            if (owner[i] == rank) members.push_back(static_cast<int>(i));
        }
        return members;
    }

    Grains grainsOf(int rank) const
    {
        Grains grains;
        for (int i : of(rank))
        {
            grains.add(all.position[i], all.radius[i], 2500.0, all.material[i], all.id[i]);
            const std::size_t last = grains.size() - 1;
            grains.velocity[last] = all.velocity[i];
            grains.omega[last] = all.omega[i];
            grains.orientation[last] = all.orientation[i];
            grains.isFixed[last] = all.isFixed[i];
        }
        return grains;
    }

    GrainPaths pathsOf(int rank) const
    {
        GrainPaths part;
        for (int i : of(rank))
        {
            part.slack.push_back(reach[i]);
            if (!path.empty()) part.path.push_back(path[i]);
        }
        part.meanPath = meanPath;
        part.range = range;
        return part;
    }
};

enum class Ownership { slabs, scattered, evenRanks, lastRank };

inline int ownerOf(Ownership ownership, double x, int anything, int size)
{
    switch (ownership)
    {
        case Ownership::slabs: return std::min(size - 1, std::max(0, static_cast<int>(x*size)));
        case Ownership::scattered: return anything % size;
        case Ownership::evenRanks: return anything % size / 2 * 2;
        default: return size - 1;
    }
}

/// Polydisperse grains at random in a unit cube, some outside of it along periodic axes; reach differs by grain.
inline SharedScene randomScene(int count, int periodicAxes, Ownership ownership, int size, unsigned seed = 1)
{
    std::mt19937 random(seed);
    const auto uniform = [&](double from, double to) { return from + (to - from)*(random()/4294967296.0); };
    SharedScene scene;
    for (int k = 0; k < periodicAxes; ++k) scene.box.length[k] = 1.0;
    for (int i = 0; i < count; ++i)
    {
        Vec3 x(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        scene.owner.push_back(ownerOf(ownership, x[0], static_cast<int>(random() % 1000), size));
        for (int k = 0; k < periodicAxes; ++k) x[k] += i % 10 == k ? 1.0 : 0.0;
        scene.all.add(x, i % 50 == 0 ? 0.1 : uniform(0.01, 0.03), 2500.0, i % 3, 1000 + 7*i);
        scene.all.velocity[i] = Vec3(uniform(-1, 1), i, -i);
        scene.all.omega[i] = Vec3(-i, uniform(-1, 1), i);
        scene.all.orientation[i] = Quaternion(1.0, uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
        scene.all.isFixed[i] = i % 11 == 0;
        scene.reach.push_back(uniform(0.0, 0.01));
    }
    return scene;
}

} // namespace nscd
