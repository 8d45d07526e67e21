// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A settled bed with periodic sides as one contact problem that can be solved again and again from cold.
#pragma once

#include "../../unit/nscd/heaps.hpp"

#include "contactSolver.hpp"
#include "contactStep.hpp"
#include "sweepKernels.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

namespace scenes
{

constexpr double bedRadius = 1.25e-3, bedDensity = 2526.0, bedDeltaT = 1e-3, bedFriction = 0.3;

/// A floor under a periodic bed of the given width and depth [m].
inline Scene emptyPeriodicBed(double width, double depth)
{
    Scene scene(3, bedFriction, 0.0);
    scene.box.length = Vec3(width, depth, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

/// The bed in a file of `rankedBed settle` or `coldSolve settle`: the two periods, then a position a line; `tiles` times `tiles` of it.
inline Scene readBed(const std::string& path, int tiles = 1)
{
    std::ifstream file(path);
    double width, depth;
    if (!(file >> width >> depth)) throw std::runtime_error("cannot read " + path);
    Scene scene = emptyPeriodicBed(tiles*width, tiles*depth);
    for (Vec3 x; file >> x[0] >> x[1] >> x[2];)
    {
        for (int tile = 0; tile < tiles*tiles; ++tile)
        {
            scene.addGrain(x + Vec3((tile % tiles)*width, (tile/tiles)*depth, 0.0), bedRadius, bedDensity);
        }
    }
    return scene;
}

/// Adds a jittered lattice, 1.1 d apart.
inline void addLattice(Scene& scene, int perSide, int layers)
{
    const double spacing = 2.2*bedRadius;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        const Vec3 shake = 0.09*bedRadius*Vec3(unit(random), unit(random), unit(random));
        scene.addGrain(spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake, bedRadius, bedDensity);
    }
}

/// Lets a lattice settle in a viscous medium, and writes it to a file.
inline void settleBed(const std::string& path, int perSide, int layers, int steps)
{
    Scene scene = emptyPeriodicBed(2.2*bedRadius*perSide, 2.2*bedRadius*perSide);
    addLattice(scene, perSide, layers);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, scene.g, bedDeltaT);
    std::ofstream file(path);
    file.precision(17);
    file << scene.box.length[0] << " " << scene.box.length[1] << "\n";
    for (const Vec3& x : dynamics.grains().position) file << x.transpose() << "\n";
}

/// The contact problem of a bed's first step under its weight, in a state no solver has touched.
class FrozenBed
{
public:
    explicit FrozenBed(Scene scene, const char* vectorPath = "auto")
    :
        scene_(std::move(scene)),
        kernels_(nscd::chooseKernels(vectorPath)),
        diameter_(2.0*bedRadius)
    {
        nscd::Exchange alone;
        const nscd::ContactSettings settings;
        const std::vector<double> reach(scene_.grains.size(), 0.5*settings.skin*diameter_ + 2.0*bedDeltaT*bedDeltaT*gravity);
        list_ = nscd::buildContactList(view(), nscd::WallSearch(scene_.walls, diameter_), reach, {}, diameter_, alone);
        nscd::updateGeometry(list_, view());
    }

    /// Starts over: no impulses, free velocities. `sample` > 0 adds to the velocities noise of a hundredth of g dt, another one for
    /// each sample, as an earlier step solved to 1e-2 leaves it.
    nscd::ContactProblem start(int sample)
    {
        std::mt19937 random(static_cast<unsigned>(sample));
        std::uniform_real_distribution<double> unit(-1, 1);
        for (Vec3& v : scene_.grains.velocity)
        {
            const double noise = sample > 0 ? 0.01*gravity*bedDeltaT : 0.0;
            v = noise*Vec3(unit(random), unit(random), unit(random));
        }
        for (nscd::ContactBlock& block : list_.blocks) std::fill(&block.r[0][0], &block.r[0][0] + 3*nscd::blockLanes, 0.0);
        const nscd::ExternalForces forces = weight(scene_.grains, scene_.g, bedDeltaT);
        nscd::setFreeVelocities(list_, scene_.grains, forces, bedDeltaT, nscd::IslandSleep());
        nscd::prepareSlots(list_, kernels_, bedDeltaT, nscd::ContactSettings().deadBand*diameter_, 1.0);
        return {list_.bodies, list_.blocks, list_.awake, list_.interfaceBlock, list_.halo, kernels_, true, bedDeltaT, forces.speedScale, diameter_,
                list_.position};
    }

    std::size_t grains() const { return scene_.grains.size(); }

    /// Impulse on the floor as the solve left it, of the weight's.
    double baseForce() const
    {
        double sum = 0.0;
        for (std::size_t slot = 0; slot < list_.slots(); ++slot)
        {
            if (list_.isUsed(slot) && list_.wall[slot] >= 0) sum += nscd::impulse(list_, slot)[2];
        }
        double mass = 0.0;
        for (double m : scene_.grains.mass) mass += m;
        return sum/(mass*gravity*bedDeltaT);
    }
    const nscd::ContactList& list() const { return list_; }

private:
    nscd::Scene view() const { return {scene_.grains, scene_.materials, scene_.walls, scene_.box}; }

    Scene scene_;
    nscd::SweepKernels kernels_;
    double diameter_;
    nscd::ContactList list_;
};

} // namespace scenes
