// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps that resist rolling: of one ball they move as grains do, of two they stay or roll on a slope as the law says; balances, rest, sleep, restart.
#include "unit/nscd/scenes/clumpMap.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/scenes/restarts.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, r = memberRadius;

/// A body that slides, rolls and spins towards another one at rest, on a plane.
Scene slide(bool first, bool second, const nscd::ContactPair& pair)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, pair);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const Vec3 velocity(0.4, 0.05, 0), omega(5, -3, 60);
    const int shape = addShape(scene, {{Vec3::Zero(), r}}), small = addShape(scene, {{Vec3::Zero(), 0.7*r}});
    if (first) addClump(scene, shape, Vec3(0, 0, r), Quaternion::Identity(), velocity, omega);
    else
    {
        scene.addGrain(Vec3(0, 0, r), r);
        scene.grains.velocity.back() = velocity;
        scene.grains.omega.back() = omega;
    }
    if (second) addClump(scene, small, Vec3(5*r, 0.8*r, 0.7*r));
    else scene.addGrain(Vec3(5*r, 0.8*r, 0.7*r), 0.7*r);
    return scene;
}

} // namespace

TEST(ClumpRolling, clumpsOfOneBallMoveAsGrainsDo)
{
    for (const nscd::ContactPair& pair : {rollingPair(0.4, 0.05, 0.0), rollingPair(0.4, 0.05, 0.02), rollingPair(0.05, 0.2, 0.1)})
    for (const auto& [first, second] : {std::pair(true, true), std::pair(true, false), std::pair(false, true)})
    {
        const Scene scene = slide(first, second, pair);
        auto clumps = scene.build(), grains = slide(false, false, pair).build();
        bool haveMet = false;
        for (int k = 0; k < 300; ++k)
        {
            for (nscd::GrainDynamics* dynamics : {&clumps, &grains}) step(*dynamics, scene.g, deltaT);
            for (const nscd::LoadedContact& contact : grains.contacts()) haveMet = haveMet || contact.b >= 0;
            for (int i : {0, 1})
            {
                ASSERT_LT((clumps.grains().position[i] - grains.grains().position[i]).norm(), 1e-7*r) << k << " " << i;
                ASSERT_LT((clumps.grains().omega[i] - grains.grains().omega[i]).norm(), 1e-5) << k << " " << i;
            }
        }
        EXPECT_TRUE(haveMet);
    }
}

namespace
{

/// The acceleration down a slope of a dumbbell that lies across it, from the fall-line velocity after some steps [m/s2].
double accelerationOnSlope(double angle, double rolling)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, rollingPair(0.9, rolling, 0.0));
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.g = gravity*Vec3(0, std::sin(angle), -std::cos(angle));
    addClump(scene, addShape(scene, dumbbell(3.0)), Vec3(0, 0, r));
    auto dynamics = scene.build();
    for (int k = 0; k < 50; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(dynamics.grains().clumps.position[0][2], r, 1e-9);
    return dynamics.grains().clumps.velocity[0][1]/(50*deltaT);
}

} // namespace

TEST(ClumpRolling, aDumbbellOnASlopeStaysOrRollsAboutItsAxisAsTheLawSays)
{
    const double rolling = 0.2, limit = std::atan(rolling);
    EXPECT_LT(std::abs(accelerationOnSlope(0.99*limit, rolling)), 1e-8);
    for (const double angle : {1.01*limit, 1.5*limit})
    {
        // m a = m g sin - friction, J a/R = R friction - R mu_r m g cos, J = 2/5 m R^2.
        const double expected = gravity*(std::sin(angle) - rolling*std::cos(angle))/1.4;
        EXPECT_NEAR(accelerationOnSlope(angle, rolling), expected, 1e-6*gravity) << angle;
    }
    EXPECT_NEAR(accelerationOnSlope(0.5*limit, 0.0), gravity*std::sin(0.5*limit)/1.4, 1e-6*gravity);
}

TEST(ClumpRolling, aHeapBalancesMomentsAndMeetsItsRules)
{
    Scene scene = clumpHeap(18, 3, 0.4);
    setAll(scene, rollingPair(0.4, 0.1, 0.05));
    auto dynamics = scene.build(nscd::ContactSettings());
    double largest = 0.0;
    for (int k = 0; k < 300; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        ASSERT_TRUE(report.solve.converged) << k;
        for (std::size_t c = 0; c < before.clumps.size(); ++c)
        {
            const nscd::ClumpShape& shape = before.clumps.shapeOf(c);
            Vec3 change = dynamics.grains().clumps.angularMomentum[c] - before.clumps.angularMomentum[c];
            for (std::size_t m = 0; m < shape.members.size(); ++m)
            {
                const std::size_t i = before.clumps.firstMember[c] + m;
                const Vec3 arm = before.clumps.orientation[c]*shape.members[m].center;
                change -= deltaT*(dynamics.contactTorque()[i] + arm.cross(dynamics.contactForce()[i]));
            }
            ASSERT_LT(change.norm(), 1e-10*shape.mass*gravity*r) << k;
        }
        for (const nscd::LoadedContact& contact : dynamics.contacts())
        {
            const double radius = before.radius[contact.a], other = contact.radiusB, reduced = other > 0.0 ? radius*other/(radius + other) : radius;
            // As it was when the step was solved.
            const Vec3 n = contact.b < 0 ? contact.normal : Vec3((before.position[contact.a] - before.position[contact.b]).normalized());
            const double pressure = n.dot(contact.impulse), along = n.dot(contact.moment);
            const double noise = 20.0*reduced*before.mass[contact.a]*report.solve.residualMax;   // what the solve leaves, times J/R'^2
            ASSERT_LE(std::abs(along), 0.05*reduced*pressure + noise);
            ASSERT_LE((contact.moment - along*n).norm(), 0.1*reduced*pressure + noise);
            largest = std::max(largest, contact.moment.norm()/(reduced*std::max(pressure, 1e-9)));
        }
    }
    EXPECT_GT(largest, 0.05);
}

TEST(ClumpRolling, restsSleepsAndGoesOnToTheBit)
{
    Scene scene = clumpHeap(9, 3, 0.4);
    setAll(scene, rollingPair(0.4, 0.3, 0.1));
    auto dynamics = scene.build(nscd::ContactSettings());
    std::size_t asleep = 0;
    for (int k = 0; k < 1500 && asleep < scene.grains.size(); ++k) asleep = step(dynamics, scene.g, deltaT).asleep;
    EXPECT_EQ(asleep, scene.grains.size());
    double onFloor = 0.0;
    for (const Vec3& force : dynamics.wallForce()) onFloor -= force[2];
    EXPECT_NEAR(onFloor, gravity*totalMass(scene.grains), 0.02*gravity*totalMass(scene.grains));
    expectSameAfterRestart(dynamics, scene, deltaT, 100);
}
