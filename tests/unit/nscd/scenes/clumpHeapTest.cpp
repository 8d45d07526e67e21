// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A heap of clumps and spheres: laws and balances in every step, by code of the test's own; rest in the end; the same bits again;
// what that code sees of fast ones.
#include "unit/nscd/scenes/clumpMap.hpp"
#include "unit/nscd/scenes/sceneHash.hpp"

#include <gtest/gtest.h>

using namespace scenes;

TEST(ClumpHeap, obeysTheLawsInEveryStep)
{
    const double deltaT = 1e-3, friction = 0.4;
    const Scene scene = clumpHeap(27, 3, friction);
    nscd::ContactSettings settings;
    auto dynamics = scene.build(settings);
    double diameter = 0.0;
    for (double r : dynamics.grains().radius) diameter += 2.0*r/dynamics.grains().size();
    ClumpJudge judge(scene, friction, settings.deadBand*diameter, deltaT);
    int loaded = 0;
    for (int k = 0; k < 400; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        ASSERT_TRUE(report.solve.converged) << k;
        const ClumpMap map = judge(before, dynamics);
        const double scale = report.solve.speedScale;
        EXPECT_LE(map.rms, 1.001*settings.tolerance*scale) << k;
        EXPECT_LE(map.max*deltaT, 1.001*settings.displacementTolerance*diameter) << k;
        EXPECT_NEAR(map.rms, report.solve.residualRms, 1e-9*scale) << k;
        EXPECT_LT(map.imbalance, 1e-14) << k;
        EXPECT_EQ(map.asleep, 0.0) << k;
        EXPECT_LT(map.overlap, 2e-3*diameter) << k;
        loaded = std::max(loaded, map.loaded);
    }
    EXPECT_GT(loaded, 50);
}

TEST(ClumpHeap, judgeSeesWhatMeetsFromAfar)
{
    constexpr double deltaT = 1e-3, friction = 0.4, r = memberRadius;
    const Vec3 fall(0, 0, -9);   // 0.9 r in the step
    Scene scene(3, friction, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int shape = addShape(scene, dumbbell());
    addClump(scene, shape, Vec3(0, 0, 1.8*r), Quaternion::Identity(), fall);
    addClump(scene, shape, Vec3(10*r, 0, 3*r));
    addClump(scene, shape, Vec3(10*r, 0, 5.8*r), Quaternion::Identity(), fall);
    scene.addGrain(Vec3(20*r, 0, 5*r), r);
    scene.addGrain(Vec3(21.2*r, 0, 7*r), r);
    scene.grains.velocity.back() = fall;

    auto dynamics = scene.build();
    ClumpJudge judge(scene, friction, tight().deadBand*2.0*r, deltaT);
    const nscd::Grains before = dynamics.grains();
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    ASSERT_TRUE(report.solve.converged);
    const ClumpMap map = judge(before, dynamics);
    EXPECT_EQ(map.loaded, 5);   // two of the first clump, two between the others, one between the spheres
    EXPECT_LT(map.imbalance, 1e-14);
    EXPECT_NEAR(map.rms, report.solve.residualRms, 1e-9*report.solve.speedScale);
    EXPECT_LE(map.rms, 1.001*tight().tolerance*report.solve.speedScale);
}

TEST(ClumpHeap, sleepersAloneMayBeOffTheirBalance)
{
    const double deltaT = 1e-3, friction = 0.5;
    const Scene scene = clumpHeap(36, 3, friction);
    nscd::ContactSettings settings;
    auto dynamics = scene.build(settings);
    ClumpJudge judge(scene, friction, settings.deadBand*2.0*memberRadius, deltaT);
    double worst = 0.0;
    for (int k = 0; k < 600; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        const ClumpMap map = judge(before, dynamics);
        EXPECT_LT(map.imbalance, 1e-14) << k;
        EXPECT_TRUE(report.asleep > 0 || map.asleep == 0.0) << k;
        worst = std::max(worst, map.asleep);
    }
    EXPECT_GT(worst, 1e-5);
    EXPECT_LT(worst, 5e-3);
}

TEST(ClumpHeap, serialRunsRepeatToTheBit)
{
    std::uint64_t values[2];
    for (std::uint64_t& value : values)
    {
        auto dynamics = clumpHeap(9, 3, 0.4).build(nscd::ContactSettings());
        for (int k = 0; k < 100; ++k) step(dynamics, Vec3(0, 0, -gravity), 1e-3);
        value = hash(dynamics.grains());
    }
    EXPECT_EQ(values[0], values[1]);
}
