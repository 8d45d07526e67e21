// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes made to break a contact library: fast grains, overlaps, coincident centers, wedges, bad values.
#include "unit/nscd/scenes/heaps.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

/// Height energy and kinetic energy.
double energy(const nscd::Grains& grains, const Vec3& g)
{
    double sum = nscd::kineticEnergy(grains);
    for (std::size_t i = 0; i < grains.size(); ++i) sum -= grains.mass[i]*g.dot(grains.position[i]);
    return sum;
}

Scene settled(Scene scene, int steps)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < steps; ++k) step(dynamics, scene.g, deltaT);
    scene.grains = dynamics.grains();
    return scene;
}

} // namespace

TEST(Stress, fastGrainDoesNotTunnelThroughAWall)
{
    for (double offset : {0.3, 0.77, 1.9, 45.1, 50.0})
    {
        Scene scene(3, 0.3, 0.0);
        scene.addGrain(Vec3(0, 0, radius*(1 + 2*offset)), radius);
        scene.grains.velocity[0] = Vec3(0, 0, -50*2*radius/deltaT);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        auto dynamics = scene.build();
        for (int k = 0; k < 3; ++k) step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.grains().position[0][2], radius, 3e-4*radius) << offset;
        EXPECT_LT(dynamics.grains().velocity[0].norm(), 1e-6);
    }
}

TEST(Stress, fastGrainDoesNotTunnelThroughAGrain)
{
    for (double e : {0.0, 1.0})
    {
        Scene scene(3, 0.0, e);
        scene.addGrain(Vec3::Zero(), radius);
        scene.addGrain(Vec3(60.3*radius, 0, 0), radius);
        scene.grains.velocity[1] = Vec3(-50*2*radius/deltaT, 0, 0);
        auto dynamics = scene.build();
        const double before = nscd::kineticEnergy(dynamics.grains());
        for (int k = 0; k < 3; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_LT(dynamics.grains().position[0][0], dynamics.grains().position[1][0]) << e;
        EXPECT_LT(dynamics.grains().velocity[0][0], -1.0) << e;
        EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), (e == 1.0 ? 1.0 : 0.5)*before, 1e-8*before);
    }
}

/// An oblique hit far away within the step: the normal is the one at the impact, as in an exact sweep.
TEST(Stress, fastGrainHitsAGrainAsideAtTheNormalOfTheImpact)
{
    for (double aside : {0.2, 0.7, 0.95})
    {
        for (double distance : {1.7, 12.0, 49.0, 77.0})
        {
            Scene scene(3, 0.0, 1.0);
            scene.box.length = Vec3(500*radius, 0, 0);
            scene.addGrain(Vec3(499*radius, 0, 0), radius);
            scene.addGrain(scene.box.wrap(2*radius*Vec3(distance - 0.5, aside, 0)), radius);
            const Vec3 start(-50*2*radius/deltaT, 0, 0);
            scene.grains.velocity[1] = start;
            auto dynamics = scene.build();
            for (int k = 0; k < 2; ++k) step(dynamics, Vec3::Zero(), deltaT);
            const Vec3 n(-std::sqrt(1 - aside*aside), -aside, 0);  // from the one that hits to the one that is hit
            const Vec3 kick = n.dot(start)*n;
            EXPECT_NEAR((dynamics.grains().velocity[0] - kick).norm(), 0.0, 1e-8*start.norm()) << aside << " " << distance;
            EXPECT_NEAR((dynamics.grains().velocity[1] - (start - kick)).norm(), 0.0, 1e-8*start.norm()) << aside << " " << distance;
        }
    }
}

TEST(Stress, fastGrainPassesWhatIsNotInItsWay)
{
    for (double aside : {1.01, 1.5, 4.0})
    {
        for (double distance : {1.7, 12.0, 49.0})
        {
            Scene scene(3, 0.3, 0.5);
            scene.addGrain(Vec3::Zero(), radius);
            scene.addGrain(2*radius*Vec3(distance, aside, 0), radius);
            scene.grains.velocity[1] = Vec3(-50*2*radius/deltaT, 0, 0);
            auto dynamics = scene.build();
            for (int k = 0; k < 3; ++k) step(dynamics, Vec3::Zero(), deltaT);
            EXPECT_NEAR(dynamics.grains().position[1][0], 2*radius*(distance - 150), 1e-12) << aside << " " << distance;
        }
    }
}

TEST(Stress, fastGrainStopsInAPackedBed)
{
    Scene scene = settled(heap(3, 6, 8, radius, 0.8, 0.4), 300);
    scene.addGrain(Vec3(6.9*radius, 6.9*radius, 60*radius), radius);
    scene.grains.velocity.back() = Vec3(0, 0, -50*2*radius/deltaT);
    auto dynamics = scene.build(nscd::ContactSettings());
    double before = energy(dynamics.grains(), scene.g);
    for (int k = 0; k < 20; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        const double after = energy(dynamics.grains(), scene.g);
        ASSERT_LE(after, before*(1 + 1e-9)) << "step " << k;
        before = after;
        ASSERT_LT(report.overlapMax, 0.005) << "step " << k;
        for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
        {
            ASSERT_GT(dynamics.grains().position[i][2], 0.99*dynamics.grains().radius[i]) << "step " << k << " grain " << i;
        }
    }
}

TEST(Stress, initialOverlapsAreParticularlyGentle)
{
    for (double overlap : {0.01, 0.1, 0.5})
    {
        Scene scene(3, 0.3, 0.0);
        const double spacing = 2*radius*(1 - overlap);
        for (int k = 0; k < 500; ++k)
        {
            scene.addGrain(spacing*Vec3(k % 10, (k/10) % 10, k/100) + Vec3(0, 0, radius), radius);
        }
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        auto dynamics = scene.build(nscd::ContactSettings());
        const double unit = dynamics.grains().mass[0]*gravity*2*radius;
        for (int k = 0; k < 100; ++k)
        {
            step(dynamics, Vec3::Zero(), deltaT);
            ASSERT_LT(nscd::kineticEnergy(dynamics.grains()), 500*unit*1e-6) << overlap << " step " << k;
        }
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_LT(report.overlapMax, 1e-3) << overlap;
    }
}

TEST(Stress, coincidentCentersAreRefusedByName)
{
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3(1, 2, 3), radius);
    scene.addGrain(Vec3(5, 2, 3), radius);
    scene.addGrain(Vec3(1, 2, 3), radius);
    auto dynamics = scene.build();
    try
    {
        dynamics.beginStep(deltaT);
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find("grains 0 and 2"), std::string::npos) << error.what();
    }
}

TEST(Stress, badValuesAreRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    nscd::Grains grains;
    EXPECT_THROW(grains.add(Vec3(nan, 0, 0), 1, 1, 0, 0), std::invalid_argument);
    for (double bad : {nan, -1.0, 0.0, std::numeric_limits<double>::infinity()})
    {
        EXPECT_THROW(grains.add(Vec3::Zero(), bad, 1, 0, 0), std::invalid_argument);
        EXPECT_THROW(grains.add(Vec3::Zero(), 1, bad, 0, 0), std::invalid_argument);
    }
    nscd::Materials materials;
    materials.add("glass");
    EXPECT_THROW(materials.add("glass"), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 1, {0.1, 0.1}), std::invalid_argument);
    for (double bad : {nan, -0.1}) EXPECT_THROW(materials.setPair(0, 0, {bad, 0.1}), std::invalid_argument);
    for (double bad : {nan, -0.1, 1.1}) EXPECT_THROW(materials.setPair(0, 0, {0.1, bad}), std::invalid_argument);

    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3::Zero(), radius);
    auto dynamics = scene.build();
    for (double bad : {nan, -1.0, 0.0}) EXPECT_THROW(dynamics.beginStep(bad), std::invalid_argument);
    dynamics.beginStep(deltaT);
    nscd::ExternalForces forces;
    forces.force = {Vec3(nan, 0, 0)};
    EXPECT_THROW(dynamics.advance(forces), std::invalid_argument);
}

TEST(Stress, heavyOnLightSaysSoOrConverges)
{
    for (double ratio : {1e2, 1e4})
    {
        Scene scene(3, 0.5, 0.0);
        scene.addGrain(Vec3(0, 0, radius), radius);
        scene.addGrain(Vec3(0, 0, 3*radius), radius);
        scene.grains.mass[1] *= ratio;
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        nscd::ContactSettings settings = tight();
        settings.tolerance = settings.displacementTolerance = 1e-9;
        auto dynamics = scene.build(settings);
        const double unit = dynamics.grains().mass[0]*gravity;
        for (int k = 1; k <= 1000; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            ASSERT_TRUE(report.solve.converged) << "step " << k;
            ASSERT_LT(2*report.overlapMax, 1e-6) << "step " << k;
        }
        EXPECT_NEAR(-dynamics.wallForce()[0][2], (ratio + 1)*unit, 1e-6*ratio*unit);
    }
}

TEST(Stress, discWedgedBetweenTwoWallsStaysWithFiniteImpulses)
{
    const double pi = 3.14159265358979323846, half = 5*pi/180;
    Scene scene(2, 1.0, 0.0);
    scene.addGrain(Vec3(0, 0, radius/std::sin(half)), radius);
    scene.addPlane(Vec3::Zero(), Vec3(std::cos(half), 0, std::sin(half)));
    scene.addPlane(Vec3::Zero(), Vec3(-std::cos(half), 0, std::sin(half)));
    auto dynamics = scene.build();
    for (int k = 0; k < 1000; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR((dynamics.grains().position[0] - scene.grains.position[0]).norm(), 0, 1e-9*radius);
    for (const nscd::LoadedContact& c : dynamics.contacts())
    {
        EXPECT_LT(c.impulse.norm(), 10*dynamics.grains().mass[0]*gravity*deltaT);
    }
    EXPECT_NEAR(dynamics.contactForce()[0][2], dynamics.grains().mass[0]*gravity, 1e-8*dynamics.grains().mass[0]*gravity);
}

TEST(Stress, grainAsWideAsItsShaftTouchesBothWalls)
{
    Scene scene(3, 0.2, 0.0);
    scene.addGrain(Vec3(radius, 0, 0), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(2*radius, 0, 0), -Vec3::UnitX());
    auto dynamics = scene.build();
    for (int k = 0; k < 100; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(dynamics.grains().position[0][0], radius, 1e-9*radius);
    EXPECT_NEAR((dynamics.wallForce()[0] + dynamics.wallForce()[1])[0], 0.0, 1e-9*dynamics.grains().mass[0]*gravity);
}

TEST(Stress, noGrainsAndNoWalls)
{
    Scene scene(3, 0.2, 0.5);
    auto empty = scene.build();
    const nscd::StepReport report = step(empty, scene.g, deltaT);
    EXPECT_FALSE(empty.hasContacts());
    EXPECT_EQ(report.overlapMean, 0.0);
    scene.addGrain(Vec3(1, 1, 1), radius);
    auto one = scene.build();
    for (int k = 0; k < 10; ++k) step(one, scene.g, deltaT);
    EXPECT_NEAR(one.grains().velocity[0][2], -10*gravity*deltaT, 1e-12);
}
