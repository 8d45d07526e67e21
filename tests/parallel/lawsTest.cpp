// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Rolling friction, cohesion and driven grains across ranks.
#include "rankedScene.hpp"

#include "unit/nscd/scenes/rollingMap.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

std::vector<OwnerOf> cuts()
{
    const double spacing = 2.3*radius;
    return
    {
        [=](const Vec3& x, std::int64_t) { return std::max(0, static_cast<int>(std::floor(x[0]/spacing))) % ranks(); },
        [=](const Vec3& x, std::int64_t) { return std::max(0, static_cast<int>(std::floor(x[2]/(3*spacing)))) % ranks(); },
        [](const Vec3&, std::int64_t id) { return static_cast<int>((id*7919) % ranks()); }
    };
}

Scene heapWith(double friction, double rolling, double spinning, double cohesion)
{
    Scene scene = heap(3, 5, 5, radius, 0.7, 0.0);
    nscd::ContactPair pair{friction, 0.0};
    pair.rollingFriction = rolling;
    pair.spinningFriction = spinning;
    pair.cohesion = cohesion*scene.grains.mass[0]*gravity;
    for (int a = 0; a < 2; ++a)
    {
        for (int b = a; b < 2; ++b) scene.materials.setPair(a, b, pair);
    }
    return scene;
}

/// What a scene has become after some steps on one rank, and its impulses.
struct Settled
{
    Scene scene;
    std::vector<nscd::StoredImpulse> impulses;
    double lastDeltaT = 0.0;

    Settled(Scene from, int steps) : scene(std::move(from))
    {
        auto dynamics = scene.build(nscd::ContactSettings());
        for (int k = 0; k < steps; ++k) step(dynamics, scene.g, deltaT);
        impulses = dynamics.checkpoint(lastDeltaT);
        scene.grains = dynamics.grains();
    }

    /// Gives each rank the impulses of its own grains.
    void restore(nscd::GrainDynamics& dynamics) const
    {
        const std::vector<std::int64_t>& own = dynamics.grains().id;
        std::vector<nscd::StoredImpulse> mine;
        for (const nscd::StoredImpulse& entry : impulses)
        {
            if (std::count(own.begin(), own.end(), entry.idA) > 0) mine.push_back(entry);
        }
        dynamics.restore(mine, lastDeltaT);
    }
};

double worstDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
    return worst;
}

} // namespace

TEST(Laws, anyCutMeetsTheTolerance)
{
    const double friction = 0.4;
    const Settled start(heapWith(friction, 0.05, 0.02, 1.5), 150);
    const Scene& scene = start.scene;
    double diameter = 0.0;
    for (double r : scene.grains.radius) diameter += 2.0*r/scene.grains.size();
    nscd::ContactSettings settings;
    settings.polishSweeps = 0;
    for (const OwnerOf& ownerOf : cuts())
    {
        RankedScene run(scene, settings, ownerOf);
        start.restore(run.dynamics());
        for (int k = 0; k < 3; ++k)
        {
            const nscd::Grains before = run.gatherGrains();
            const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
            EXPECT_TRUE(report.solve.converged);
            const nscd::Grains after = run.gatherGrains();
            const std::vector<nscd::LoadedContact> contacts = run.gatherContacts();
            const NaturalMap map = Judge(scene, friction, settings.deadBand*diameter, deltaT)(before, after, contacts);
            const double rolling = rollingNorm(scene, before, after, contacts);
            const double rms = std::hypot(map.norm, rolling)/std::sqrt(static_cast<double>(report.solve.contacts));
            EXPECT_LT(rms, 1.01*settings.tolerance*gravity*deltaT);
            EXPECT_GT(rolling, 0.0);
            EXPECT_GT(report.solve.contacts, 100u);
        }
    }
}

TEST(Laws, cohesionWithoutFrictionMovesTheSame)
{
    // Velocities are unique without friction.
    const Scene scene = heapWith(0.0, 0.0, 0.0, 3.0);
    auto serial = scene.build();
    std::size_t contacts = 0;
    for (int k = 0; k < 60; ++k) contacts = step(serial, scene.g, deltaT).solve.contacts;
    EXPECT_GT(contacts, 50u);
    for (const OwnerOf& ownerOf : cuts())
    {
        RankedScene run(scene, tight(), ownerOf);
        for (int k = 0; k < 60; ++k)
        {
            if (k % 20 == 10) run.repartition();
            EXPECT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged);
        }
        EXPECT_LT(worstDifference(run.gatherGrains().position, serial.grains().position), 1e-8*radius);
        EXPECT_NEAR(run.dynamics().wallForce()[0][2], serial.wallForce()[0][2], 1e-6*std::abs(serial.wallForce()[0][2]));
    }
}

TEST(Laws, aChainHangsAcrossRanks)
{
    Scene scene = heapWith(0.3, 0.0, 0.0, 0.0);
    scene.grains = nscd::Grains();
    scene.walls = nscd::Walls();
    for (int i = 0; i < 8; ++i) scene.addGrain(Vec3(0, 0, 1 - 2.0*radius*i), radius);
    scene.grains.isFixed[0] = 1;
    const double weight = scene.grains.mass[0]*gravity;
    nscd::ContactPair pair{0.3, 0.0};
    pair.cohesion = 7.001*weight;
    scene.materials.setPair(0, 0, pair);
    RankedScene run(scene, tight(), [](const Vec3&, std::int64_t id) { return static_cast<int>(id % ranks()); });
    for (int k = 0; k < 50; ++k)
    {
        if (k == 20) run.repartition();
        ASSERT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged);
    }
    EXPECT_LT(worstDifference(run.gatherGrains().position, scene.grains.position), 1e-9*radius);
    const nscd::Grains& own = run.dynamics().grains();
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        EXPECT_NEAR(run.dynamics().contactForce()[i][2], own.id[i] == 0 ? -7*weight : weight, 1e-8*weight);
    }
}

TEST(Laws, rollingMomentsFollowGrains)
{
    const Settled start(heapWith(0.4, 0.1, 0.05, 0.0), 1500);
    const double unit = start.scene.grains.mass[0]*gravity*2*radius;
    ASSERT_LT(nscd::kineticEnergy(start.scene.grains), 1e-12*unit);
    for (const OwnerOf& ownerOf : cuts())
    {
        RankedScene run(start.scene, nscd::ContactSettings(), ownerOf);
        start.restore(run.dynamics());
        EXPECT_LE(step(run.dynamics(), start.scene.g, deltaT).solve.sweeps, 3);
        run.repartition();
        EXPECT_LE(step(run.dynamics(), start.scene.g, deltaT).solve.sweeps, 3);
        double energy = nscd::kineticEnergy(run.dynamics().grains());
        run.exchange().sum(&energy, 1);
        EXPECT_LT(energy, 1e-10*unit);
    }
}

TEST(Laws, rollingPairActsAlikeOnTwoRanks)
{
    // A row of grains that roll on a floor, neighbors glued to one another: the same as on one rank.
    Scene scene = heapWith(0.3, 0.05, 0.05, 2.0);
    scene.grains = nscd::Grains();
    for (int i = 0; i < 4; ++i)
    {
        scene.addGrain(Vec3(0.03 + 2*radius*i, 0.05, radius), radius);
        scene.grains.omega.back() = Vec3(0, 5.0 + i, 1.0);
    }
    auto serial = scene.build();
    RankedScene run(scene, tight(), [](const Vec3&, std::int64_t id) { return static_cast<int>(id % ranks()); });
    ASSERT_TRUE(step(serial, scene.g, deltaT).solve.converged);
    ASSERT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged);
    const nscd::Grains all = run.gatherGrains();
    EXPECT_LT(worstDifference(all.velocity, serial.grains().velocity), 1e-9);
    EXPECT_LT(worstDifference(all.omega, serial.grains().omega), 1e-7);
    const nscd::Grains& own = run.dynamics().grains();
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const Vec3 difference = run.dynamics().contactTorque()[i] - serial.contactTorque()[own.id[i]];
        EXPECT_LT(difference.norm(), 1e-7*scene.grains.mass[0]*gravity*radius);
    }
}

TEST(Laws, aDrivenGrainPushesAcrossRanks)
{
    Scene scene = heapWith(0.0, 0.0, 0.0, 0.0);
    scene.grains = nscd::Grains();
    scene.walls = nscd::Walls();
    for (int i = 0; i < 5; ++i) scene.addGrain(Vec3(2*radius*i, 0, 0), radius);
    scene.grains.isFixed[0] = 1;
    RankedScene run(scene, tight(), [](const Vec3&, std::int64_t id) { return static_cast<int>((id + 1) % ranks()); });
    const double acceleration = 10.0;
    for (int k = 1; k <= 30; ++k)
    {
        const nscd::Grains& own = run.dynamics().grains();
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            if (own.id[i] == 0) run.dynamics().drive(i, Vec3(acceleration*k*deltaT, 0, 0), Vec3::Zero());
        }
        nscd::ExternalForces forces;
        forces.speedScale = acceleration*deltaT;
        run.dynamics().beginStep(deltaT);
        ASSERT_TRUE(run.dynamics().advance(forces).solve.converged);
        if (k == 10) run.repartition();
    }
    const nscd::Grains all = run.gatherGrains();
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(all.velocity[i][0], acceleration*30*deltaT, 1e-10);
    const nscd::Grains& own = run.dynamics().grains();
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const double expected = scene.grains.mass[0]*acceleration*(own.id[i] == 0 ? -4.0 : 1.0);
        EXPECT_NEAR(run.dynamics().contactForce()[i][0], expected, 1e-8*std::abs(expected)) << own.id[i];
    }
}
