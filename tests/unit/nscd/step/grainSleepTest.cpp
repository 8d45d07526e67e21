// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains at rest fall asleep, stay where they are, and wake in the step in which something changes, whether others are awake or not.
#include "unit/nscd/scenes/pyramids.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = sleepDeltaT, radius = pyramidRadius;

/// A pair of pyramids asleep; with the roller steps still solve something.
struct Sleepers
{
    nscd::GrainDynamics dynamics;

    explicit Sleepers(bool withRoller) : dynamics(pyramids(withRoller).build(fineEnoughToSleep()))
    {
        const nscd::StepReport report = run(dynamics, 200);
        EXPECT_EQ(report.asleep, 8u);
        EXPECT_EQ(report.solve.sweeps > 0, withRoller);
    }
};

/// With everybody asleep, and with a grain awake.
class Sleep : public testing::TestWithParam<bool>
{};
INSTANTIATE_TEST_SUITE_P(ofAllOrOfSome, Sleep, testing::Bool());

} // namespace

TEST_P(Sleep, pyramidsStayWhereTheyAreAndKeepTheirForces)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    const nscd::Grains before = dynamics.grains();
    const nscd::StepReport report = run(dynamics, 1000);
    EXPECT_EQ(report.asleep, 8u);
    EXPECT_TRUE(report.solve.converged);
    for (std::size_t i = 0; i < 8; ++i)
    {
        EXPECT_EQ(dynamics.grains().position[i], before.position[i]);
        EXPECT_EQ(dynamics.grains().velocity[i], Vec3(0, 0, 0));
    }
    if (GetParam())
    {
        EXPECT_NEAR(dynamics.grains().position[8][0] - before.position[8][0], 1000*deltaT*0.2, 1e-9);
    }
    double weightOfAll = 0.0;
    for (double m : before.mass) weightOfAll += m*gravity;
    EXPECT_NEAR(dynamics.wallForce()[0][2], -weightOfAll, 1e-4*weightOfAll);
    EXPECT_GT(dynamics.contacts().size(), 6u);
}

TEST(SleepOf, nothingSleepsWhereItIsSwitchedOffOrMoves)
{
    nscd::ContactSettings settings;
    settings.sleep = false;
    nscd::GrainDynamics awake = pyramids(false).build(settings);
    EXPECT_EQ(run(awake, 200).asleep, 0u);

    Scene rolling(3, 0.5, 0.0);
    rolling.addPlane(Vec3::Zero(), Vec3::UnitZ());
    rolling.addGrain(Vec3(0, 0, radius), radius);
    rolling.grains.velocity[0] = Vec3(1e-3, 0, 0);
    nscd::GrainDynamics roller = rolling.build(nscd::ContactSettings());
    EXPECT_EQ(run(roller, 200).asleep, 0u);
}

TEST_P(Sleep, aForceWakesWhatItDisturbsAlone)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::ExternalForces forces = weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT);
    // A tenth of the weight, as a fluid that starts to flow might add it.
    forces.force[3] += 0.1*gravity*dynamics.grains().mass[3]*Vec3::UnitX();
    const nscd::StepReport report = stepWith(dynamics, forces);
    EXPECT_EQ(report.asleep, 4u);
    EXPECT_GT(report.solve.sweeps, 0);
    EXPECT_LT(dynamics.contactForce()[3][0], -0.5*forces.force[3][0]);
    // Less than the noise that a solve leaves wakes nobody.
    Sleepers others(GetParam());
    forces.force[3] = weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT).force[3]*(1.0 + 1e-6);
    EXPECT_EQ(stepWith(others.dynamics, forces).asleep, 8u);
}

TEST_P(Sleep, aForceThatGrowsSlowlyWakesOnceItHasGrownEnough)
{
    Sleepers sleepers(GetParam());
    const nscd::ExternalForces still = weight(sleepers.dynamics.grains(), Vec3(0, 0, -gravity), deltaT);
    int steps = 0;
    for (; steps < 20; ++steps)
    {
        nscd::ExternalForces forces = still;
        forces.force[3] *= 1.0 + 3e-4*steps;
        if (stepWith(sleepers.dynamics, forces).asleep < 8) break;
    }
    EXPECT_EQ(steps, 4);  // 1.2e-3 of the weight
}

TEST_P(Sleep, aKickWakesInTheSameStep)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::Grains kicked = dynamics.grains();
    kicked.velocity[3] = Vec3(0.5, 0, 0.5);
    dynamics.setGrains(kicked);
    EXPECT_EQ(run(dynamics, 1).asleep, 0u);
    EXPECT_GT(dynamics.grains().position[3][0], kicked.position[3][0] + 0.2*deltaT);
}

TEST(SleepOf, aGrainThatLandsWakesWhatItHits)
{
    Scene scene = pyramids(false);
    scene.addGrain(Vec3(0, 0, 0.25), radius);
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    // It falls for 0.2 s; by then both pyramids sleep.
    std::size_t most = 0;
    double floorForce = 0.0, falling = 0.0;
    for (int k = 0; k < 400 && floorForce == 0.0; ++k)
    {
        const double before = dynamics.grains().velocity[8][2];
        const nscd::StepReport report = run(dynamics, 1);
        most = std::max(most, report.asleep);
        if (dynamics.contactForce()[8].norm() == 0.0) continue;
        EXPECT_EQ(report.asleep, 4u) << "step " << k;
        floorForce = -dynamics.wallForce()[0][2];
        falling = before;
    }
    EXPECT_EQ(most, 8u);
    // Struck in this step, and awake in it: what it lost, the pyramid and the floor got.
    const nscd::Grains& now = dynamics.grains();
    double momentum = 0.0, weightOfAll = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i)
    {
        momentum += now.mass[i]*now.velocity[i][2];
        weightOfAll += now.mass[i]*gravity;
    }
    EXPECT_NEAR(momentum - now.mass[8]*falling, (floorForce - weightOfAll)*deltaT, 1e-4*weightOfAll*deltaT);
    EXPECT_GT(floorForce, 5*weightOfAll);
}

TEST_P(Sleep, aMovedWallWakes)
{
    Scene scene = pyramids(GetParam());
    const double start = 0.3;
    scene.walls.setMotion(0, [=](double time)
    {
        nscd::WallPose pose = nscd::WallPose::Identity();
        if (time > start) pose.translation() = Vec3(0, 0, 0.2*(time - start));
        return pose;
    });
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    EXPECT_EQ(run(dynamics, 299).asleep, 8u);
    EXPECT_EQ(run(dynamics, 2).asleep, 0u);
    EXPECT_NEAR(dynamics.grains().velocity[0][2], 0.2, 1e-3);
}

TEST_P(Sleep, aRemovedNeighborWakesTheOthers)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::Grains fewer = dynamics.grains();
    const double top = fewer.position[3][2];
    fewer.forEachArray([](auto& values) { values.erase(values.begin()); });
    fewer.nOwned = fewer.size();
    dynamics.setGrains(fewer);
    run(dynamics, 100);
    EXPECT_LT(dynamics.grains().position[2][2], top - 0.5*radius);
}

TEST_P(Sleep, aHeldGrainThatIsDrivenWakes)
{
    Scene scene = pyramids(GetParam());
    scene.addGrain(Vec3(-3*radius, 0, radius), radius);
    scene.grains.isFixed.back() = 1;
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    EXPECT_EQ(run(dynamics, 200).asleep, 8u);
    dynamics.drive(scene.grains.size() - 1, Vec3(0.5, 0, 0), Vec3::Zero());
    EXPECT_EQ(run(dynamics, 1).asleep, 0u);
    run(dynamics, 100);
    double farthest = 0.0;
    for (int i = 0; i < 4; ++i) farthest = std::max(farthest, (dynamics.grains().position[i] - scene.grains.position[i]).norm());
    EXPECT_GT(farthest, radius);
}

TEST_P(Sleep, aGrainThatWakesMovesLikeOneThatNeverSlept)
{
    nscd::ContactSettings awake = fineEnoughToSleep();
    awake.sleep = false;
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics never = pyramids(GetParam()).build(awake);
    run(never, 200);
    for (nscd::GrainDynamics* dynamics : {&sleepers.dynamics, &never})
    {
        nscd::ExternalForces forces = weight(dynamics->grains(), Vec3(0, 0, -gravity), deltaT);
        forces.force[3] += 20*gravity*dynamics->grains().mass[3]*Vec3(1, 0, 1);
        for (int k = 0; k < 20; ++k) stepWith(*dynamics, forces);
    }
    const Vec3 woken = sleepers.dynamics.grains().position[3], neverSlept = never.grains().position[3];
    EXPECT_GT(neverSlept[0], radius);
    EXPECT_LT((woken - neverSlept).norm(), 1e-3*radius);
}

TEST_P(Sleep, aStopAndItsContinuationDoTheSameToTheBit)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    run(dynamics, 5);  // so that the stop is at no multiple of anything
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = dynamics.checkpoint(lastDeltaT);
    Scene again = pyramids(GetParam());
    again.grains = dynamics.grains();
    nscd::GrainDynamics later = again.build(fineEnoughToSleep());
    later.restore(impulses, lastDeltaT);
    for (int k = 0; k < 100; ++k)
    {
        const std::size_t asleep = run(dynamics, 1).asleep;
        ASSERT_EQ(asleep, run(later, 1).asleep) << k;
        ASSERT_EQ(dynamics.grains().position, later.grains().position) << k;
        ASSERT_EQ(dynamics.grains().velocity, later.grains().velocity) << k;
    }
    EXPECT_EQ(run(dynamics, 1).asleep, 8u);
}

namespace
{

/// The weight, and a push on the top of the first pyramid by this part of its own.
nscd::ExternalForces pushed(const nscd::Grains& grains, const Vec3& part)
{
    nscd::ExternalForces forces = weight(grains, Vec3(0, 0, -gravity), deltaT);
    forces.force[3] += gravity*grains.mass[3]*part;
    return forces;
}

} // namespace

TEST_P(Sleep, aPredictionLetsThemSleepAndKnowsTheirForces)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    const nscd::ExternalForces still = pushed(dynamics.grains(), Vec3::Zero());
    dynamics.beginStep(deltaT);
    const nscd::Prediction prediction = dynamics.predict(still);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(prediction.velocity[i], Vec3(0, 0, 0));
    const nscd::StepReport report = dynamics.advance(still);
    EXPECT_EQ(report.asleep, 8u);
    EXPECT_EQ(prediction.contactForce, dynamics.contactForce());
    EXPECT_GT(prediction.contactForce[3][2], 0.99*gravity*dynamics.grains().mass[3]);
}

TEST_P(Sleep, aPredictionUnderANewForceWakesWhatItMoves)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    const nscd::ExternalForces lifting = pushed(dynamics.grains(), Vec3(0, 0, 2));
    dynamics.beginStep(deltaT);
    const nscd::Prediction prediction = dynamics.predict(lifting);
    EXPECT_NEAR(prediction.velocity[3][2], gravity*deltaT, 1e-9);
    EXPECT_EQ(dynamics.advance(lifting).asleep, 4u);
    EXPECT_NEAR(dynamics.grains().velocity[3][2], gravity*deltaT, 1e-9);
}

// A trial asks how the others move beside those that sleep; the step after it is the one without a trial, to the bit.
TEST_P(Sleep, aTrialWakesNobodyAndLeavesNoTrace)
{
    Sleepers tried(GetParam()), others(GetParam());
    const nscd::ExternalForces still = pushed(others.dynamics.grains(), Vec3::Zero());
    tried.dynamics.beginStep(deltaT);
    const nscd::Prediction trial = tried.dynamics.tryForces(pushed(tried.dynamics.grains(), Vec3(0, 0, 2)));
    EXPECT_EQ(trial.velocity[3], Vec3(0, 0, 0));
    EXPECT_EQ(tried.dynamics.advance(still).asleep, 8u);
    EXPECT_EQ(stepWith(others.dynamics, still).asleep, 8u);
    EXPECT_EQ(tried.dynamics.grains().position, others.dynamics.grains().position);
    EXPECT_EQ(tried.dynamics.contactForce(), others.dynamics.contactForce());
}

// One that lies on sleeping grains, and is pushed while it is awake, moves beside held ones in the trial.
TEST(SleepOf, aTrialMovesWhoIsAwake)
{
    Scene scene = pyramids(true);
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    run(dynamics, 200);
    nscd::ExternalForces forces = pushed(dynamics.grains(), Vec3::Zero());
    const double rolling = dynamics.grains().velocity[8][0];
    forces.force[8] += dynamics.grains().mass[8]*gravity*Vec3(0, 1, 0)*0.1;
    dynamics.beginStep(deltaT);
    const nscd::Prediction trial = dynamics.tryForces(forces);
    EXPECT_NEAR(trial.velocity[8][1], 0.1*gravity*deltaT*5/7, 1e-6*gravity*deltaT);
    EXPECT_NEAR(trial.velocity[8][0], rolling, 1e-9);
}
