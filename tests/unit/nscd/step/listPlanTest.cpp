// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How long a list is made for, and what speeds it allows for: by hand for a few grains, and for rain on a bed.
#include "nscd/step/listPlan.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// Two grains that meet, one alone, two that part: gaps of two radii.
Scene fiveGrains(double speed)
{
    Scene scene(3, 0.3, 0.0);
    const double x[] = {0, 4, 50, 100, 104}, sign[] = {1, -1, 1, -1, 1};
    for (int i = 0; i < 5; ++i)
    {
        scene.addGrain(Vec3(radius*x[i], 0, 0), radius);
        scene.grains.velocity[i] = Vec3(sign[i]*speed, 0, 0);
    }
    return scene;
}

nscd::ListPlan planOf(const Scene& scene)
{
    return nscd::planByPaths(listContacts(scene, 2*radius), scene.grains.velocity, 2*radius, deltaT);
}

} // namespace

TEST(ListPlan, grainsThatMeetMayBeThrownOffByTheirRelativeVelocity)
{
    const double speed = 5.0;
    const nscd::ListPlan plan = planOf(fiveGrains(speed));
    const double expected[] = {3*speed, 3*speed, speed, speed, speed};
    for (int i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(plan.speed[i], expected[i]) << i;
    // Impacts of 2 speed on two of five grains; thrown off by half a diameter in the mean.
    const double scatter = 2*speed*std::sqrt(2.0/5.0);
    EXPECT_DOUBLE_EQ(plan.expected.time, 0.5*2*radius/scatter);
    EXPECT_EQ(plan.expected.velocity, fiveGrains(speed).grains.velocity);
}

TEST(ListPlan, slowGrainsHaveFourStepsFastOnesOneAndAHalf)
{
    EXPECT_DOUBLE_EQ(planOf(fiveGrains(0.1)).expected.time, 4*deltaT);
    EXPECT_DOUBLE_EQ(planOf(fiveGrains(100)).expected.time, 1.5*deltaT);
}

TEST(ListPlan, withoutPathsEachIsAsFastAsAllMayBe)
{
    const nscd::ListPlan plan = nscd::planBySpeeds({Vec3(3, 0, 4), Vec3(1, 0, 0)}, 2.0, 0.7, 1.0);
    EXPECT_EQ(plan.speed, (std::vector<double>{5.0, 2.0}));
    EXPECT_EQ(plan.expected.time, 0.7);
    EXPECT_TRUE(plan.expected.velocity.empty());
}

TEST(ListPlan, rainOnABedMakesNoListsWithoutEnd)
{
    constexpr double small = 1e-3, pitch = 2.3*small;
    constexpr int perSide = 6, bedLayers = 3, rainLayers = 20;
    Scene scene(3, 0.3, 0.0);
    scene.box.length = Vec3(perSide*pitch, perSide*pitch, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-0.5, 0.5);
    for (int n = 0; n < perSide*perSide*(bedLayers + rainLayers); ++n)
    {
        const int layer = n/(perSide*perSide);
        const bool isRain = layer >= bedLayers;
        const Vec3 place(n % perSide + 0.5, n/perSide % perSide + 0.5, isRain ? 2.0*layer - bedLayers + 0.5 : layer + 0.5);
        scene.addGrain(pitch*place + 0.1*small*Vec3(unit(random), unit(random), unit(random)), small);
        if (isRain) scene.grains.velocity.back() = Vec3(0, 0, -2.0 + unit(random));  // a diameter a step
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    const double most = 50.0*scene.grains.size();  // seen: 31, and 1600 where all candidates may give impacts
    for (int k = 0; k < 10; ++k) step(dynamics, scene.g, deltaT);  // the first lists know nothing of who is near whom
    for (int k = 10; k < 60; ++k) EXPECT_LT(step(dynamics, scene.g, deltaT).candidates, most) << "step " << k;
}
