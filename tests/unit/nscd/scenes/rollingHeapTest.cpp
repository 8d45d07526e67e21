// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heaps with rolling and spinning friction: at rest, judged by code of its own, restarted.
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/scenes/restarts.hpp"
#include "unit/nscd/scenes/rollingMap.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

} // namespace

TEST(Rolling, aJudgeOfItsOwnAgrees)
{
    for (int dimensions : {2, 3})
    {
        Scene scene = heap(dimensions, 4, 5, radius, 0.5, 0.4);
        setAll(scene, rollingPair(0.4, 0.05, 0.02));
        nscd::ContactSettings settings;
        settings.polishSweeps = 0;
        auto dynamics = scene.build(settings);
        const double diameter = meanDiameter(scene.grains);
        for (int k = 0; k < 200; ++k)
        {
            const nscd::Grains before = dynamics.grains();
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            ASSERT_TRUE(report.solve.converged) << k;
            if (report.solve.contacts < 10) continue;
            const NaturalMap contacts = Judge(scene, 0.4, settings.deadBand*diameter, deltaT)(before, dynamics);
            const double rolling = rollingNorm(scene, before, dynamics.grains(), dynamics.contacts());
            const double rms = std::sqrt((contacts.norm*contacts.norm + rolling*rolling)/contacts.loaded);
            ASSERT_NEAR(rms, report.solve.residualRms, 1e-9*settings.tolerance*gravity*deltaT) << k;
        }
    }
}

TEST(Rolling, aHeapComesToRest)
{
    double energy[2];
    for (double rolling : {0.0, 0.05})
    {
        Scene scene = heap(3, 4, 4, radius, 0.7, 0.4);
        setAll(scene, rollingPair(0.4, rolling, 0.4*rolling));
        auto dynamics = scene.build(nscd::ContactSettings());
        const double unit = scene.grains.mass[0]*gravity*2*radius;
        int capped = 0, forcesOff = 0, sweeps = 0;
        for (int k = 0; k < 1500; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            capped += report.solve.atCap;
            forcesOff += !report.solve.converged;
            sweeps += report.solve.sweeps;
        }
        EXPECT_EQ(capped, 0);
        EXPECT_LE(forcesOff, 7);   // in steps of the fall, half a percent
        energy[rolling > 0.0] = nscd::kineticEnergy(dynamics.grains())/unit;
        std::printf("   rolling friction %.2f: %.1f sweeps a step, kinetic energy %.1e m g d\n", rolling, sweeps/1500.0, energy[rolling > 0.0]);
    }
    EXPECT_LT(energy[1], 1e-12);   // without rolling friction the last grains may roll on: chance
}

TEST(Rolling, restartsToTheBit)
{
    Scene scene = heap(3, 4, 4, radius, 0.7, 0.4);
    setAll(scene, rollingPair(0.4, 0.05, 0.02));
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 150; ++k) step(dynamics, scene.g, deltaT);
    expectSameAfterRestart(dynamics, scene, deltaT, 30);
}
