// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What contacts() tells is all that a grain got: the sum of its impulses is m dv - f dt, with and without rebounds.
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/impulseBalance.hpp"

#include "nscd/solvers/contactSolver.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01, roundOff = 1e-11;

void setRestitution(Scene& scene, double restitution)
{
    for (int a : {0, 1}) for (int b : {0, 1})
    {
        nscd::ContactPair pair = scene.materials.pair(a, b);
        pair.restitution = restitution;
        scene.materials.setPair(a, b, pair);
    }
}

bool all(std::size_t) { return true; }

/// The worst of `steps` steps, for single grains.
template<class Counts>
double worstOfSteps(nscd::GrainDynamics& dynamics, const Vec3& g, int steps, const Counts& counts)
{
    double worst = 0.0;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        step(dynamics, g, deltaT);
        const std::vector<Vec3> impulses = sumOfImpulses(dynamics.contacts(), before.size());
        worst = std::max(worst, worstImbalance(before, dynamics.grains(), impulses, g, deltaT, counts));
    }
    return worst;
}

} // namespace

TEST(ContactImpulses, areAllThatGrainsGetInALandingThatRebounds)
{
    for (double restitution : {0.0, 0.4, 1.0})
    {
        Scene scene = heap(3, 4, 4, radius, 0.6, 0.5);
        setRestitution(scene, restitution);
        auto dynamics = scene.build(nscd::ContactSettings());
        EXPECT_LT(worstOfSteps(dynamics, scene.g, 100, all), roundOff) << "e " << restitution;
    }
}

/// A grain that runs into a row of others: all but its own contact look open before the solve, and are closed by it.
Scene row(double restitution)
{
    Scene scene(3, 0.0, restitution);
    for (int k = 0; k < 60; ++k) scene.addGrain(Vec3(2.05*radius*k, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(6*radius/deltaT, 0, 0);
    return scene;
}

TEST(ContactForces, areAllThatGrainsGetWhateverTheSolver)
{
    for (const nscd::ContactSolverRow& solver : nscd::contactSolvers())
    for (double restitution : {0.0, 0.5})
    {
        const Scene scene = row(restitution);
        nscd::ContactSettings settings;
        settings.solver = solver.name;
        auto dynamics = scene.build(settings);
        for (int k = 0; k < 20; ++k)
        {
            const nscd::Grains before = dynamics.grains();
            step(dynamics, scene.g, deltaT);
            std::vector<Vec3> impulses = dynamics.contactForce();
            for (Vec3& each : impulses) each *= deltaT;
            ASSERT_LT(worstImbalance(before, dynamics.grains(), impulses, scene.g, deltaT, all), roundOff)
                << solver.name << ", e " << restitution << ", step " << k;
        }
    }
}

TEST(ContactImpulses, areThoseOfTheForcesWithRollingFriction)
{
    Scene scene = heap(3, 3, 3, radius, 0.6, 0.5);
    for (int a : {0, 1}) for (int b : {0, 1})
    {
        nscd::ContactPair pair = scene.materials.pair(a, b);
        pair.restitution = 0.5;
        pair.rollingFriction = 0.1;
        scene.materials.setPair(a, b, pair);
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    EXPECT_LT(worstOfSteps(dynamics, scene.g, 100, all), roundOff);
}

TEST(ContactImpulses, ofTheShockAreNotWhatTheNextStepStartsFrom)
{
    // A look at the contacts changes nothing, to the bit.
    Scene scene = heap(3, 3, 3, radius, 0.6, 0.5);
    setRestitution(scene, 0.5);
    auto looked = scene.build(nscd::ContactSettings());
    auto alone = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 100; ++k)
    {
        step(looked, scene.g, deltaT);
        looked.contacts();
        step(alone, scene.g, deltaT);
    }
    for (std::size_t i = 0; i < scene.grains.size(); ++i) EXPECT_EQ(looked.grains().velocity[i], alone.grains().velocity[i]);
}

TEST(ContactImpulses, ofMembersAreAllThatClumpsGet)
{
    Scene scene(3, 0.4, 0.6);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int shape = addShape(scene, pebble());
    for (int k = 0; k < 4; ++k) addClump(scene, shape, Vec3(0.5*k*radius, 0.3*radius*(k % 2), (2 + 3*k)*radius), Quaternion::Identity(), Vec3(0, 0, -0.5));
    auto dynamics = scene.build(nscd::ContactSettings());
    const std::vector<int> clumpOf = nscd::clumpOfGrains(dynamics.grains());
    for (int k = 0; k < 100; ++k)
    {
        const std::vector<Vec3> before = dynamics.grains().clumps.velocity;
        step(dynamics, scene.g, deltaT);
        const std::vector<Vec3> impulses = sumOfImpulses(dynamics.contacts(), dynamics.grains().size());
        std::vector<Vec3> onClump(before.size(), Vec3::Zero());
        for (std::size_t i = 0; i < impulses.size(); ++i) onClump[clumpOf[i]] += impulses[i];
        for (std::size_t c = 0; c < before.size(); ++c)
        {
            const double mass = dynamics.grains().clumps.shapeOf(c).mass;
            const Vec3 gained = mass*(dynamics.grains().clumps.velocity[c] - before[c] - deltaT*scene.g);
            EXPECT_LT((onClump[c] - gained).norm(), roundOff*mass) << "clump " << c << ", step " << k;
        }
    }
}

TEST(ContactImpulses, holdTheReboundOfOneWhileOthersSleep)
{
    Scene scene(3, 0.5, 0.8);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int k = 0; k < 4; ++k) scene.addGrain(Vec3(3*radius*k, 0, radius), radius);
    scene.addGrain(Vec3(0, 1, 20*radius), radius);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 150; ++k) step(dynamics, scene.g, deltaT);
    int asleep = 0, rebounds = 0;
    for (int k = 0; k < 300; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        asleep += step(dynamics, scene.g, deltaT).asleep == 4;
        const std::vector<Vec3> impulses = sumOfImpulses(dynamics.contacts(), before.size());
        rebounds += impulses[4].norm() > 10*deltaT*gravity*before.mass[4];
        EXPECT_LT(worstImbalance(before, dynamics.grains(), impulses, scene.g, deltaT, [](std::size_t i) { return i == 4; }), roundOff) << k;
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(impulses[i][2], deltaT*gravity*before.mass[i], 1e-3*deltaT*gravity*before.mass[i]);
    }
    EXPECT_GT(asleep, 200);
    EXPECT_GE(rebounds, 1);
}
