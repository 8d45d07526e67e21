// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A settled bed with periodic sides as one contact problem that can be solved again and again from cold.
#pragma once

#include "benchmark/rankedBed/tiledBed.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/step/contactStep.hpp"

namespace scenes
{

/// Lets a jittered lattice, 1.1 d apart, settle in a viscous medium, and writes it to a file.
inline void settleBed(const std::string& path, int perSide, int layers, int steps, unsigned seed = 1)
{
    const Scene scene = latticeBed(perSide, layers, seed);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, scene.g, deltaT);
    writeBed(path, scene.box, dynamics.grains().position);
}

/// The contact problem of a bed's first step under its weight, in a state no solver has touched.
class FrozenBed
{
public:
    explicit FrozenBed(Scene scene, const char* vectorPath = "auto")
    :
        scene_(std::move(scene)),
        kernels_(nscd::chooseKernels(vectorPath)),
        diameter_(2.0*radius)
    {
        nscd::Exchange alone;
        const nscd::ContactSettings settings;
        const std::vector<double> reach(scene_.grains.size(), 0.5*settings.skin*diameter_ + 2.0*deltaT*deltaT*gravity);
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
            const double noise = sample > 0 ? 0.01*gravity*deltaT : 0.0;
            v = noise*Vec3(unit(random), unit(random), unit(random));
        }
        for (nscd::ContactBlock& block : list_.blocks) std::fill(&block.r[0][0], &block.r[0][0] + 3*nscd::blockLanes, 0.0);
        const nscd::ExternalForces forces = weight(scene_.grains, scene_.g, deltaT);
        nscd::setFreeVelocities(list_, scene_.grains, forces, deltaT, nscd::GrainSleep());
        nscd::prepareSlots(list_, kernels_, deltaT, nscd::ContactSettings().deadBand*diameter_, 1.0);
        return {list_.bodies, list_.blocks, list_.awake, list_.interfaceBlock, list_.halo, kernels_, true, deltaT, forces.speedScale, diameter_,
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
        return sum/(mass*gravity*deltaT);
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
