// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps fall asleep as one body each, beside spheres that do, carry and are carried while they sleep, and wake in the step in which something changes.
#include "nscd/step/clumpLoads.hpp"
#include "unit/nscd/scenes/clumpStacks.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = sleepDeltaT, r = memberRadius;

nscd::ExternalForces still(const nscd::GrainDynamics& dynamics) { return weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT); }

/// Both stacks asleep; with the roller steps still solve something.
struct Sleepers
{
    nscd::GrainDynamics dynamics;

    explicit Sleepers(bool withRoller) : dynamics(clumpStacks(withRoller).build(fineEnoughToSleep()))
    {
        const nscd::StepReport report = run(dynamics, 200);
        EXPECT_EQ(report.asleep, static_cast<std::size_t>(stackedGrains));
        EXPECT_EQ(report.solve.sweeps > 0, withRoller);
    }
};

double weightOfAll(const nscd::Grains& grains) { return gravity*totalMass(grains); }

double largestMove(const nscd::Grains& a, const nscd::Grains& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position[i] - b.position[i]).norm());
    return largest;
}

/// What grains and walls get of contacts adds up to nothing, and the walls carry the weight.
void expectBalance(const nscd::GrainDynamics& dynamics)
{
    Vec3 onGrains = Vec3::Zero(), onWalls = Vec3::Zero();
    for (const Vec3& force : dynamics.contactForce()) onGrains += force;
    for (const Vec3& force : dynamics.wallForce()) onWalls += force;
    const double all = weightOfAll(dynamics.grains());
    EXPECT_LT((onGrains + onWalls).norm(), 1e-10*all);
    EXPECT_NEAR(-onWalls[2], all, 1e-3*all);
}

/// With everybody asleep, and with a grain awake.
class ClumpSleep : public testing::TestWithParam<bool>
{};
INSTANTIATE_TEST_SUITE_P(ofAllOrOfSome, ClumpSleep, testing::Bool());

} // namespace

TEST_P(ClumpSleep, stacksStayWhereTheyAreAndTheFloorCarriesThem)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    const nscd::Grains before = dynamics.grains();
    const nscd::StepReport report = run(dynamics, 500);
    EXPECT_EQ(report.asleep, static_cast<std::size_t>(stackedGrains));
    EXPECT_TRUE(report.solve.converged);
    for (int i = 0; i < stackedGrains; ++i)
    {
        EXPECT_EQ(dynamics.grains().position[i], before.position[i]);
        EXPECT_EQ(dynamics.grains().velocity[i], Vec3(0, 0, 0));
    }
    const nscd::Clumps &now = dynamics.grains().clumps, &then = before.clumps;
    for (std::size_t c = 0; c < now.size(); ++c)
    {
        EXPECT_EQ(now.position[c], then.position[c]);
        EXPECT_EQ(now.orientation[c].coeffs(), then.orientation[c].coeffs());
        EXPECT_EQ(now.velocity[c], Vec3(0, 0, 0));
        EXPECT_EQ(now.angularMomentum[c], Vec3(0, 0, 0));
    }
    if (GetParam())
    {
        EXPECT_NEAR(dynamics.grains().position[stackRoller][0] - before.position[stackRoller][0], 500*deltaT*0.2, 1e-9);
    }
    expectBalance(dynamics);
    EXPECT_GE(dynamics.contacts().size(), 16u);
}

TEST_P(ClumpSleep, aForceOnOneMemberWakesItsStackAlone)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::ExternalForces forces = still(dynamics);
    const double mass = dynamics.grains().clumps.shapeOf(1).mass;
    forces.force[dumbbellBall + 1] += 0.1*gravity*mass*Vec3::UnitX();
    const nscd::StepReport report = stepWith(dynamics, forces);
    EXPECT_EQ(report.asleep, static_cast<std::size_t>(stackedGrains - firstStack));
    const Vec3 onDumbbell = dynamics.contactForce()[dumbbellBall] + dynamics.contactForce()[dumbbellBall + 1];
    EXPECT_NEAR(onDumbbell[0], -0.1*gravity*mass, 1e-2*gravity*mass);

    Sleepers others(GetParam());
    forces = still(others.dynamics);
    forces.force[dumbbellBall] *= 1.0 + 1e-6;
    EXPECT_EQ(stepWith(others.dynamics, forces).asleep, static_cast<std::size_t>(stackedGrains)) << "less than the noise of a solve wakes nobody";
}

// What a caller's forces do to a clump is their sum, and the sum of torques.
TEST_P(ClumpSleep, whatCountsIsTheSumOnTheClump)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::ExternalForces forces = still(dynamics);
    const Vec3 push = 0.1*gravity*dynamics.grains().clumps.shapeOf(1).mass*Vec3::UnitX();
    forces.force[dumbbellBall] += push;
    forces.force[dumbbellBall + 1] -= push;
    EXPECT_EQ(stepWith(dynamics, forces).asleep, static_cast<std::size_t>(stackedGrains));
    forces.torque.assign(dynamics.grains().size(), Vec3::Zero());
    forces.torque[dumbbellBall] = r*push.norm()*Vec3::UnitZ();
    EXPECT_EQ(stepWith(dynamics, forces).asleep, static_cast<std::size_t>(stackedGrains - firstStack));
}

TEST_P(ClumpSleep, aForceThatGrowsSlowlyWakesOnceItHasGrownEnough)
{
    Sleepers sleepers(GetParam());
    int steps = 0;
    for (; steps < 20; ++steps)
    {
        nscd::ExternalForces forces = still(sleepers.dynamics);
        for (int k : {0, 1}) forces.force[dumbbellBall + k] *= 1.0 + 3e-4*steps;
        if (stepWith(sleepers.dynamics, forces).asleep < static_cast<std::size_t>(stackedGrains)) break;
    }
    EXPECT_EQ(steps, 4);  // 1.2e-3 of the weight
}

TEST(ClumpSleepOf, aGrainThatLandsOnAClumpWakesItInThatStep)
{
    Scene scene = clumpStacks(false);
    scene.addGrain(Vec3(r, 0, 0.28), r);
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    std::size_t most = 0;
    double floorForce = 0.0;
    Vec3 before = Vec3::Zero();
    for (int k = 0; k < 400 && floorForce == 0.0; ++k)
    {
        before = momentum(dynamics.grains());
        const nscd::StepReport report = run(dynamics, 1);
        most = std::max(most, report.asleep);
        if (dynamics.contactForce()[stackedGrains].norm() == 0.0) continue;
        EXPECT_EQ(report.asleep, static_cast<std::size_t>(stackedGrains - firstStack)) << "step " << k;
        floorForce = -dynamics.wallForce()[0][2];
    }
    EXPECT_EQ(most, static_cast<std::size_t>(stackedGrains));
    // Struck in this step, and awake in it: what it lost, the stack and the floor got.
    const double all = weightOfAll(dynamics.grains());
    EXPECT_NEAR(momentum(dynamics.grains())[2] - before[2], (floorForce - all)*deltaT, 1e-4*all*deltaT);
    EXPECT_GT(floorForce, 2*all);
}

TEST_P(ClumpSleep, aMovedWallWakes)
{
    Scene scene = clumpStacks(GetParam());
    const double start = 0.3;
    scene.walls.setMotion(0, [=](double time)
    {
        nscd::WallPose pose = nscd::WallPose::Identity();
        if (time > start) pose.translation() = Vec3(0, 0, 0.2*(time - start));
        return pose;
    });
    nscd::GrainDynamics dynamics = scene.build(fineEnoughToSleep());
    EXPECT_EQ(run(dynamics, 299).asleep, static_cast<std::size_t>(stackedGrains));
    EXPECT_EQ(run(dynamics, 2).asleep, 0u);
    EXPECT_NEAR(dynamics.grains().clumps.velocity[0][2], 0.2, 1e-3);
    EXPECT_NEAR(dynamics.grains().clumps.velocity[1][2], 0.2, 1e-3);
}

TEST_P(ClumpSleep, whatWakesMovesLikeWhatNeverSlept)
{
    nscd::ContactSettings awake = fineEnoughToSleep();
    awake.sleep = false;
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics never = clumpStacks(GetParam()).build(awake);
    EXPECT_EQ(run(never, 200).asleep, 0u);
    for (nscd::GrainDynamics* dynamics : {&sleepers.dynamics, &never})
    {
        for (int k = 0; k < 40; ++k)
        {
            nscd::ExternalForces forces = still(*dynamics);
            // Up and aside, spinning, and down again onto the cube.
            forces.force[dumbbellBall] += gravity*dynamics->grains().clumps.shapeOf(1).mass*(k < 20 ? Vec3(5, 0, 20) : Vec3(0, 0, -40));
            forces.torque.assign(dynamics->grains().size(), Vec3::Zero());
            if (k < 20) forces.torque[dumbbellBall] = gravity*dynamics->grains().clumps.shapeOf(1).mass*r*Vec3(0, 0, 5);
            stepWith(*dynamics, forces);
        }
    }
    const nscd::Grains &woken = sleepers.dynamics.grains(), &neverSlept = never.grains();
    EXPECT_GT(neverSlept.position[dumbbellBall][0], 0.0);
    EXPECT_GT(std::abs(neverSlept.clumps.orientation[1].z()), 0.1);
    EXPECT_LT(largestMove(woken, neverSlept), 1e-3*r);
}

TEST_P(ClumpSleep, aStopAndItsContinuationDoTheSameToTheBit)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    run(dynamics, 5);  // so that the stop is at no multiple of anything
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = dynamics.checkpoint(lastDeltaT);
    Scene again = clumpStacks(GetParam());
    again.grains = dynamics.grains();
    nscd::GrainDynamics later = again.build(fineEnoughToSleep());
    later.restore(impulses, lastDeltaT);
    for (int k = 0; k < 120; ++k)
    {
        const std::size_t asleep = run(dynamics, 1).asleep;
        ASSERT_EQ(asleep, run(later, 1).asleep) << k;
        ASSERT_EQ(dynamics.grains().position, later.grains().position) << k;
        ASSERT_EQ(dynamics.grains().clumps.angularMomentum, later.grains().clumps.angularMomentum) << k;
    }
    EXPECT_EQ(run(dynamics, 1).asleep, static_cast<std::size_t>(stackedGrains));
}

TEST_P(ClumpSleep, predictionsAndTrials)
{
    Sleepers sleepers(GetParam());
    nscd::GrainDynamics& dynamics = sleepers.dynamics;
    nscd::ExternalForces lifting = still(dynamics);
    for (int k : {0, 1}) lifting.force[dumbbellBall + k] *= -1.0;
    dynamics.beginStep(deltaT);
    EXPECT_EQ(dynamics.tryForces(lifting).velocity[dumbbellBall], Vec3(0, 0, 0));
    const nscd::Prediction rest = dynamics.predict(still(dynamics));
    EXPECT_EQ(rest.velocity[dumbbellBall], Vec3(0, 0, 0));
    EXPECT_EQ(dynamics.advance(still(dynamics)).asleep, static_cast<std::size_t>(stackedGrains));
    EXPECT_EQ(rest.contactForce, dynamics.contactForce());
    dynamics.beginStep(deltaT);
    EXPECT_NEAR(dynamics.predict(lifting).velocity[dumbbellBall][2], gravity*deltaT, 1e-8);
    EXPECT_EQ(dynamics.advance(lifting).asleep, static_cast<std::size_t>(stackedGrains - firstStack));
}

namespace
{

constexpr int side = 3;

/// Cubes of balls in columns side by side between four walls, one on another; the last grain is a sphere in a hollow on top.
Scene cubes(const nscd::ContactPair& pair)
{
    Scene scene(3, 0.4, 0.0);
    setAll(scene, pair);
    scene.addOpenBox(4*r*side);
    const int shape = addShape(scene, cube());
    for (int k = 0; k < side*side*side; ++k) addClump(scene, shape, r*Vec3(4*(k % side) + 2, 4*(k/side % side) + 2, 4*(k/side/side) + 2));
    scene.addGrain(Vec3(2*r*side, 2*r*side, (4*side - 1 + std::sqrt(2.0))*r), r);
    return scene;
}

/// Pushed to and fro, the sphere on top never is at rest, and keeps awake what it stands on.
void expectNeighborhoodAwake(const nscd::ContactPair& pair)
{
    const Scene scene = cubes(pair);
    nscd::ContactSettings settings;
    settings.tolerance = 1e-5;
    nscd::GrainDynamics sleeping = scene.build(settings);
    settings.sleep = false;
    nscd::GrainDynamics awake = scene.build(settings);
    const std::size_t n = scene.grains.size();
    std::size_t most = 0, least = n;
    for (int k = 0; k < 300; ++k)
    {
        for (nscd::GrainDynamics* dynamics : {&sleeping, &awake})
        {
            nscd::ExternalForces forces = still(*dynamics);
            forces.force.back()[0] += 0.01*std::sin(0.37*k)*gravity*scene.grains.mass.back();
            const std::size_t asleep = stepWith(*dynamics, forces).asleep;
            if (dynamics != &sleeping || k < 200) continue;
            most = std::max(most, asleep);
            least = std::min(least, asleep);
        }
    }
    EXPECT_LT(most, n);
    EXPECT_GT(most, n*3/4);
    EXPECT_GT(least, 0u);
    EXPECT_EQ(most % 8, 0u) << "clumps sleep as wholes";
    expectBalance(sleeping);
    EXPECT_LT(largestMove(sleeping.grains(), awake.grains()), 1e-4*r);
    EXPECT_LT(largestMove(sleeping.grains(), scene.grains), 1e-2*r);
}

} // namespace

TEST(ClumpsPartlyAsleep, aRestlessGrainKeepsThoseAroundItAwake) { expectNeighborhoodAwake({0.4, 0.0}); }
TEST(ClumpsPartlyAsleep, alsoWithCohesion) { expectNeighborhoodAwake(cohesivePair(0.4, 0.0, 1e-3)); }
TEST(ClumpsPartlyAsleep, alsoWithRestitution) { expectNeighborhoodAwake({0.4, 0.5}); }

TEST(ClumpLoads, matterByTheMotionThatTheyWouldMake)
{
    Scene scene(3, 0.5, 0.0);
    const int rod = addShape(scene, {{Vec3(-4*r, 0, 0), r}, {Vec3(-2*r, 0, 0), r}, {Vec3::Zero(), r}, {Vec3(2*r, 0, 0), r}, {Vec3(4*r, 0, 0), r}});
    addClump(scene, rod, Vec3::Zero(), Quaternion(Eigen::AngleAxisd(M_PI/2, Vec3::UnitZ())));   // along y
    const nscd::ClumpShape& shape = scene.grains.clumps.shapes[0];
    const double speed = 1e-3, force = shape.mass*speed/deltaT;
    const auto small = [&](const Vec3& f, const Vec3& t) { return nscd::isSmall(scene.grains, 0, {f, t}, speed, deltaT); };
    EXPECT_TRUE(small(Vec3(0.99*force, 0, 0), Vec3::Zero()));
    EXPECT_FALSE(small(Vec3(0, 1.01*force, 0), Vec3::Zero()));
    // About its axis the surface goes r w; across, an end 4 r w and the ball there r w: at most 5/2 of the speed.
    const double along = 2.5*speed/r*shape.inertia(0, 0)/deltaT, across = 2.5*speed/(5*r)*shape.inertia(1, 1)/deltaT;
    EXPECT_TRUE(small(Vec3::Zero(), Vec3(0, 0.99*along, 0)));
    EXPECT_FALSE(small(Vec3::Zero(), Vec3(0, 1.01*along, 0)));
    EXPECT_TRUE(small(Vec3::Zero(), Vec3(0, 0, 0.99*across)));
    EXPECT_FALSE(small(Vec3::Zero(), Vec3(1.01*across, 0, 0)));
    EXPECT_FALSE(small(Vec3(NAN, 0, 0), Vec3::Zero()));
    EXPECT_FALSE(small(Vec3::Zero(), Vec3(NAN, 0, 0)));
}
