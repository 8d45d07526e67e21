// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cohesion in motion: pairs that turn and fall, energy, range, heaps judged by code of its own, restart.
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"
#include "unit/nscd/scenes/restarts.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

double massOfOne()
{
    Scene scene(3, 0.0, 0.0);
    scene.addGrain(Vec3::Zero(), radius);
    return scene.grains.mass[0];
}

double angularMomentumZ(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        sum += grains.mass[i]*(grains.position[i].cross(grains.velocity[i])[2] + 0.4*grains.radius[i]*grains.radius[i]*grains.omega[i][2]);
    }
    return sum;
}

/// Two touching grains that turn about each other as one body with angular velocity omega.
Scene turningPair(double omega, double cohesion)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, cohesivePair(0.5, 0.0, cohesion));
    for (int side : {-1, 1})
    {
        scene.addGrain(Vec3(side*radius, 0, 0), radius);
        scene.grains.velocity.back() = Vec3(0, side*radius*omega, 0);
        scene.grains.omega.back() = Vec3(0, 0, omega);
    }
    return scene;
}

double distance(const nscd::Grains& grains, int i, int j) { return (grains.position[i] - grains.position[j]).norm(); }

} // namespace

TEST(Cohesion, aPairTurnsTogetherUpToItsCentrifugalForce)
{
    // Without friction, and driven round ever faster by a couple: it parts at m omega^2 R = c, in steps of 0.04 rad, in which straight
    // motion opens the gap by four times the dead band.
    const double mass = massOfOne(), limit = 40.0, push = mass*radius*20.0;
    Scene scene = turningPair(0.0, mass*limit*limit*radius);
    setAll(scene, cohesivePair(0.0, 0.0, mass*limit*limit*radius));
    auto dynamics = scene.build();
    double omega = 0.0;
    for (int k = 0; k < 4000 && distance(dynamics.grains(), 0, 1) < 2.01*radius; ++k)
    {
        const Vec3 arm = (dynamics.grains().position[1] - dynamics.grains().position[0])/(2.0*radius);
        omega = arm.cross(dynamics.grains().velocity[1] - dynamics.grains().velocity[0])[2]/(2.0*radius);
        nscd::ExternalForces forces;
        forces.force = {-push*Vec3::UnitZ().cross(arm), push*Vec3::UnitZ().cross(arm)};
        forces.speedScale = push/mass*deltaT;
        dynamics.beginStep(deltaT);
        ASSERT_TRUE(dynamics.advance(forces).solve.converged);
    }
    EXPECT_GT(distance(dynamics.grains(), 0, 1), 2.01*radius);
    EXPECT_NEAR(omega, limit, 0.01*limit);
}

TEST(Cohesion, aTurningPairKeepsItsAngularMomentum)
{
    const Scene scene = turningPair(10.0, 1.0);
    auto dynamics = scene.build();
    const double before = angularMomentumZ(scene.grains), energy = nscd::kineticEnergy(scene.grains);
    for (int k = 0; k < 2000; ++k) step(dynamics, Vec3::Zero(), deltaT);
    EXPECT_NEAR(angularMomentumZ(dynamics.grains()), before, 1e-3*before);
    EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), energy, 2e-3*energy);
    EXPECT_NEAR(distance(dynamics.grains(), 0, 1), 2.0*radius, 2e-3*radius);
}

TEST(Cohesion, aPairThatFallsStaysOne)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, cohesivePair(0.3, 0.0, 1e-3*gravity*massOfOne()));
    scene.addGrain(Vec3(0, 0, 1), radius);
    scene.addGrain(Vec3(2.0*radius, 0, 1), radius);
    auto dynamics = scene.build();
    for (int k = 0; k < 200; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(distance(dynamics.grains(), 0, 1), 2.0*radius, 1e-12);
    EXPECT_NEAR(dynamics.grains().velocity[0][2], -gravity*0.2, 1e-12);
    EXPECT_LT(dynamics.contactForce()[0].norm(), 1e-9*gravity*massOfOne());
}

TEST(Cohesion, actsWithinItsRange)
{
    // Two grains at rest one tenth of a radius apart fall together with c/m each; beyond the range they do not.
    const double gap = 0.1*radius, cohesion = 0.1;
    for (double range : {0.9*gap, 1.1*gap})
    {
        Scene scene(3, 0.0, 0.0);
        setAll(scene, cohesivePair(0.0, 0.0, cohesion, range));
        scene.addGrain(Vec3(0, 0, 0), radius);
        scene.addGrain(Vec3(2.0*radius + gap, 0, 0), radius);
        auto dynamics = scene.build();
        const double mass = scene.grains.mass[0];
        for (int k = 0; k < 3; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_NEAR(dynamics.grains().velocity[0][0], range > gap ? 3.0*deltaT*cohesion/mass : 0.0, 1e-12);
        for (int k = 0; k < 60; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_NEAR(distance(dynamics.grains(), 0, 1), range > gap ? 2.0*radius : 2.0*radius + gap, 1e-9*radius);
    }
}

TEST(Cohesion, neverCreatesEnergy)
{
    // A gas whose grains collide, stick, turn and come off again; a pair in range holds -c (range - gap). Grains that pass each other in
    // range move straight in a force that turns: c |dx_t|^2/(2 D) a step and pair, 1e-8 J here, which nothing can build up on.
    for (double range : {0.0, 0.2*radius})
    {
        Scene scene = heap(3, 5, 5, radius, 0.7, 0.0);
        const double cohesion = 5e-3;
        setAll(scene, cohesivePair(0.3, range > 0.0 ? 0.7 : 0.0, cohesion, range));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (Vec3& v : scene.grains.velocity) v = 0.3*Vec3(unit(random), unit(random), unit(random));
        scene.walls = nscd::Walls();
        scene.box.length = Vec3::Constant(5*2.3*radius);
        nscd::ContactSettings settings;
        settings.tolerance = 1e-6;
        auto dynamics = scene.build(settings);
        const double start = nscd::kineticEnergy(dynamics.grains());
        double before = start, rise = 0.0;
        std::size_t bonds = 0;
        for (int k = 0; k < 300; ++k)
        {
            step(dynamics, Vec3::Zero(), deltaT);
            double energy = nscd::kineticEnergy(dynamics.grains());
            for (const auto& x : dynamics.grains().position)
            {
                for (const auto& y : dynamics.grains().position)
                {
                    if (&x <= &y) continue;
                    const std::size_t i = &x - dynamics.grains().position.data(), j = &y - dynamics.grains().position.data();
                    const double gap = scene.box.nearestImage(x - y).norm() - dynamics.grains().radius[i] - dynamics.grains().radius[j];
                    energy -= cohesion*std::max(0.0, range - gap);
                }
            }
            bonds = dynamics.contacts().size();
            if (k > 0) rise = std::max(rise, energy - before);
            before = energy;
        }
        std::printf("   range %.1e m: energy %.2e J of %.2e left, largest rise in a step %.1e, %zu contacts\n", range, before, start, rise, bonds);
        EXPECT_GT(bonds, 20u);
        EXPECT_LT(rise, range > 0.0 ? 1e-5*start : 1e-12*start);
        EXPECT_LT(before, 0.2*start);
    }
}

TEST(Cohesion, aJudgeOfItsOwnAgrees)
{
    Scene scene = heap(3, 4, 5, radius, 0.5, 0.4);
    setAll(scene, cohesivePair(0.4, 0.0, 2.0*gravity*massOfOne()));
    nscd::ContactSettings settings;
    settings.polishSweeps = 0;
    auto dynamics = scene.build(settings);
    const double diameter = meanDiameter(scene.grains);
    for (int k = 0; k < 200; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        ASSERT_TRUE(report.solve.converged) << k;
        if (report.solve.contacts < 10) continue;
        const NaturalMap map = Judge(scene, 0.4, settings.deadBand*diameter, deltaT)(before, dynamics);
        // Contacts that attract and bear nothing count for the judge alone.
        const double norm = report.solve.residualRms*std::sqrt(static_cast<double>(report.solve.contacts));
        ASSERT_NEAR(map.norm, norm, 1e-6*norm + 1e-14*gravity*deltaT) << k;
    }
}

TEST(Cohesion, aTrialThatClosesAGapMakesNoBond)
{
    // Within one step two grains would meet; the prediction loads their contact, and yet it does not attract before it is closed.
    Scene scene(3, 0.0, 0.0);
    setAll(scene, cohesivePair(0.0, 0.0, 1.0));
    scene.addGrain(Vec3(0, 0, 0), radius);
    scene.addGrain(Vec3(2.05*radius, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(1.0, 0, 0);
    auto plain = scene.build(), tried = scene.build();
    step(plain, Vec3::Zero(), deltaT);
    tried.beginStep(deltaT);
    EXPECT_GT(tried.predict({}).contactForce[0].norm(), 0.0);
    tried.beginStep(deltaT);
    tried.advance({});
    EXPECT_EQ(tried.grains().velocity[0], plain.grains().velocity[0]);
    EXPECT_EQ(tried.contacts()[0].attraction, Vec3(Vec3::Zero()));
    step(tried, Vec3::Zero(), deltaT);
    EXPECT_GT(tried.contacts()[0].attraction.norm(), 0.0);
}

TEST(Cohesion, restartsToTheBit)
{
    Scene scene = heap(3, 4, 4, radius, 0.7, 0.4);
    setAll(scene, cohesivePair(0.4, 0.3, 2.0*gravity*massOfOne()));
    scene.g = gravity*Vec3(0.5, 0.1, -0.86);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 100; ++k) step(dynamics, scene.g, deltaT);
    expectSameAfterRestart(dynamics, scene, deltaT, 40);
}
