// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How long a list is made for, and what speeds it allows for: by hand for a few grains, and for rain on a bed.
#include "nscd/step/listPlan.hpp"
#include "unit/nscd/scenes/heaps.hpp"
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

nscd::ListPlan planOf(const Scene& scene, const nscd::OffPaths& off = nscd::OffPaths())
{
    return nscd::planByPaths(listContacts(scene, 2*radius), scene.grains.velocity, Vec3::Zero(), 2*radius, deltaT, off);
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

TEST(ListPlan, strongerImpactsThanForeseenMayHitAnyGrainInAShorterList)
{
    const double speed = 1.2, margin = 1.5;
    const nscd::ListPlan plan = planOf(fiveGrains(speed), {{}, margin, true});
    const double scatter = margin*2*speed*std::sqrt(2.0/5.0);
    EXPECT_DOUBLE_EQ(plan.speed[0], speed + margin*2*speed);
    EXPECT_DOUBLE_EQ(plan.speed[2], speed + (margin - 1.0)*2*speed*std::sqrt(2.0/5.0));
    EXPECT_DOUBLE_EQ(plan.expected.time, 0.25*2*radius/scatter);
}

TEST(ListPlan, inLongListsImpactsCountByTheTimeThatIsLeft)
{
    // 1.5 d apart, of which they come by one in a step: after half of it they are within d, as near as impacts are looked for.
    const double speed = radius/deltaT;
    Scene scene(3, 0.3, 0.0);
    for (const double x : {0.0, 5*radius})
    {
        scene.addGrain(Vec3(x, 0, 0), radius);
        scene.grains.velocity.back() = Vec3(x > 0 ? -speed : speed, 0, 0);
    }
    const nscd::ListPlan plan = planOf(scene), ofLongLists = planOf(scene, {{}, 1.0, true});
    EXPECT_DOUBLE_EQ(plan.speed[0], 3*speed);
    EXPECT_DOUBLE_EQ(ofLongLists.expected.time, deltaT);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(ofLongLists.speed[i], 2*speed, 1e-12*speed) << i;
}

TEST(ListPlan, grainsMayFallForAsLongAsTheListLasts)
{
    const double fall = 0.03, speed = 0.01;
    const nscd::ListPlan plan = planOf(fiveGrains(speed), {std::vector<double>(5, fall)}), flying = planOf(fiveGrains(speed));
    // Displacements of dt a dt, 2, 3 and 4 in the steps of a list of four.
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(plan.expected.time*(plan.speed[i] - flying.speed[i]), (1 + 2 + 3 + 4)*fall*deltaT, 1e-15) << i;
}

TEST(ListPlan, slowGrainsHaveFourStepsFastOnesOneAndAHalf)
{
    EXPECT_DOUBLE_EQ(planOf(fiveGrains(0.1)).expected.time, 4*deltaT);
    EXPECT_DOUBLE_EQ(planOf(fiveGrains(100)).expected.time, 1.5*deltaT);
}

TEST(ListPlan, whereStraysAreFollowedListsAllowForLessAndLastForWholeSteps)
{
    const double speed = 5.0;
    nscd::OffPaths off;
    off.areStraysFollowed = true;
    const nscd::ListPlan plan = planOf(fiveGrains(speed), off);
    EXPECT_DOUBLE_EQ(plan.speed[0], speed + 0.8*2*speed);
    EXPECT_DOUBLE_EQ(plan.expected.time, 2*deltaT);   // 1.6 without
}

TEST(ListPlan, grainsNearOtherRanksAreNotFollowedAndMayBeHitByAny)
{
    const double speed = 5.0, inTheMean = 2*speed*std::sqrt(2.0/5.0);
    nscd::OffPaths off;
    off.areStraysFollowed = true;
    off.isNearOthers = {1, 0, 1, 0, 0};
    const nscd::ListPlan plan = planOf(fiveGrains(speed), off);
    const double expected[] = {3*speed, speed + 0.8*2*speed, speed + inTheMean, speed, speed};
    for (int i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(plan.speed[i], expected[i]) << i;
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

TEST(ListPlan, aListLastsWhileGrainsFallFarInAStep)
{
    constexpr double small = 0.6e-3, pitch = 4*small, longStep = 3e-3;   // g dt^2 = 0.07 d
    Scene scene(3, 0.3, 0.0);
    for (int n = 0; n < 1000; ++n) scene.addGrain(pitch*Vec3(n % 10, n/10 % 10, n/100), small);
    auto dynamics = scene.build(nscd::ContactSettings());
    int lists = 0;
    for (int k = 0; k < 20; ++k) lists += step(dynamics, scene.g, longStep).listRebuilt;
    EXPECT_LE(lists, 7);    // seen: 7, and 16 where nothing is allowed for the fall
}

TEST(ListPlan, aBedAtRestHasAShortListInStepsInWhichAGrainFallsFar)
{
    constexpr double longStep = 27e-3;   // g dt^2 = 3 d
    Scene scene = looseBed(7, 7);
    const double small = scene.grains.radius[0];
    scene.addGrain(Vec3(7*small, 7*small, 2000*small), small);   // still above the bed at the end
    nscd::ContactSettings settings;
    settings.sleep = false;   // what is asleep is in no list
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 600; ++k) stepDamped(dynamics, scene.g, deltaT);
    const double most = 20.0*scene.grains.size();
    int lists = 0;
    for (int k = 0; k < 10; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, longStep);
        EXPECT_LT(report.candidates, most) << "step " << k;
        lists += report.listRebuilt;
    }
    EXPECT_GT(lists, 2);
}
