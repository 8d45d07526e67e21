// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Shocks with restitution: two and three bodies against closed forms, and energy in elastic gases.
#include "accuracy/expectNear.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include "nscd/scene/stepWarnings.hpp"
#include "nscd/tools/filling.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace scenes;

namespace
{

constexpr double radius = 0.01;

/// Equal spheres in a row with a gap between them; the first moves at 1 m/s towards the others.
Scene row(int grains, double gap, double restitution)
{
    Scene scene(3, 0.0, restitution);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3((2*radius + gap)*i, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(1, 0, 0);
    return scene;
}

Vec3 momentum(const nscd::Grains& grains)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i) sum += grains.mass[i]*grains.velocity[i];
    return sum;
}

} // namespace

TEST(Shock, twoBodiesFollowNewton)
{
    for (double ratio : {1.0, 1e2, 1e4})
    {
        for (double e : {0.0, 0.5, 1.0})
        {
            Scene scene = row(2, 0.0, e);
            scene.grains.mass[0] = ratio*scene.grains.mass[1];
            auto dynamics = scene.build();
            step(dynamics, Vec3::Zero(), 1e-3);
            const double total = ratio + 1;
            const std::string shock = "A03 masses 1:" + figures::text(ratio) + ", e " + figures::text(e);
            figures::expectNear(shock, "velocity of the first [m/s]", dynamics.grains().velocity[0][0], (ratio - e)/total, 1e-10);
            figures::expectNear(shock, "velocity of the second [m/s]", dynamics.grains().velocity[1][0], (1 + e)*ratio/total, 1e-10);
        }
    }
}

/// A pair that meets aside, by less than a quarter of its size a step: impulses are those of the normal that it has at the end of the step, and so are spins.
TEST(Shock, actsAtTheNormalsWhereTheMotionBroughtTheGrains)
{
    for (double friction : {0.0, 0.3})
    {
        Scene scene(3, friction, 0.5);
        const Vec3 aside = Vec3(1, 0.7, 0.2).normalized();
        scene.addGrain(Vec3::Zero(), radius);
        scene.addGrain(2*radius*1.01*aside, radius);
        const Vec3 v(1, 0, 0);
        scene.grains.velocity[0] = v;
        auto dynamics = scene.build();
        step(dynamics, Vec3::Zero(), 2e-3);
        const nscd::Grains& grains = dynamics.grains();
        const Vec3 n = (grains.position[0] - grains.position[1]).normalized(), change = grains.velocity[0] - v;
        EXPECT_GT((n + aside).norm(), 0.02);   // it has turned
        EXPECT_LT(change.dot(v), -0.1);
        EXPECT_NEAR(n.dot(grains.velocity[0] - grains.velocity[1]), -0.5*n.dot(v), 1e-9);
        const Vec3 moment = -radius*n.cross(grains.mass[0]*change);
        EXPECT_NEAR((0.4*grains.mass[0]*radius*radius*grains.omega[0] - moment).norm(), 0.0, 1e-12*grains.mass[0]*radius);
        if (friction == 0.0)
        {
            EXPECT_NEAR(n.cross(change).norm(), 0.0, 1e-9);
        }
    }
}

TEST(Shock, threeTouchingBallsFollowMoreauAndNewton)
{
    for (double e : {1.0, 0.0})
    {
        auto dynamics = row(3, 0.0, e).build();
        step(dynamics, Vec3::Zero(), 1e-3);
        const Vec3 expected = e == 1.0 ? Vec3(-1.0/3, 2.0/3, 2.0/3) : Vec3(1.0/3, 1.0/3, 1.0/3);
        for (int i = 0; i < 3; ++i)
        {
            figures::expectNear("A04 touching, e " + figures::text(e), "velocities [m/s]", dynamics.grains().velocity[i][0], expected[i], 1e-8);
        }
        const double mass = dynamics.grains().mass[0];
        EXPECT_NEAR(dynamics.contactForce()[2][0]*1e-3, mass*expected[2], 1e-8*mass);
        EXPECT_NEAR(dynamics.contactForce()[0][0]*1e-3, mass*(expected[0] - 1), 1e-8*mass);
    }
}

TEST(Shock, countsTheImpactsOfAGrain)
{
    const auto impacts = [](Scene scene, double g = 0.0)
    {
        auto dynamics = scene.build();
        return step(dynamics, Vec3(0, 0, -g), 1e-3).solve.impacts;
    };
    EXPECT_EQ(impacts(row(2, 0.0, 0.5)), 1.0) << "both have one";
    EXPECT_EQ(impacts(row(2, 0.0, 0.0)), 0.0) << "no restitution";
    EXPECT_EQ(impacts(row(2, 1.0, 0.5)), 0.0) << "too far off";
    EXPECT_EQ(impacts(row(4, 1e-4, 0.5)), 0.5) << "two of four: what is pushed within the step meets the next in the next one";
    Scene floor = row(1, 0.0, 0.5);
    floor.addPlane(Vec3(radius, 0, 0), -Vec3::UnitX());
    EXPECT_EQ(impacts(floor), 1.0);
    Scene held = row(2, 0.0, 0.5);
    held.grains.isFixed[1] = true;
    EXPECT_EQ(impacts(held), 1.0) << "of the one that moves";
    Scene resting(3, 0.5, 0.5);
    resting.addGrain(Vec3(0, 0, radius), radius);
    resting.addPlane(Vec3::Zero(), Vec3::UnitZ());
    EXPECT_EQ(impacts(resting, 9.81), 0.0) << "what lies does not meet";
}

// 64 balls fly about, 0.05 diameters apart, and meet many in each step.
TEST(Shock, warnsWhereImpactsMeetWithinAStep)
{
    Scene scene(3, 0.0, 0.9);
    std::mt19937 random(3);
    std::normal_distribution<double> speed(0.0, 1.0);
    for (int k = 0; k < 64; ++k)
    {
        scene.addGrain(2.1*radius*Vec3(k % 4, k/4 % 4, k/16), radius);
        scene.grains.velocity.back() = Vec3(speed(random), speed(random), speed(random));
    }
    scene.box.length = Vec3::Constant(4*2.1*radius);
    for (const double deltaT : {4e-3, 2e-5})
    {
        auto dynamics = scene.build();
        for (int k = 1; k <= 8; ++k)
        {
            const nscd::SolveReport report = step(dynamics, Vec3::Zero(), deltaT).solve;
            EXPECT_EQ(report.stepsOfManyImpacts, deltaT > 1e-3 ? k : 0) << report.impacts;
            EXPECT_EQ(nscd::warning(report).find("meet others") != std::string::npos, deltaT > 1e-3 && k >= 5);
        }
    }
}

TEST(Shock, threeBallsWithGapsCollideOneAfterAnother)
{
    auto dynamics = row(3, 2e-3*radius, 1.0).build();
    for (int k = 0; k < 400; ++k) step(dynamics, Vec3::Zero(), 1e-6);
    EXPECT_NEAR(dynamics.grains().velocity[0][0], 0.0, 1e-8);
    EXPECT_NEAR(dynamics.grains().velocity[1][0], 0.0, 1e-8);
    figures::expectNear("A04 gaps, e 1", "velocity of the last [m/s]", dynamics.grains().velocity[2][0], 1.0, 1e-8);
}

TEST(Shock, massesDifferInARowOfFive)
{
    // e = 1 without friction: momentum and energy are exact whatever the masses.
    Scene scene = row(5, 0.0, 1.0);
    for (int i = 0; i < 5; ++i) scene.grains.mass[i] *= 1 + i*i;
    auto dynamics = scene.build();
    const double energy = nscd::kineticEnergy(dynamics.grains());
    const Vec3 before = momentum(dynamics.grains());
    for (int k = 0; k < 200; ++k) step(dynamics, Vec3::Zero(), 1e-4);
    EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), energy, 1e-8*energy);
    EXPECT_NEAR((momentum(dynamics.grains()) - before).norm(), 0.0, 1e-10*before.norm());
}

namespace
{

/// Grains on a jittered lattice in a closed box, with random velocities of the order of 1 m/s.
Scene gas(int dimensions, int perSide, double spacing, double friction, double restitution)
{
    Scene scene(dimensions, friction, restitution);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const int layers = dimensions == 3 ? perSide : 1;
    const double shake = 0.5*(spacing - 2*radius)*0.9;
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        Vec3 x = spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake*Vec3(unit(random), unit(random), unit(random));
        if (dimensions == 2) x[2] = 0.0;
        scene.addGrain(x, radius);
        scene.grains.velocity.back() = Vec3(unit(random), unit(random), dimensions == 3 ? unit(random) : 0.0);
    }
    const Vec3 far = Vec3::Constant(spacing*perSide);
    for (int axis = 0; axis < dimensions; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(far, -Vec3::Unit(axis));
    }
    return scene;
}

} // namespace

TEST(Shock, elasticDiscsInABoxKeepTheirEnergy)
{
    const Scene scene = gas(2, 14, 3.5*radius, 0.0, 1.0);
    auto dynamics = scene.build();
    const double energy = nscd::kineticEnergy(dynamics.grains());
    Vec3 before = momentum(dynamics.grains());
    for (int k = 0; k < 10000; ++k)
    {
        step(dynamics, Vec3::Zero(), 1e-4);
        Vec3 fromWalls = Vec3::Zero();
        for (const Vec3& force : dynamics.wallForce()) fromWalls -= 1e-4*force;
        const Vec3 after = momentum(dynamics.grains());
        ASSERT_NEAR((after - before - fromWalls).norm(), 0.0, 1e-10*dynamics.grains().mass[0]) << "step " << k;
        before = after;
    }
    figures::expectNear("A12", "kinetic energy after 10 000 steps [J]", nscd::kineticEnergy(dynamics.grains()), energy, 1e-6*energy);
}

TEST(Shock, elasticDenseSpheresKeepTheirEnergyWithoutFriction)
{
    const Scene scene = gas(3, 10, 2.06*radius, 0.0, 1.0);
    auto dynamics = scene.build();
    const double energy = nscd::kineticEnergy(dynamics.grains());
    for (int k = 0; k < 100; ++k) step(dynamics, Vec3::Zero(), 1e-4);
    EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), energy, 1e-6*energy);
}

namespace
{

/// 27 spheres, close-packed, with random velocities of the order of 1 m/s.
Scene packedCluster(double friction, double restitution, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    Scene scene(3, friction, restitution);
    for (int i = 0; i < 27; ++i)
    {
        // Six neighbors in a layer, three above and below.
        const int row = (i/3) % 3, layer = i/9;
        scene.addGrain(2*radius*Vec3(i % 3 + 0.5*((row + layer) % 2), std::sqrt(0.75)*(row + (layer % 2)/3.0), std::sqrt(2.0/3.0)*layer), radius);
        scene.grains.velocity.back() = Vec3(unit(random), unit(random), unit(random));
    }
    return scene;
}

} // namespace

/// Kane's paradox: Newton's law and friction at once would create energy in some of these clusters.
TEST(Shock, touchingClustersWithFrictionNeverGainEnergy)
{
    std::mt19937 random(3);
    int limited = 0;
    for (int cluster = 0; cluster < 100; ++cluster)
    {
        const Scene scene = packedCluster(0.5, 1.0, random);
        auto dynamics = scene.build();
        const double before = nscd::kineticEnergy(dynamics.grains());
        const Vec3 start = momentum(dynamics.grains());
        const nscd::SolveReport report = step(dynamics, Vec3::Zero(), 1e-5).solve;
        ASSERT_LE(nscd::kineticEnergy(dynamics.grains()), before*(1 + 1e-9)) << cluster;
        ASSERT_NEAR((momentum(dynamics.grains()) - start).norm(), 0.0, 1e-12) << cluster;
        if (!report.hasGainedEnergy()) continue;
        ++limited;
        EXPECT_LT(report.reboundShare, 1.0);
        EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), before, 1e-9*before) << cluster;
        EXPECT_NE(nscd::warning(report).find("created"), std::string::npos);
    }
    EXPECT_GT(limited, 0);
}

/// Steps in which the grains turn around one another by up to a tenth, and more sweeps than some shocks get.
TEST(Shock, ofClustersThatTurnInAStepNeverGainsEnergy)
{
    std::mt19937 random(7);
    for (double friction : {0.5, 1.5})
    for (double e : {0.5, 1.0})
    for (int maxSweeps : {30, 1000})
    for (int cluster = 0; cluster < 20; ++cluster)
    {
        nscd::ContactSettings settings;
        settings.maxSweeps = maxSweeps;
        const Scene scene = packedCluster(friction, e, random);
        auto dynamics = scene.build(settings);
        const double before = nscd::kineticEnergy(dynamics.grains());
        const Vec3 start = momentum(dynamics.grains());
        const nscd::SolveReport report = step(dynamics, Vec3::Zero(), 2e-3).solve;
        EXPECT_LE(nscd::kineticEnergy(dynamics.grains()), before*(1 + 1e-9) + report.shockResidualWork) << friction << " " << e << " " << maxSweeps << " " << cluster;
        EXPECT_NEAR((momentum(dynamics.grains()) - start).norm(), 0.0, 1e-12) << cluster;
    }
}

TEST(Shock, frictionDissipatesInADenseElasticGas)
{
    const Scene scene = gas(3, 6, 2.06*radius, 0.5, 1.0);
    auto dynamics = scene.build();
    double energy = nscd::kineticEnergy(dynamics.grains());
    const double start = energy;
    for (int k = 0; k < 100; ++k)
    {
        step(dynamics, Vec3::Zero(), 1e-4);
        const double after = nscd::kineticEnergy(dynamics.grains());
        EXPECT_LE(after, energy*(1 + 1e-3)) << "step " << k;
        energy = after;
    }
    EXPECT_LT(energy, start);
}

namespace
{

/// Spheres that fall into a closed funnel, periodic along y.
Scene closedFunnel(double friction, double restitution)
{
    Scene scene(3, friction, restitution);
    scene.box.length = Vec3(0, 8e-3, 0);
    scene.addPlane(Vec3(0, 0, -0.5e-3), Vec3::UnitZ());
    for (int side : {-1, 1})
    {
        scene.addPlane(Vec3(16e-3*side, 0, 0), -side*Vec3::UnitX());
        scene.addPlane(Vec3(8e-3*side, 0, 0), Vec3(-14*side, 0, 8).normalized());
    }
    nscd::FillingSource loose;
    loose.region = nscd::boxRegion({-16e-3, 0, 15e-3}, {16e-3, 8e-3, 95e-3});
    loose.sizes = nscd::oneSize(2e-3);
    loose.density = 2500;
    loose.measure = nscd::FillingAmount::solidFraction;
    loose.amount = 0.5;
    loose.isPacked = true;
    const nscd::Filling filling = nscd::fill(loose, {scene.walls, scene.box, scene.grains.shape}, {});
    for (std::size_t i = 0; i < filling.grains.size(); ++i) scene.addGrain(filling.grains.center[i], filling.grains.radius[i]);
    return scene;
}

} // namespace

// 2365 spheres, whose landing ends some solves at the cap. Held friction kept 0.2 of the energy, for good; now 0.002 are left.
TEST(Shock, aBedThatLandsInAFunnelComesToRest)
{
    const Scene scene = closedFunnel(0.3, 0.5);
    auto dynamics = scene.build(nscd::ContactSettings());
    double energy = 0.0, highest = 0.0;
    int atCap = 0;
    for (int k = 0; k < 80; ++k)
    {
        atCap += step(dynamics, scene.g, 1e-3).solve.atCap;
        energy = nscd::kineticEnergy(dynamics.grains());
        highest = std::max(highest, energy);
    }
    EXPECT_LE(atCap, 15);
    EXPECT_LT(energy, 0.01*highest);
}

// v = v_i + e (v_i - v^-), v_i what the same scene without restitution ends with.
TEST(Shock, thatIsNotSolvedReboundsByTheImpulsesOfTheMotion)
{
    const double e = 0.6;
    nscd::ContactSettings settings;
    settings.maxSweeps = 20;
    std::mt19937 random(5);
    int count = 0;
    for (int cluster = 0; cluster < 20; ++cluster)
    {
        const Scene rebounding = packedCluster(1.5, e, random);
        Scene inelastic = rebounding;
        for (int a = 0; a < 2; ++a) inelastic.materials.setPair(a, 0, {1.5, 0.0});
        auto dynamics = rebounding.build(settings), motion = inelastic.build(settings);
        const nscd::SolveReport report = step(dynamics, Vec3::Zero(), 1e-5).solve;
        step(motion, Vec3::Zero(), 1e-5);
        if (!report.isReboundOfMotion) continue;
        ++count;
        EXPECT_FALSE(report.converged);
        EXPECT_NE(nscd::warning(report).find("restitution"), std::string::npos);
        for (std::size_t i = 0; i < rebounding.grains.size(); ++i)
        {
            const Vec3 stopped = motion.grains().velocity[i], expected = stopped + e*(stopped - rebounding.grains.velocity[i]);
            EXPECT_NEAR((dynamics.grains().velocity[i] - expected).norm(), 0.0, 1e-12);
            EXPECT_NEAR((dynamics.contactForce()[i] - (1.0 + e)*motion.contactForce()[i]).norm(), 0.0, 1e-12*motion.contactForce()[i].norm());
        }
        EXPECT_LE(nscd::kineticEnergy(dynamics.grains()), nscd::kineticEnergy(rebounding.grains));
    }
    EXPECT_GT(count, 5);
}
