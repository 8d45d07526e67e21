// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A heap at the default settings comes to rest and stays: no creep, few sweeps, no overlap to correct.
#include "unit/nscd/scenes/heaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

void expectRest(const Scene& scene)
{
    nscd::ContactSettings settings;
    settings.sleep = false;  // what is asleep shows nothing of the solver
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 500; ++k) step(dynamics, scene.g, deltaT);
    // Grains rock in their hollows, one that was followed once a second: more drag only keeps them from getting to the bottom.
    for (int k = 0; k < 4000; ++k) stepDamped(dynamics, scene.g, deltaT, 10.0);
    for (int k = 0; k < 200; ++k) step(dynamics, scene.g, deltaT);

    const nscd::Grains before = dynamics.grains();
    int sweeps = 0;
    for (int k = 0; k < 200; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        sweeps += report.solve.sweeps;
        ASSERT_TRUE(report.solve.converged);
        ASSERT_EQ(report.correctionSweeps, 0) << "step " << k;
        ASSERT_FALSE(report.listRebuilt) << "step " << k;
    }
    EXPECT_LE(sweeps, 3*200);
    std::size_t moved = 0;
    std::vector<double> energy;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        moved += (dynamics.grains().position[i] - before.position[i]).norm() > 1e-5*2*radius;
        energy.push_back(0.5*before.mass[i]*dynamics.grains().velocity[i].squaredNorm());
    }
    EXPECT_EQ(moved, 0u);
    EXPECT_LT(*std::max_element(energy.begin(), energy.end()), 1e-9*before.mass[0]*gravity*2*radius);

    Vec3 base = Vec3::Zero();
    for (const Vec3& force : dynamics.wallForce()) base += force;
    double total = 0.0;
    for (double m : dynamics.grains().mass) total += m;
    EXPECT_NEAR((base - total*scene.g).norm(), 0.0, 1e-4*total*gravity);
}

} // namespace

TEST(Rest, spheres)
{
    for (int perSide : {4, 5, 6})
    {
        for (int layers : {4, 6, 7})
        {
            SCOPED_TRACE(std::to_string(perSide) + " a side, " + std::to_string(layers) + " layers");
            expectRest(heap(3, perSide, layers, radius, 0.8, 0.5));
        }
    }
}

TEST(Rest, discs) { expectRest(heap(2, 8, 12, radius, 0.6, 0.5)); }

// Mixing of sweeps hardly moves what is off in a bed as a whole. From eight disturbed starts 112 to 154 sweeps a step, and every step right; with mixing
// alone 151 to 257, 243 from this one, and 18 of 960 steps with forces off, 4 from this one.
TEST(Rest, aDeepBedThatLostItsImpulsesIsCarriedAgainInFewSweeps)
{
    const Scene scene = looseBed(4, 40);
    nscd::ContactSettings settings;
    settings.sleep = false;
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 400; ++k) stepDamped(dynamics, scene.g, deltaT);
    int sweeps = 0;
    for (int k = 0; k < 120; ++k)
    {
        if (k % 40 == 0) dynamics.restore({}, deltaT);
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        EXPECT_TRUE(report.solve.converged) << "step " << k;
        sweeps += report.solve.sweeps;
    }
    EXPECT_LT(sweeps, 200*120);
}
