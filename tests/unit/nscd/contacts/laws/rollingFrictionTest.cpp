// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Rolling and spinning friction against closed formulas, balances and a judge of its own.
#include "unit/nscd/scenes/lawScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

/// A grain that touches a floor at rest.
Scene onFloor(int dimensions, const nscd::ContactPair& pair)
{
    Scene scene(dimensions, 0.0, 0.0);
    setAll(scene, pair);
    scene.addGrain(Vec3(0, 0, radius), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

Vec3 angularMomentum(const nscd::Grains& grains)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        sum += grains.mass[i]*grains.position[i].cross(grains.velocity[i]);
        sum += grains.shape.inertiaFactor()*grains.mass[i]*grains.radius[i]*grains.radius[i]*grains.omega[i];
    }
    return sum;
}

} // namespace

TEST(Rolling, slowsDownAsThePublishedLawSaysAndStopsForEver)
{
    // Moments about the point of contact: (1 + kappa) m R^2 domega/dt = -mu_r R m g, R the reduced radius at a wall.
    for (int dimensions : {2, 3})
    {
        const double rolling = 0.02, start = 0.1;
        Scene scene = onFloor(dimensions, rollingPair(0.5, rolling));
        scene.grains.velocity[0] = Vec3(start, 0, 0);
        scene.grains.omega[0] = Vec3(0, start/radius, 0);
        auto dynamics = scene.build();
        const double kappa = scene.grains.shape.inertiaFactor(), deceleration = rolling*gravity/(1.0 + kappa);
        const int steps = static_cast<int>(start/(deceleration*deltaT));
        for (int k = 1; k <= steps; ++k)
        {
            ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
            const double v = start - k*deltaT*deceleration;
            ASSERT_NEAR(dynamics.grains().velocity[0][0], v, 1e-11*start) << k;
            ASSERT_NEAR(dynamics.grains().omega[0][1]*radius, v, 1e-11*start) << k;
        }
        EXPECT_GT(dynamics.grains().velocity[0][0], 0.0);
        step(dynamics, scene.g, deltaT);
        const Vec3 rest = dynamics.grains().position[0];
        for (int k = 0; k < 500; ++k) step(dynamics, scene.g, deltaT);
        EXPECT_LT((dynamics.grains().position[0] - rest).norm(), 1e-12*radius);
        EXPECT_LT(dynamics.grains().velocity[0].norm() + radius*dynamics.grains().omega[0].norm(), 1e-14);
    }
}

TEST(Rolling, whatSlidesIsSpunUpAgainstIt)
{
    const double friction = 0.3, rolling = 0.1;
    Scene scene = onFloor(3, rollingPair(friction, rolling));
    scene.grains.velocity[0] = Vec3(0, 1.0, 0);
    auto dynamics = scene.build();
    for (int k = 1; k <= 50; ++k)
    {
        step(dynamics, scene.g, deltaT);
        const double time = k*deltaT;
        ASSERT_NEAR(dynamics.grains().velocity[0][1], 1.0 - friction*gravity*time, 1e-12);
        ASSERT_NEAR(dynamics.grains().omega[0][0]*radius, -(friction - rolling)*gravity*time/0.4, 1e-12);
    }
}

TEST(Rolling, spinningStopsExactly)
{
    const double spinning = 0.05, start = 20.0;
    Scene scene = onFloor(3, rollingPair(0.5, 0.0, spinning));
    scene.grains.omega[0] = Vec3(0, 0, start);
    auto dynamics = scene.build();
    const double deceleration = spinning*gravity/(0.4*radius);
    const int steps = static_cast<int>(start/(deceleration*deltaT));
    for (int k = 1; k <= steps; ++k)
    {
        step(dynamics, scene.g, deltaT);
        ASSERT_NEAR(dynamics.grains().omega[0][2], start - k*deltaT*deceleration, 1e-11*start);
        ASSERT_NEAR(dynamics.contactTorque()[0][2], -spinning*radius*scene.grains.mass[0]*gravity, 1e-12);
    }
    for (int k = 0; k < 10; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_LT(dynamics.grains().omega[0].norm(), 1e-13*start);
}

TEST(Rolling, aSlopeHoldsAGrainUpToTheCoefficient)
{
    // tan(slope) <= mu_r, and beyond it (1 + kappa) a = g sin(slope) - mu_r g cos(slope).
    for (int dimensions : {2, 3})
    {
        for (double share : {0.997, 1.003})
        {
            const double rolling = 0.1, slope = std::atan(share*rolling);
            Scene scene = onFloor(dimensions, rollingPair(0.5, rolling));
            scene.g = gravity*Vec3(std::sin(slope), 0, -std::cos(slope));
            auto dynamics = scene.build();
            for (int k = 0; k < 100; ++k) ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
            const double kappa = scene.grains.shape.inertiaFactor();
            const double expected = share < 1.0 ? 0.0 : (scene.g[0] + rolling*scene.g[2])/(1.0 + kappa)*100*deltaT;
            EXPECT_NEAR(dynamics.grains().velocity[0][0], expected, 1e-12) << dimensions << "D, " << share;
        }
    }
}

TEST(Rolling, withoutFrictionItStopsSpinsAlone)
{
    Scene scene = onFloor(3, rollingPair(0.0, 0.02));
    scene.grains.velocity[0] = Vec3(0.1, 0, 0);
    scene.grains.omega[0] = Vec3(0, 10.0, 0);
    auto dynamics = scene.build();
    for (int k = 0; k < 10; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(dynamics.grains().velocity[0][0], 0.1, 1e-15);
    EXPECT_NEAR(dynamics.grains().omega[0][1], 10.0 - 0.02*gravity*10*deltaT/(0.4*radius), 1e-10);
}

TEST(Rolling, aContactThatSticksIsSolvedAtOnce)
{
    // Friction and rolling of unequal grains together, in one visit: the second sweep finds nothing to do.
    Scene scene(3, 0.0, 0.0);
    setAll(scene, rollingPair(5.0, 0.1, 0.1, 1.0));
    scene.addGrain(Vec3::Zero(), radius);
    scene.addGrain(Vec3(0, 3.0*radius, 0), 2.0*radius);
    scene.grains.omega = {Vec3(3.0, 1.0, -2.0), Vec3(-1.0, 0.5, 4.0)};
    scene.grains.velocity[0] = Vec3(1e-3, 0, 2e-3);
    auto dynamics = scene.build();
    EXPECT_LE(step(dynamics, Vec3::Zero(), deltaT).solve.sweeps, 2);
}

TEST(Rolling, actionIsReaction)
{
    // Pairs of unequal grains that stick together by cohesion, with spins at random: momentum and its moment stay, energy falls.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    for (int trial = 0; trial < 30; ++trial)
    {
        Scene scene(3, 0.0, 0.0);
        setAll(scene, rollingPair(0.2 + 0.2*unit(random), 0.1, 0.05, 0.5));
        const double other = radius*(1.0 + 0.8*unit(random));
        scene.addGrain(Vec3(0.1, 0.2, 0.3), radius);
        scene.addGrain(Vec3(0.1, 0.2, 0.3) + (radius + other)*vector().normalized(), other);
        for (int i = 0; i < 2; ++i)
        {
            scene.grains.velocity[i] = 0.01*vector();
            scene.grains.omega[i] = 5.0*vector();
        }
        auto dynamics = scene.build();
        EXPECT_TRUE(step(dynamics, Vec3::Zero(), deltaT).solve.converged);
        const std::vector<nscd::LoadedContact> contacts = dynamics.contacts();
        ASSERT_EQ(contacts.size(), 1u);
        EXPECT_GT(contacts[0].moment.norm(), 0.0);
        const Vec3 before = angularMomentum(scene.grains);
        double scale = 0.0;
        for (int i = 0; i < 2; ++i) scale += scene.grains.mass[i]*(0.4*0.01 + radius*radius*5.0);
        EXPECT_LT((angularMomentum(dynamics.grains()) - before).norm(), 1e-14*scale);
        EXPECT_LT(nscd::kineticEnergy(dynamics.grains()), nscd::kineticEnergy(scene.grains));
        const double mr = 0.1*radius*other/(radius + other)*(contacts[0].impulse - contacts[0].attraction).norm();
        EXPECT_LE((contacts[0].moment - contacts[0].moment.dot(contacts[0].normal)*contacts[0].normal).norm(), mr*(1 + 1e-9));
    }
}

TEST(Rolling, aPairThatTurnsAsOneFeelsNone)
{
    // Equal angular velocities, that of the line of centers too: rigid motion.
    Scene scene(3, 0.0, 0.0);
    setAll(scene, rollingPair(0.5, 0.1, 0.1, 1.0));
    scene.addGrain(Vec3(-radius, 0, 0), radius);
    scene.addGrain(Vec3(radius, 0, 0), radius);
    for (int i = 0; i < 2; ++i)
    {
        scene.grains.omega[i] = Vec3(3.0, 0, 2.0);
        scene.grains.velocity[i] = Vec3(0, (i == 0 ? -1 : 1)*2.0*radius, 0);
    }
    auto dynamics = scene.build();
    step(dynamics, Vec3::Zero(), deltaT);
    ASSERT_EQ(dynamics.contacts().size(), 1u);
    EXPECT_LT(dynamics.contacts()[0].moment.norm(), 1e-15*scene.grains.mass[0]*radius);
    EXPECT_NEAR(dynamics.grains().omega[0][2], 2.0, 1e-13);
}

TEST(Rolling, momentsAreRememberedAndScaleWithTheStep)
{
    // A grain held on a slope by its rolling moment: warm, nothing is left to do.
    Scene scene = onFloor(3, rollingPair(0.5, 0.1));
    scene.g = gravity*Vec3(0.09, 0, -1);
    nscd::ContactSettings settings;
    settings.polishSweeps = 0;
    settings.tolerance = settings.displacementTolerance = 1e-9;
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 5; ++k) step(dynamics, scene.g, deltaT);
    for (double factor : {0.1, 3.0, 1.0}) EXPECT_EQ(step(dynamics, scene.g, factor*deltaT).solve.sweeps, 1) << factor;
    // And through a list built anew.
    double lastDeltaT = 0.0;
    dynamics.checkpoint(lastDeltaT);
    EXPECT_EQ(step(dynamics, scene.g, deltaT).solve.sweeps, 1);
}

TEST(Rolling, refusesWhatItCannot)
{
    nscd::Materials materials;
    materials.add("one");
    EXPECT_THROW(materials.setPair(0, 0, rollingPair(0.3, -0.1)), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 0, rollingPair(0.3, 0.1, std::nan(""))), std::invalid_argument);
    nscd::ContactSettings settings;
    settings.solver = "queue";
    EXPECT_THROW(onFloor(3, rollingPair(0.3, 0.1)).build(settings), std::invalid_argument);
}

/// A plane that turns about its normal below the grain: mu_s R m g = kappa m R^2 domega/dt until the grain turns with it.
TEST(Rolling, aTurningWallTakesAGrainAlong)
{
    const double spinning = 0.05, turning = 20.0;
    for (const bool movesAsABody : {true, false})
    {
        Scene scene = onFloor(3, rollingPair(0.5, 0.0, spinning));
        if (movesAsABody) scene.walls.setMotion(0, nscd::rotation(Vec3::Zero(), Vec3::UnitZ(), turning));
        else scene.walls.setSurfaceMotion(0, nscd::turningSurface(Vec3::Zero(), Vec3(0, 0, turning)));
        auto dynamics = scene.build();
        const double acceleration = spinning*gravity/(0.4*radius), torque = spinning*radius*scene.grains.mass[0]*gravity;
        const int steps = static_cast<int>(turning/(acceleration*deltaT));
        ASSERT_GT(steps, 100);
        for (int k = 1; k <= steps; ++k)
        {
            ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
            ASSERT_NEAR(dynamics.grains().omega[0][2], k*deltaT*acceleration, 1e-11*turning) << k;
            ASSERT_NEAR(dynamics.contactTorque()[0][2], torque, 1e-10*torque);
            ASSERT_NEAR(dynamics.wallTorque()[0][2], -torque, 1e-10*torque);
        }
        for (int k = 0; k < 10; ++k) step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.grains().omega[0][2], turning, 1e-11*turning);
        EXPECT_NEAR(dynamics.contactTorque()[0][2], 0, 1e-8*torque);
        EXPECT_LT(dynamics.grains().velocity[0].norm(), 1e-12);
    }
}

/// A surface that turns about an axis in its plane, through the point of contact: mu_r R m g = kappa m R^2 domega/dt about that axis.
TEST(Rolling, aRollerTakesAGrainAlong)
{
    const double rolling = 0.05, turning = 20.0;
    for (int dimensions : {2, 3})
    {
        Scene scene = onFloor(dimensions, rollingPair(0.0, rolling));
        scene.grains.shape.emptyAxis = dimensions == 2 ? 1 : -1;
        scene.walls.setSurfaceMotion(0, nscd::turningSurface(Vec3::Zero(), Vec3(0, turning, 0)));
        auto dynamics = scene.build();
        const double acceleration = rolling*gravity/(scene.grains.shape.inertiaFactor()*radius);
        for (int k = 1; k <= 100; ++k)
        {
            ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
            ASSERT_NEAR(dynamics.grains().omega[0][1], k*deltaT*acceleration, 1e-11*turning) << k;
        }
        for (int k = 0; k < 500; ++k) step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.grains().omega[0][1], turning, 1e-11*turning);
    }
}
