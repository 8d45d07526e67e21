// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Restart and reproducibility: the same to the bit, impulses included.
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/restarts.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

Scene collapse()
{
    Scene scene = heap(3, 5, 8, 0.01, 0.7, 0.4);
    scene.g = gravity*Vec3(0.5, 0.1, -0.86).normalized();
    return scene;
}

} // namespace

TEST(Restart, twoRunsAreTheSameToTheBit)
{
    const Scene scene = collapse();
    std::uint64_t first = 0;
    for (int run = 0; run < 2; ++run)
    {
        auto dynamics = scene.build(nscd::ContactSettings());
        for (int k = 0; k < 120; ++k)
        {
            // Sub-steps of different length.
            step(dynamics, scene.g, deltaT*(k % 3 == 0 ? 0.4 : 0.6));
        }
        if (run == 0) first = hash(dynamics.grains());
        else EXPECT_EQ(hash(dynamics.grains()), first);
    }
}

TEST(Restart, continuesInTheMiddleOfACollapse)
{
    const Scene scene = collapse();
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 90; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_GT(nscd::kineticEnergy(dynamics.grains()), 1e-3*gravity*0.01*dynamics.grains().mass[0]);

    EXPECT_GT(dynamics.contacts().size(), 150u);
    expectSameAfterRestart(dynamics, scene, deltaT, 60);
}

/// Against a run that nobody interrupted, not even by writing: the order of contacts differs, the answer does not.
TEST(Restart, aBedAtRestStaysAtRest)
{
    const Scene scene = heap(3, 4, 5, 0.01, 0.7, 0.4);
    nscd::ContactSettings settings;
    settings.sleep = false;   // a restart wakes all
    auto uninterrupted = scene.build(settings);
    auto stopped = scene.build(settings);
    // With more drag a grain that rocks is only kept from getting to the bottom of its hollow.
    for (int k = 0; k < 3300; ++k)
    {
        for (nscd::GrainDynamics* dynamics : {&uninterrupted, &stopped})
        {
            if (k > 300 && k < 3200) stepDamped(*dynamics, scene.g, deltaT, 10.0);
            else step(*dynamics, scene.g, deltaT);
        }
    }
    for (const Vec3& v : uninterrupted.grains().velocity) ASSERT_LT(v.norm(), 1e-6*gravity*deltaT);
    const Stored stored(stopped);
    auto with = at(stored, scene).build(settings);
    auto without = at(stored, scene).build(settings);
    with.restore(stored.impulses, stored.deltaT);
    const int expected = step(uninterrupted, scene.g, deltaT).solve.sweeps;
    EXPECT_NEAR(step(with, scene.g, deltaT).solve.sweeps, expected, 2);
    EXPECT_GT(step(without, scene.g, deltaT).solve.sweeps, 5*expected);
}

TEST(Restart, impulsesScaleWithTheTimeStep)
{
    // A resting stack: impulses of the new step are those of the old one times dt_new/dt_old, so a sweep or two find nothing to do.
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.polishSweeps = 0;
    settings.tolerance = settings.displacementTolerance = 1e-6;
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 200; ++k) step(dynamics, scene.g, deltaT);
    for (double factor : {0.1, 3.0, 1.0}) EXPECT_LE(step(dynamics, scene.g, factor*deltaT).solve.sweeps, 2) << factor;
}

TEST(Restart, grainsRemovedTakeTheirImpulsesAlong)
{
    const Scene scene = collapse();
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 100; ++k) step(dynamics, scene.g, deltaT);
    const nscd::Grains all = dynamics.grains();
    nscd::Grains remaining;
    remaining.shape = all.shape;
    for (std::size_t i = all.size(); i-- > 0;)
    {
        if (i % 40 == 7) continue;
        remaining.add(all.position[i], all.radius[i], 2500.0, 0, all.id[i]);
        remaining.velocity.back() = all.velocity[i];
        remaining.omega.back() = all.omega[i];
    }
    dynamics.setGrains(remaining);
    EXPECT_EQ(dynamics.grains().size(), 195u);
    for (int k = 0; k < 20; ++k) EXPECT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
}
