// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps that sleep, and that resist rolling, on several ranks: as on one, whatever the cut.
#include "rankedSleep.hpp"

#include "unit/nscd/scenes/clumpStacks.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/scenes/pyramids.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = sleepDeltaT, r = memberRadius;
constexpr std::size_t all = stackedGrains, second = stackedGrains - firstStack;

/// What lies on the cubes on a rank of its own; and clumps by their first members' identities, 0, 8, 10, 18, 19.
const std::vector<OwnerOf>& cuts()
{
    static const std::vector<OwnerOf> all
    {
        [](const Vec3& x, std::int64_t) { return x[2] > 3.5*r ? ranks() - 1 : 0; },
        [](const Vec3&, std::int64_t id) { return static_cast<int>((id/2) % ranks()); }
    };
    return all;
}

template<class Test>
void withSleepers(const Test& test) { scenes::withSleepers(clumpStacks, cuts(), all, test); }

} // namespace

TEST(ClumpSleepOnRanks, allStayWhereTheyAreAndWallsCarryThem)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        const nscd::Grains before = scene.gatherGrains();
        EXPECT_EQ(run(scene.dynamics(), 50).asleep, all);
        const nscd::Grains after = scene.gatherGrains();
        for (std::size_t i = 0; i < all; ++i) EXPECT_EQ(after.position[i], before.position[i]) << i;
        if (withRoller)
        {
            EXPECT_NEAR(after.position[stackRoller][0] - before.position[stackRoller][0], 50*deltaT*0.2, 1e-9);
        }
        const double weightOfAll = gravity*totalMass(after);
        EXPECT_NEAR(scene.dynamics().wallForce()[0][2], -weightOfAll, 1e-4*weightOfAll);
    });
}

TEST(ClumpSleepOnRanks, aForceWakesItsStackAlone)
{
    withSleepers([](RankedScene& scene, bool)
    {
        EXPECT_EQ(stepPushed(scene.dynamics(), dumbbellBall, 1e-6*Vec3::UnitX()).asleep, all);
        EXPECT_EQ(stepPushed(scene.dynamics(), dumbbellBall, 0.1*Vec3::UnitX()).asleep, second);
    });
}

TEST(ClumpSleepOnRanks, whatWakesMovesLikeWhatNeverSlept)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        nscd::ContactSettings settings = fineEnoughToSleep();
        settings.sleep = false;
        nscd::GrainDynamics never = clumpStacks(withRoller).build(settings);
        run(never, stepsToSleep);
        for (int k = 0; k < 40; ++k)
        {
            const Vec3 push = k < 20 ? Vec3(10, 0, 40) : Vec3(0, 0, -90);   // up, and down again onto the cube
            stepPushed(scene.dynamics(), dumbbellBall, push);
            stepPushed(never, dumbbellBall, push);
        }
        const nscd::Grains now = scene.gatherGrains();
        for (std::size_t i = 0; i < all; ++i) EXPECT_LT((now.position[i] - never.grains().position[i]).norm(), 1e-3*r) << i;
        EXPECT_GT(now.position[dumbbellBall][0], 0.0);
    });
}

TEST(ClumpSleepOnRanks, aStopAndItsContinuationDoTheSameToTheBit)
{
    withSleepers([](RankedScene& scene, bool withRoller)
    {
        run(scene.dynamics(), 5);
        RankedScene other(clumpStacks(withRoller), fineEnoughToSleep(), cuts()[1]);
        double lastDeltaT = 0.0;
        const std::vector<nscd::StoredImpulse> impulses = scene.dynamics().checkpoint(lastDeltaT);
        other.dynamics().setGrains(scene.dynamics().grains());
        other.dynamics().restore(impulses, lastDeltaT);
        for (int k = 0; k < stepsToSleep; ++k) ASSERT_EQ(run(scene.dynamics(), 1).asleep, run(other.dynamics(), 1).asleep) << k;
        EXPECT_EQ(scene.gatherGrains().position, other.gatherGrains().position);
    });
}

// Whatever wakes by a rebound wakes on all ranks.
TEST(ClumpSleepOnRanks, aGrainThatReboundsFromSleepersDoesAsOnOne)
{
    for (const bool ofClumps : {false, true})
    for (const OwnerOf& cut : cuts())
    {
        Scene scene = ofClumps ? clumpStacks(true) : pyramids(true);
        setAll(scene, {0.5, 0.5});
        const int fallen = static_cast<int>(scene.grains.size());
        scene.addGrain(Vec3(0.003, 0.001, 0.25), r);
        nscd::GrainDynamics alone = scene.build(fineEnoughToSleep());
        RankedScene ranked(scene, fineEnoughToSleep(), cut);
        std::size_t most = 0;
        for (int k = 0; k < 260; ++k)
        {
            most = std::max(most, run(ranked.dynamics(), 1).asleep);
            run(alone, 1);
        }
        EXPECT_GE(most, 8u);
        const nscd::Grains now = ranked.gatherGrains();
        EXPECT_LT((now.position[fallen] - alone.grains().position[fallen]).norm(), 2e-2*r);
    }
}

// Dumbbells that touch one another side by side, and are pushed over the floor from one end.
TEST(ClumpsOnRanks, resistRollingAsOnOne)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, rollingPair(0.4, 0.15, 0.05));
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int shape = addShape(scene, dumbbell());
    for (int k = 0; k < 4; ++k) addClump(scene, shape, Vec3(0.1*r*k, 2*r*k, r), Quaternion::Identity(), Vec3(0, k == 0 ? 0.3 : 0.0, 0));
    scene.addGrain(Vec3(-1.1*r, 8*r, r), r);
    for (const OwnerOf& cut : std::vector<OwnerOf>{[](const Vec3& x, std::int64_t) { return static_cast<int>(x[1]/(2*r) + 0.5) % ranks(); }, cuts()[1]})
    {
        nscd::ContactSettings settings;
        settings.tolerance = 1e-5;
        nscd::GrainDynamics alone = scene.build(settings);
        RankedScene ranked(scene, settings, cut);
        for (int k = 0; k < 40; ++k)
        {
            run(alone, 1);
            run(ranked.dynamics(), 1);
        }
        const nscd::Grains now = ranked.gatherGrains();
        for (std::size_t i = 0; i < now.size(); ++i) EXPECT_LT((now.position[i] - alone.grains().position[i]).norm(), 1e-3*r) << i;
        EXPECT_GT(now.position.back()[1], 8.02*r);
        double moments = 0.0;
        for (const nscd::LoadedContact& contact : ranked.gatherContacts()) moments = std::max(moments, contact.moment.norm());
        EXPECT_GT(moments, 0.0);
    }
}
