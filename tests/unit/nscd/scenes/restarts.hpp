// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Runs that go on from a checkpoint, beside the one that wrote it.
#pragma once

#include "unit/nscd/scenes/sceneHash.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

namespace scenes
{

/// What a checkpoint holds.
struct Stored
{
    explicit Stored(nscd::GrainDynamics& from) : impulses(from.checkpoint(deltaT)), grains(from.grains()), time(from.time()) {}

    double deltaT = 0.0;
    std::vector<nscd::StoredImpulse> impulses;
    nscd::Grains grains;
    double time;
};

/// The scene at the checkpoint.
inline Scene at(const Stored& stored, Scene scene)
{
    scene.grains = stored.grains;
    return scene;
}

/// Goes on with a library, and with another one from its checkpoint, and expects the same of both to the bit.
inline void expectSameAfterRestart(nscd::GrainDynamics& dynamics, const Scene& scene, double deltaT, int steps)
{
    const Stored stored(dynamics);
    EXPECT_EQ(stored.deltaT, deltaT);
    auto other = at(stored, scene).build(nscd::ContactSettings());
    other.setTime(stored.time);
    other.restore(stored.impulses, stored.deltaT);
    EXPECT_EQ(hash(other.grains()), hash(dynamics.grains()));
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport expected = step(dynamics, scene.g, deltaT);
        const nscd::StepReport report = step(other, scene.g, deltaT);
        ASSERT_EQ(report.solve.sweeps, expected.solve.sweeps) << "step " << k;
        ASSERT_EQ(hash(other.grains()), hash(dynamics.grains())) << "step " << k;
        ASSERT_EQ(other.wallForce(), dynamics.wallForce()) << "step " << k;
        ASSERT_EQ(other.wallTorque(), dynamics.wallTorque()) << "step " << k;
    }
}

} // namespace scenes
