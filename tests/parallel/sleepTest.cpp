// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that sleep on several ranks: as on one, whatever the cut, with all asleep and with some.
#include "rankedSleep.hpp"

#include "unit/nscd/scenes/pyramids.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = sleepDeltaT, radius = pyramidRadius;
constexpr int top = pyramidTop, roller = pyramidRoller;   // identities

const std::vector<OwnerOf>& cuts()
{
    static const std::vector<OwnerOf> all
    {
        [](const Vec3& x, std::int64_t) { return x[2] > 1.5*radius ? ranks() - 1 : 0; },
        [](const Vec3&, std::int64_t id) { return static_cast<int>(id % ranks()); }
    };
    return all;
}

/// Of a vector that each own grain has, that of one identity.
Vec3 ofGrain(const nscd::Grains& own, const std::vector<Vec3>& values, std::int64_t id)
{
    std::vector<double> here;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        if (own.id[i] == id) add(here, values[i]);
    }
    const std::vector<double> all = gather(here);
    return Vec3(all.data());
}

template<class Test>
void withSleepers(const Test& test) { scenes::withSleepers(pyramids, cuts(), 8u, test); }

} // namespace

TEST(SleepOnRanks, allStayWhereTheyAreAndWallsCarryThem)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        const nscd::Grains before = scene.gatherGrains();
        EXPECT_EQ(run(scene.dynamics(), 50).asleep, 8u);
        const nscd::Grains after = scene.gatherGrains();
        for (int i = 0; i < 8; ++i) EXPECT_EQ(after.position[i], before.position[i]) << i;
        if (withRoller)
        {
            EXPECT_NEAR(after.position[roller][0] - before.position[roller][0], 50*deltaT*0.2, 1e-9);
        }
        const double weightOfAll = static_cast<double>(after.size())*after.mass[0]*gravity;
        EXPECT_NEAR(scene.dynamics().wallForce()[0][2], -weightOfAll, 1e-4*weightOfAll);
    });
}

TEST(SleepOnRanks, aForceWakesWhatItDisturbsAlone)
{
    withSleepers([](RankedScene& scene, bool)
    {
        nscd::GrainDynamics& dynamics = scene.dynamics();
        const double weightOfOne = scene.gatherGrains().mass[0]*gravity;
        EXPECT_EQ(stepPushed(dynamics, top, 1e-6*Vec3::UnitX()).asleep, 8u);
        EXPECT_EQ(stepPushed(dynamics, top, 0.1*Vec3::UnitX()).asleep, 4u);
        EXPECT_NEAR(ofGrain(dynamics.grains(), dynamics.contactForce(), top)[0], -0.1*weightOfOne, 0.05*weightOfOne);
        EXPECT_NEAR(ofGrain(dynamics.grains(), dynamics.contactForce(), top + 4)[2], weightOfOne, 1e-3*weightOfOne);
    });
}

TEST(SleepOnRanks, whatWakesMovesLikeWhatNeverSlept)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        nscd::ContactSettings settings = fineEnoughToSleep();
        settings.sleep = false;
        nscd::GrainDynamics never = pyramids(withRoller).build(settings);
        run(never, stepsToSleep);
        for (int k = 0; k < 40; ++k)
        {
            const Vec3 push = k < 20 ? Vec3(20, 0, 20) : Vec3(0, 0, -60);   // up, and down again onto the others
            stepPushed(scene.dynamics(), top, push);
            stepPushed(never, top, push);
        }
        const nscd::Grains now = scene.gatherGrains();
        for (int i = 0; i < 8; ++i) EXPECT_LT((now.position[i] - never.grains().position[i]).norm(), 1e-3*radius) << i;
        EXPECT_GT(now.position[top][0], radius);
    });
}

TEST(SleepOnRanks, predictionsAndTrials)
{
    withSleepers([](RankedScene& scene, bool)
    {
        nscd::GrainDynamics& dynamics = scene.dynamics();
        const nscd::ExternalForces lifting = pushedOne(dynamics.grains(), top, Vec3(0, 0, 2)), still = pushedOne(dynamics.grains(), top, Vec3::Zero());
        dynamics.beginStep(deltaT);
        EXPECT_EQ(ofGrain(dynamics.grains(), dynamics.tryForces(lifting).velocity, top), Vec3(0, 0, 0));
        EXPECT_EQ(ofGrain(dynamics.grains(), dynamics.predict(still).velocity, top), Vec3(0, 0, 0));
        EXPECT_EQ(dynamics.advance(still).asleep, 8u);
        dynamics.beginStep(deltaT);
        EXPECT_NEAR(ofGrain(dynamics.grains(), dynamics.predict(lifting).velocity, top)[2], gravity*deltaT, 1e-8);
        EXPECT_EQ(dynamics.advance(lifting).asleep, 4u);
    });
}

TEST(SleepOnRanks, aHeldGrainThatIsDrivenWakesAll)
{
    Scene scene = pyramids(true);
    scene.addGrain(Vec3(-3*radius, 0, radius), radius);
    const std::int64_t held = roller + 1;
    scene.grains.isFixed[held] = 1;
    for (const OwnerOf& cut : cuts())
    {
        RankedScene ranked(scene, fineEnoughToSleep(), cut);
        nscd::GrainDynamics& dynamics = ranked.dynamics();
        EXPECT_EQ(run(dynamics, stepsToSleep).asleep, 8u);
        const nscd::Grains& own = dynamics.grains();
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            if (own.id[i] == held) dynamics.drive(i, Vec3(0.5, 0, 0), Vec3::Zero());
        }
        EXPECT_EQ(run(dynamics, 1).asleep, 0u);
        run(dynamics, 60);
        const nscd::Grains now = ranked.gatherGrains();
        EXPECT_GT(now.position[0][0] + now.position[1][0] + now.position[2][0], 3*0.2*radius);
    }
}

TEST(SleepOnRanks, aStopAndItsContinuationDoTheSameToTheBit)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        run(scene.dynamics(), 5);
        RankedScene other(pyramids(withRoller), fineEnoughToSleep(), cuts()[1]);
        double lastDeltaT = 0.0;
        const std::vector<nscd::StoredImpulse> impulses = scene.dynamics().checkpoint(lastDeltaT);
        other.dynamics().setGrains(scene.dynamics().grains());
        other.dynamics().restore(impulses, lastDeltaT);
        for (int k = 0; k < stepsToSleep; ++k) ASSERT_EQ(run(scene.dynamics(), 1).asleep, run(other.dynamics(), 1).asleep) << k;
        EXPECT_EQ(scene.gatherGrains().position, other.gatherGrains().position);
    });
}

// Frictionless, so that nothing moves: but what touches a driven grain stays awake, whoever owns the two.
TEST(SleepOnRanks, whatTouchesADrivenGrainStaysAwake)
{
    Scene row(3, 0.0, 0.0);
    row.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int k = 0; k < 5; ++k) row.addGrain(Vec3(2*radius*k, 0, radius), radius);
    row.grains.isFixed[0] = 1;
    row.grains.omega[0] = Vec3(0, 0, 1);
    for (const OwnerOf& cut : cuts())
    {
        RankedScene ranked(row, fineEnoughToSleep(), cut);
        EXPECT_EQ(run(ranked.dynamics(), stepsToSleep).asleep, 3u);
    }
}
