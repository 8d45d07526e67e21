// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that are held, and grains driven with a velocity given step by step.
#include "unit/nscd/scenes/heaps.hpp"

#include "nscd/tools/drivenGrains.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

} // namespace

TEST(Driven, goesWhereItsVelocityLeads)
{
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3(0, 0, 1), radius);
    scene.grains.isFixed[0] = 1;
    auto dynamics = scene.build();
    Vec3 expected(0, 0, 1);
    for (int k = 0; k < 1000; ++k)
    {
        // The mean of v = cos(t) over each step, of which the position is the integral.
        const double from = k*deltaT, mean = (std::sin(from + deltaT) - std::sin(from))/deltaT;
        dynamics.drive(0, Vec3(mean, 0, 0), Vec3(0, 3.0, 0));
        step(dynamics, scene.g, deltaT);
    }
    expected[0] = std::sin(1.0);
    EXPECT_LT((dynamics.grains().position[0] - expected).norm(), 1e-13);
    const nscd::Quaternion turned(Eigen::AngleAxisd(3.0, Vec3::UnitY()));
    EXPECT_LT(dynamics.grains().orientation[0].angularDistance(turned), 1e-10);
}

TEST(Driven, heldIsDrivenWithZero)
{
    Scene scene(3, 0.5, 0.0);
    scene.addGrain(Vec3(0, 0, 0), radius);
    scene.addGrain(Vec3(0, 0, 2*radius), radius);
    scene.grains.isFixed[0] = 1;
    auto dynamics = scene.build();
    for (int k = 0; k < 100; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_EQ(dynamics.grains().position[0], Vec3(0, 0, 0));
    EXPECT_NEAR(dynamics.contactForce()[0][2], -scene.grains.mass[1]*gravity, 1e-9*scene.grains.mass[1]*gravity);
}

TEST(Driven, pushesWithInertiaAndFriction)
{
    // A grain on a floor pushed from behind by a driven one without friction between them: F = m dv/dt + friction with the floor,
    // while it slides (mu g < kappa dv/dt).
    Scene scene(3, 0.0, 0.0);
    const double mu = 0.2;
    scene.materials.setPair(0, 1, {mu, 0.0});
    scene.addGrain(Vec3(0, 0, radius), radius);
    scene.addGrain(Vec3(2*radius, 0, radius), radius);
    scene.grains.isFixed[0] = 1;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const double acceleration = 20.0, mass = scene.grains.mass[1];
    auto dynamics = scene.build();
    for (int k = 1; k <= 50; ++k)
    {
        dynamics.drive(0, Vec3(acceleration*k*deltaT, 0, 0), Vec3::Zero());
        step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.grains().velocity[1][0], acceleration*k*deltaT, 1e-12);
        EXPECT_NEAR(dynamics.contactForce()[0][0], -mass*(acceleration + mu*gravity), 1e-8*mass*gravity);
    }
}

TEST(Driven, aTurningGrainTakesTheTorqueOfWhatItTurns)
{
    // A grain rests on a driven, turning one, held in place by frictionless walls: the torque on the driver is friction times
    // radius, opposite to its spin.
    Scene scene(3, 0.0, 0.0);
    const double mu = 0.3;
    scene.materials.setPair(0, 0, {mu, 0.0});
    scene.addGrain(Vec3(0, 0, 0), radius);
    scene.addGrain(Vec3(0, 0, 2*radius), radius);
    scene.grains.isFixed[0] = 1;
    scene.addPlane(Vec3(radius, 0, 0), -Vec3::UnitX());
    scene.addPlane(Vec3(-radius, 0, 0), Vec3::UnitX());
    auto dynamics = scene.build();
    const double mass = scene.grains.mass[1];
    dynamics.drive(0, Vec3::Zero(), Vec3(0, 50.0, 0));
    for (int k = 0; k < 5; ++k)
    {
        step(dynamics, scene.g, deltaT);
        // Friction drives the upper grain's surface along: it spins up the other way round, held by the walls.
        EXPECT_NEAR(dynamics.contactForce()[0][2], -mass*gravity, 1e-8*mass*gravity);
        EXPECT_NEAR(dynamics.contactTorque()[0][1], -mu*mass*gravity*radius, 1e-8*mass*gravity*radius);
        EXPECT_NEAR(dynamics.contactTorque()[1][1], -mu*mass*gravity*radius, 1e-8*mass*gravity*radius);
    }
}

TEST(Driven, meetsGrainsFarAway)
{
    // Fast from one step to the next: lists are made for the velocity to come, and nothing is passed unseen.
    Scene scene(3, 0.0, 0.0);
    scene.addGrain(Vec3(0, 0, 0), radius);
    for (int i = 1; i < 6; ++i) scene.addGrain(Vec3(0.1*i, 0, 0), radius);
    scene.grains.isFixed[0] = 1;
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 40; ++k)
    {
        dynamics.drive(0, Vec3(k < 5 ? 0.0 : 20.0, 0, 0), Vec3::Zero());
        EXPECT_TRUE(step(dynamics, Vec3::Zero(), deltaT).solve.converged);
    }
    const nscd::Grains& grains = dynamics.grains();
    EXPECT_NEAR(grains.position[0][0], 35*20.0*deltaT, 1e-12);
    for (int i = 1; i < 6; ++i) EXPECT_GE(grains.position[i][0] - grains.position[i - 1][0], 2*radius - 1e-5*radius) << i;
}

TEST(Driven, onlyHeldGrains)
{
    Scene scene(3, 0.0, 0.0);
    scene.addGrain(Vec3(0, 0, 0), radius);
    auto dynamics = scene.build();
    EXPECT_THROW(dynamics.drive(0, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
    EXPECT_THROW(dynamics.drive(1, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
    scene.grains.isFixed[0] = 1;
    auto held = scene.build();
    EXPECT_THROW(held.drive(0, Vec3(NAN, 0, 0), Vec3::Zero()), std::invalid_argument);
}

TEST(Driven, groupsFollowFunctionsOfTime)
{
    // Two Gauss points a step integrate a cubic velocity exactly; grains of other groups, and held ones of none, stay.
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 4; ++i) scene.addGrain(Vec3(0.1*i, 0, 0), radius);
    scene.grains.isFixed[3] = 1;
    const nscd::DrivenGrains group{{0, 2, 7}, [](double t) { return Vec3(4*t*t*t, 0, 1); }, [](double t) { return Vec3(0, t, 0); }};
    EXPECT_EQ(nscd::hold(group, scene.grains), 2u);
    EXPECT_EQ(scene.grains.isFixed, (std::vector<std::uint8_t>{1, 0, 1, 1}));
    auto dynamics = scene.build();
    for (int k = 0; k < 10; ++k)
    {
        nscd::drive(group, dynamics, 0.1*k, 0.1*(k + 1));
        step(dynamics, Vec3::Zero(), 0.1);
    }
    const nscd::Grains& grains = dynamics.grains();
    EXPECT_NEAR((grains.position[0] - Vec3(1, 0, 1)).norm(), 0, 1e-14);
    EXPECT_NEAR((grains.position[2] - Vec3(1.2, 0, 1)).norm(), 0, 1e-14);
    EXPECT_EQ(grains.position[1], Vec3(0.1, 0, 0));
    EXPECT_EQ(grains.position[3], scene.grains.position[3]);
    EXPECT_NEAR(grains.orientation[0].angularDistance(nscd::Quaternion(Eigen::AngleAxisd(0.5, Vec3::UnitY()))), 0, 1e-7);
}

TEST(Driven, groupsMustMoveAsGrainsCan)
{
    Scene scene(2, 0.3, 0.0);
    scene.grains.shape.emptyAxis = 2;
    auto dynamics = scene.build();   // no grain of the group is here: it is refused nevertheless, as on the rank that has it
    const auto refused = [&](const Vec3& velocity, const Vec3& omega)
    {
        const nscd::DrivenGrains group{{0}, [=](double) { return velocity; }, [=](double) { return omega; }};
        EXPECT_THROW(nscd::drive(group, dynamics, 0, 1), std::invalid_argument) << velocity.transpose() << ", " << omega.transpose();
    };
    refused(Vec3(0, 0, 1), Vec3::Zero());
    refused(Vec3(1, 0, 0), Vec3(1, 0, 0));
    refused(Vec3(NAN, 0, 0), Vec3::Zero());
    refused(Vec3(1, 0, 0), Vec3(0, 0, INFINITY));
}
