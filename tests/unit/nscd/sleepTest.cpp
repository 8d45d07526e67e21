// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Islands fall asleep, stay where they are, and wake in the step in which something changes.
#include "scenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// Two pyramids of four spheres, far from each other.
Scene twoPyramids()
{
    Scene scene(3, 0.5, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (double x : {0.0, 0.2})
    {
        for (int k = 0; k < 3; ++k)
        {
            const double angle = 2*M_PI*k/3, r = 2*radius/std::sqrt(3.0);
            scene.addGrain(Vec3(x + r*std::cos(angle), r*std::sin(angle), radius), radius);
        }
        scene.addGrain(Vec3(x, 0, radius + 2*radius*std::sqrt(2.0/3.0)), radius);
    }
    return scene;
}

nscd::StepReport run(nscd::GrainDynamics& dynamics, int steps)
{
    nscd::StepReport report;
    for (int k = 0; k < steps; ++k) report = step(dynamics, Vec3(0, 0, -gravity), deltaT);
    return report;
}

/// A pair of pyramids asleep.
struct Sleepers
{
    nscd::GrainDynamics dynamics = twoPyramids().build(nscd::ContactSettings());

    Sleepers()
    {
        const nscd::StepReport report = run(dynamics, 200);
        EXPECT_EQ(report.asleep, 8u);
        EXPECT_EQ(report.solve.sweeps, 0);
    }
};

nscd::StepReport stepWith(nscd::GrainDynamics& dynamics, const nscd::ExternalForces& forces)
{
    dynamics.beginStep(deltaT);
    return dynamics.advance(forces);
}

} // namespace

TEST(Sleep, pyramidsStayWhereTheyAreAndKeepTheirForces)
{
    Sleepers sleepers;
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    const nscd::Grains before = dynamics.grains();
    const nscd::StepReport report = run(dynamics, 1000);
    EXPECT_EQ(report.asleep, 8u);
    EXPECT_TRUE(report.solve.converged);
    EXPECT_EQ(dynamics.grains().position, before.position);
    EXPECT_EQ(nscd::kineticEnergy(dynamics.grains()), 0.0);
    double weightOfAll = 0.0;
    for (double m : before.mass) weightOfAll += m*gravity;
    EXPECT_NEAR(dynamics.wallForce()[0][2], -weightOfAll, 1e-4*weightOfAll);
    EXPECT_GT(dynamics.contacts().size(), 6u);
}

TEST(Sleep, nothingSleepsWhereItIsSwitchedOffOrMoves)
{
    nscd::ContactSettings settings;
    settings.sleep = false;
    nscd::GrainDynamics awake = twoPyramids().build(settings);
    EXPECT_EQ(run(awake, 200).asleep, 0u);

    Scene rolling(3, 0.5, 0.0);
    rolling.addPlane(Vec3::Zero(), Vec3::UnitZ());
    rolling.addGrain(Vec3(0, 0, radius), radius);
    rolling.grains.velocity[0] = Vec3(1e-3, 0, 0);
    nscd::GrainDynamics roller = rolling.build(nscd::ContactSettings());
    EXPECT_EQ(run(roller, 200).asleep, 0u);
}

TEST(Sleep, aForceWakesItsIslandAlone)
{
    Sleepers sleepers;
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::ExternalForces forces = weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT);
    // A tenth of the weight, as a fluid that starts to flow might add it.
    forces.force[3] += 0.1*gravity*dynamics.grains().mass[3]*Vec3::UnitX();
    const nscd::StepReport report = stepWith(dynamics, forces);
    EXPECT_EQ(report.asleep, 4u);
    EXPECT_GT(report.solve.sweeps, 0);
    EXPECT_LT(dynamics.contactForce()[3][0], -0.5*forces.force[3][0]);
    // Less than the noise that a solve leaves wakes nobody.
    Sleepers others;
    forces.force[3] = weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT).force[3]*(1.0 + 1e-6);
    EXPECT_EQ(stepWith(others.dynamics, forces).asleep, 8u);
}

TEST(Sleep, aKickWakesInTheSameStep)
{
    Sleepers sleepers;
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::Grains kicked = dynamics.grains();
    kicked.velocity[3] = Vec3(0.5, 0, 0.5);
    dynamics.setGrains(kicked);
    EXPECT_EQ(run(dynamics, 1).asleep, 0u);
    EXPECT_GT(dynamics.grains().position[3][0], kicked.position[3][0] + 0.2*deltaT);
}

TEST(Sleep, aGrainThatLandsWakesWhatItHits)
{
    Scene scene = twoPyramids();
    scene.addGrain(Vec3(0, 0, 0.25), radius);
    nscd::ContactSettings settings;
    settings.tolerance = 1e-6;  // while something moves nothing is polished, and the noise of a coarse solve keeps islands awake
    nscd::GrainDynamics dynamics = scene.build(settings);
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

TEST(Sleep, aMovedWallWakes)
{
    Scene scene = twoPyramids();
    const double start = 0.3;
    scene.walls.setMotion(0, [=](double time)
    {
        nscd::WallPose pose = nscd::WallPose::Identity();
        if (time > start) pose.translation() = Vec3(0, 0, 0.2*(time - start));
        return pose;
    });
    nscd::GrainDynamics dynamics = scene.build(nscd::ContactSettings());
    EXPECT_EQ(run(dynamics, 299).asleep, 8u);
    EXPECT_EQ(run(dynamics, 2).asleep, 0u);
    EXPECT_NEAR(dynamics.grains().velocity[0][2], 0.2, 1e-3);
}

TEST(Sleep, aRemovedNeighborWakesTheOthers)
{
    Sleepers sleepers;
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::Grains fewer = dynamics.grains();
    const double top = fewer.position[3][2];
    fewer.forEachArray([](auto& values) { values.erase(values.begin()); });
    fewer.nOwned = fewer.size();
    dynamics.setGrains(fewer);
    run(dynamics, 100);
    EXPECT_LT(dynamics.grains().position[2][2], top - 0.5*radius);
}

TEST(Sleep, aHeldGrainThatIsDrivenWakes)
{
    Scene scene = twoPyramids();
    scene.addGrain(Vec3(-3*radius, 0, radius), radius);
    scene.grains.isFixed.back() = 1;
    nscd::GrainDynamics dynamics = scene.build(nscd::ContactSettings());
    EXPECT_EQ(run(dynamics, 200).asleep, 8u);
    dynamics.drive(8, Vec3(0.5, 0, 0), Vec3::Zero());
    EXPECT_EQ(run(dynamics, 1).asleep, 0u);
    run(dynamics, 50);
    EXPECT_GT(nscd::kineticEnergy(dynamics.grains()), 0.0);
}

TEST(Sleep, aGrainThatWakesFromASleepOfAllMovesLikeOneThatNeverSlept)
{
    nscd::ContactSettings awake;
    awake.sleep = false;
    Sleepers sleepers;
    nscd::GrainDynamics never = twoPyramids().build(awake);
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

TEST(Sleep, aStopAndItsContinuationDoTheSameToTheBit)
{
    Sleepers sleepers;
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    run(dynamics, 5);  // so that the stop is at no multiple of anything
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = dynamics.checkpoint(lastDeltaT);
    Scene again = twoPyramids();
    again.grains = dynamics.grains();
    nscd::GrainDynamics later = again.build(nscd::ContactSettings());
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
