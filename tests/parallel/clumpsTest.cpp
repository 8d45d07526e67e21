// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps across ranks: laws and balances whatever the cut, the motion of one rank, owners that change.
#include "rankedScene.hpp"

#include "unit/nscd/scenes/clumpMap.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, cell = 5.0*memberRadius;

/// Slabs along x and z, and ranks that are all mixed up.
std::vector<OwnerOf> cuts()
{
    return
    {
        [](const Vec3& x, std::int64_t) { return std::max(0, static_cast<int>(std::floor(x[0]/(0.6*cell)))) % ranks(); },
        [](const Vec3& x, std::int64_t) { return std::max(0, static_cast<int>(std::floor(x[2]/(0.5*cell)))) % ranks(); },
        [](const Vec3&, std::int64_t id) { return static_cast<int>((id*7919) % ranks()); }
    };
}

Scene settledHeap(double friction, int steps)
{
    Scene scene = clumpHeap(27, 3, friction);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < steps; ++k) step(dynamics, scene.g, deltaT);
    scene.grains = dynamics.grains();
    return scene;
}

double meanDiameter(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double r : grains.radius) sum += 2.0*r;
    return sum/static_cast<double>(grains.size());
}

} // namespace

TEST(ClumpsOnRanks, anyCutMeetsTheLawsAndBalances)
{
    const double friction = 0.4;
    const Scene scene = settledHeap(friction, 200);
    const nscd::ContactSettings settings;
    const double diameter = meanDiameter(scene.grains);
    ClumpJudge judge(scene, friction, settings.deadBand*diameter, deltaT);
    for (const OwnerOf& ownerOf : cuts())
    {
        RankedScene run(scene, settings, ownerOf);
        for (int k = 0; k < 4; ++k)
        {
            if (k == 2) run.repartition();
            const nscd::Grains before = run.gatherGrains();
            const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
            ASSERT_TRUE(report.solve.converged) << k;
            const nscd::Grains after = run.gatherGrains();
            const ClumpMap map = judge(before, after, run.gatherContacts());
            // What ranks report counts bodies that several of them move with their shares, which only makes it more.
            EXPECT_LE(map.rms, 1.001*settings.tolerance*report.solve.speedScale) << k;
            EXPECT_LE(map.rms, 1.001*report.solve.residualRms) << k;
            EXPECT_LT(map.imbalance, 1e-13) << k;
            EXPECT_EQ(map.asleep, 0.0) << k;
            EXPECT_LT(map.overlap, 2e-3*diameter) << k;
            EXPECT_GT(map.loaded, 40) << k;
            EXPECT_EQ(run.interfaceContacts() > 0, ranks() > 1) << k;
        }
    }
}

TEST(ClumpsOnRanks, moveWithoutFrictionAsOnOne)
{
    // Velocities are unique without friction.
    const Scene scene = settledHeap(0.0, 110);
    auto serial = scene.build(tight());
    constexpr int steps = 20;
    std::size_t contacts = 0;
    for (int k = 0; k < steps; ++k) contacts = step(serial, scene.g, deltaT).solve.contacts;
    EXPECT_GT(contacts, 25u);
    for (const OwnerOf& ownerOf : cuts())
    {
        RankedScene run(scene, tight(), ownerOf);
        for (int k = 0; k < steps; ++k)
        {
            if (k == 10) run.repartition();
            ASSERT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged) << k;
        }
        const nscd::Grains grains = run.gatherGrains();
        double worst = 0.0;
        for (std::size_t i = 0; i < grains.size(); ++i) worst = std::max(worst, (grains.position[i] - serial.grains().position[i]).norm());
        EXPECT_LT(worst, 1e-4*memberRadius);
        EXPECT_NEAR(run.dynamics().wallForce()[0][2], serial.wallForce()[0][2], 1e-3*std::abs(serial.wallForce()[0][2]));
    }
}

TEST(ClumpsOnRanks, overlapsAreTakenOutTogether)
{
    // Clumps pushed into one another, each pair on two ranks where there are two.
    Scene scene = settledHeap(0.4, 250);
    scene.g = Vec3::Zero();
    for (std::size_t c = 0; c < scene.grains.clumps.size(); ++c)
    {
        scene.grains.clumps.position[c] += 0.004*(Vec3(1.5*cell, 1.5*cell, 0) - scene.grains.clumps.position[c]);
        scene.grains.clumps.velocity[c] = scene.grains.clumps.angularMomentum[c] = Vec3::Zero();
        nscd::placeMembers(scene.grains, c, scene.box);
    }
    for (std::size_t i = 0; i < scene.grains.size(); ++i) scene.grains.velocity[i] = scene.grains.omega[i] = Vec3::Zero();
    RankedScene run(scene, nscd::ContactSettings(), [](const Vec3&, std::int64_t id) { return static_cast<int>((id*7919) % ranks()); });
    const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
    EXPECT_GT(report.overlapUncorrected, 2e-3);
    EXPECT_GT(report.correctionSweeps, 0);
    EXPECT_LT(report.overlapMax, 0.25*report.overlapUncorrected);
    const nscd::Grains grains = run.gatherGrains();
    nscd::checkClumps(grains, scene.box);
    EXPECT_EQ(kineticEnergy(grains), 0.0);
}

TEST(ClumpsOnRanks, aMemberDoesNotGoAlone)
{
    const nscd::Communicator all(MPI_COMM_WORLD);
    const Scene scene = clumpHeap(1, 1, 0.0);
    std::vector<int> destination(scene.grains.size(), all.rank());
    destination.back() = (all.rank() + 1) % all.size();
    if (all.size() == 1) return;
    EXPECT_THROW(nscd::Migration(all, destination).moveGrains(scene.grains), std::invalid_argument);
}
