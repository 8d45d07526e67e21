// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains on several ranks do what they do on one, whatever the cut.
#include "rankedScene.hpp"

#include "unit/nscd/scenes/impulseBalance.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"
#include "unit/nscd/scenes/shots.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01, friction = 0.5;

int cell(double x, double width) { return std::max(0, static_cast<int>(std::floor(x/width))); }

struct Cut
{
    const char* name;
    OwnerOf ownerOf;
};

/// Of a bed that was so many lattice spacings wide.
std::vector<Cut> cuts(int perSide = 8)
{
    const double spacing = 2.3*radius, width = perSide*spacing;
    return
    {
        {"halves along x", [=](const Vec3& x, std::int64_t) { return std::min(ranks() - 1, cell(x[0], width/ranks())); }},
        {"corners in the bed", [=](const Vec3& x, std::int64_t)
            { return (2*std::min(1, cell(x[0], width/2)) + std::min(1, cell(x[1], width/2)) + 4*cell(x[2], 4*spacing)) % ranks(); }},
        {"slabs one grain thick", [=](const Vec3& x, std::int64_t) { return cell(x[0], spacing) % ranks(); }},
        {"layers one grain thick", [=](const Vec3& x, std::int64_t) { return cell(x[2], spacing) % ranks(); }},
        {"scattered", [](const Vec3&, std::int64_t id) { return static_cast<int>((id*7919) % ranks()); }},
        {"all on the last rank", [](const Vec3&, std::int64_t) { return ranks() - 1; }}
    };
}

/// A heap that has landed and, after some steps in a viscous medium, come to rest, with the impulses that hold it.
struct Heap
{
    Scene scene;
    std::vector<nscd::StoredImpulse> impulses;

    Heap(int perSide, int layers, int dampedSteps)
    :
        scene(heap(3, perSide, layers, radius, 0.7, friction))
    {
        nscd::ContactSettings settings;
        settings.sleep = false;   // asleep, grains on the verge of rolling stay where they are until they wake
        auto dynamics = scene.build(settings);
        for (int k = 0; k < 250; ++k) step(dynamics, scene.g, deltaT);
        for (int k = 0; k < dampedSteps; ++k) stepDamped(dynamics, scene.g, deltaT);
        double lastDeltaT = 0.0;
        impulses = dynamics.checkpoint(lastDeltaT);
        scene.grains = dynamics.grains();
    }
};

/// Impulses of the grains that a rank owns by their first.
std::vector<nscd::StoredImpulse> ofRank(const std::vector<nscd::StoredImpulse>& impulses, const nscd::Grains& own)
{
    std::vector<nscd::StoredImpulse> mine;
    for (const nscd::StoredImpulse& entry : impulses)
    {
        for (std::int64_t id : own.id)
        {
            if (id == entry.idA) mine.push_back(entry);
        }
    }
    return mine;
}

double meanDiameter(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double r : grains.radius) sum += 2.0*r;
    return sum/grains.size();
}

double worstDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
    return worst;
}

} // namespace

TEST(Ranks, anyCutMeetsTheTolerance)
{
    const Scene scene = Heap(8, 5, 200).scene;
    nscd::ContactSettings settings;
    settings.tolerance = 1e-2;
    settings.maxSweeps = 3000;
    auto serial = scene.build(settings);
    const nscd::StepReport alone = step(serial, scene.g, deltaT);
    ASSERT_TRUE(alone.solve.converged);
    for (const Cut& cut : cuts())
    {
        RankedScene run(scene, settings, cut.ownerOf);
        const nscd::Grains before = run.gatherGrains();
        const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
        const NaturalMap map = Judge(scene, friction, settings.deadBand*meanDiameter(scene.grains), deltaT)(before, run.gatherGrains(), run.gatherContacts());
        const int interface = run.interfaceContacts();
        if (run.exchange().rank() == 0)
        {
            std::printf("   %-24s %5d of %5zu contacts between ranks, %4d sweeps (one rank %d), residual %.1e, judged %.1e\n",
                        cut.name, interface, report.solve.contacts, report.solve.sweeps, alone.solve.sweeps, report.solve.residualRms, map.rms);
        }
        EXPECT_TRUE(report.solve.converged) << cut.name;
        EXPECT_LE(map.rms, 1.01*settings.tolerance*gravity*deltaT) << cut.name;
        EXPECT_NEAR(run.dynamics().wallForce()[0][2], serial.wallForce()[0][2], 5e-2*std::abs(serial.wallForce()[0][2])) << cut.name;
    }
}

TEST(Ranks, aRestingHeapStaysWhereItIs)
{
    const Heap heap(5, 5, 16000);
    const nscd::ContactSettings settings;
    for (const Cut& cut : cuts(5))
    {
        RankedScene run(heap.scene, settings, cut.ownerOf);
        run.dynamics().restore(ofRank(heap.impulses, run.dynamics().grains()), deltaT);
        auto serial = heap.scene.build(settings);
        serial.restore(heap.impulses, deltaT);
        for (int k = 0; k < 10; ++k)
        {
            const nscd::StepReport report = stepDamped(run.dynamics(), heap.scene.g, deltaT);
            const nscd::StepReport alone = stepDamped(serial, heap.scene.g, deltaT);
            EXPECT_TRUE(report.solve.converged) << cut.name;
            EXPECT_LE(report.solve.sweeps, 3*alone.solve.sweeps + 20) << cut.name << ": impulses were not handed over";
        }
        const nscd::Grains all = run.gatherGrains();
        EXPECT_LT(worstDifference(all.position, heap.scene.grains.position), 1e-5*radius) << cut.name;
        EXPECT_LT(worstDifference(all.velocity, serial.grains().velocity), 1e-3*gravity*deltaT) << cut.name;
    }
}

TEST(Ranks, withoutFrictionTheMotionIsTheSame)
{
    // Velocities are unique without friction, and impacts multiply differences: a landing heap, up to some hundred contacts.
    const Scene scene = heap(3, 8, 5, radius, 0.7, 0.0);
    for (const Cut& cut : cuts())
    {
        RankedScene run(scene, tight(), cut.ownerOf);
        auto serial = scene.build();
        std::size_t contacts = 0;
        for (int k = 0; k < 60; ++k)
        {
            EXPECT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged) << cut.name;
            contacts = step(serial, scene.g, deltaT).solve.contacts;
        }
        EXPECT_GT(contacts, 100u);
        EXPECT_LT(worstDifference(run.gatherGrains().position, serial.grains().position), 1e-9*radius) << cut.name;
    }
}

TEST(Ranks, grainsMayChangeTheirRanks)
{
    const Scene scene = heap(3, 8, 5, radius, 0.7, 0.0);
    for (const Cut& cut : cuts())
    {
        RankedScene run(scene, tight(), cut.ownerOf);
        auto serial = scene.build();
        double left = 0.0;
        for (int k = 0; k < 60; ++k)
        {
            if (k % 5 == 0) left += run.repartition();
            EXPECT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged) << cut.name;
            step(serial, scene.g, deltaT);
        }
        run.exchange().sum(&left, 1);
        EXPECT_TRUE(ranks() == 1 || left > 0) << cut.name;
        EXPECT_LT(worstDifference(run.gatherGrains().position, serial.grains().position), 1e-9*radius) << cut.name;
    }
}

TEST(Ranks, impulsesFollowGrains)
{
    const Heap heap(5, 5, 16000);
    auto without = heap.scene.build(nscd::ContactSettings()), serial = heap.scene.build(nscd::ContactSettings());
    const int cold = step(without, heap.scene.g, deltaT).solve.sweeps;
    serial.restore(heap.impulses, deltaT);
    step(serial, heap.scene.g, deltaT);
    const int most = step(serial, heap.scene.g, deltaT).solve.sweeps + 3;
    EXPECT_GT(cold, 4*most);
    for (const Cut& cut : cuts(5))
    {
        RankedScene run(heap.scene, nscd::ContactSettings(), cut.ownerOf);
        run.dynamics().restore(ofRank(heap.impulses, run.dynamics().grains()), deltaT);
        step(run.dynamics(), heap.scene.g, deltaT);
        run.repartition();
        EXPECT_LE(step(run.dynamics(), heap.scene.g, deltaT).solve.sweeps, most) << cut.name;
    }
}

TEST(Ranks, collisionsConserveMomentumAcrossRanksAndPeriods)
{
    for (const Cut& cut : cuts())
    {
        Scene scene = heap(3, 8, 9, radius, 0.7, 0.0);
        scene.walls = nscd::Walls();
        scene.materials.setPair(0, 0, {0.3, 0.9});
        for (int k = 0; k < 2; ++k) scene.box.length[k] = 8*2.3*radius;
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (Vec3& v : scene.grains.velocity) v = Vec3(unit(random), unit(random), unit(random));
        Vec3 before = Vec3::Zero();
        double scale = 0.0;
        for (std::size_t i = 0; i < scene.grains.size(); ++i)
        {
            before += scene.grains.mass[i]*scene.grains.velocity[i];
            scale += scene.grains.mass[i]*scene.grains.velocity[i].norm();
        }
        RankedScene run(scene, nscd::ContactSettings(), cut.ownerOf);
        std::size_t contacts = 0;
        for (int k = 0; k < 40; ++k) contacts += step(run.dynamics(), Vec3::Zero(), deltaT).solve.contacts;
        EXPECT_GT(contacts, 100u);
        const nscd::Grains after = run.gatherGrains();
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < after.size(); ++i) sum += after.mass[i]*after.velocity[i];
        EXPECT_LT((sum - before).norm(), 1e-12*scale) << cut.name;
    }
}

TEST(Ranks, overlapBetweenRanksIsRemoved)
{
    for (const Cut& cut : cuts())
    {
        Scene scene = heap(3, 8, 4, radius, 1.0, 0.3);
        for (Vec3& x : scene.grains.position) x *= 0.87;
        RankedScene run(scene, nscd::ContactSettings(), cut.ownerOf);
        nscd::StepReport report;
        for (int k = 0; k < 30; ++k) report = step(run.dynamics(), Vec3::Zero(), deltaT);
        const nscd::Grains all = run.gatherGrains();
        double deepest = 0.0;
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            for (std::size_t j = 0; j < i; ++j)
            {
                deepest = std::max(deepest, all.radius[i] + all.radius[j] - (all.position[i] - all.position[j]).norm());
            }
        }
        EXPECT_LT(deepest, 6e-4*2*radius) << cut.name;
    }
}

TEST(Ranks, twoRunsAreTheSameToTheBit)
{
    const Scene scene = heap(3, 8, 6, radius, 0.7, friction);
    const auto run = [&]
    {
        RankedScene ranked(scene, nscd::ContactSettings(), cuts()[1].ownerOf);
        for (int k = 0; k < 60; ++k) step(ranked.dynamics(), scene.g, deltaT);
        return ranked.gatherGrains();
    };
    const nscd::Grains one = run(), other = run();
    for (std::size_t i = 0; i < one.size(); ++i)
    {
        ASSERT_EQ(one.position[i], other.position[i]);
        ASSERT_EQ(one.velocity[i], other.velocity[i]);
        ASSERT_EQ(one.omega[i], other.omega[i]);
    }
}

TEST(Ranks, onlySweepsWorkAcrossThem)
{
    if (ranks() == 1) GTEST_SKIP() << "one rank";
    for (const char* solver : {"queue", "APG"})
    {
        nscd::ContactSettings settings;
        settings.solver = solver;
        EXPECT_THROW(RankedScene(heap(3, 2, 2, radius, 1.0, 0.3), settings, cuts()[0].ownerOf), std::invalid_argument);
    }
}

TEST(Ranks, conjugateGradientsWorkAcrossThem)
{
    const Scene scene = heap(3, 6, 6, radius, 0.7, 0.3);
    nscd::ContactSettings settings;
    settings.solver = "NNCG";
    RankedScene run(scene, settings, cuts(6)[1].ownerOf);
    int loaded = 0;
    for (int k = 0; k < 100; ++k)
    {
        const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
        EXPECT_TRUE(report.solve.converged) << k;
        EXPECT_LE(report.solve.residualRms, settings.tolerance*report.solve.speedScale) << k;
        loaded += report.solve.contacts > 100;
    }
    EXPECT_GT(loaded, 10);
}

TEST(Ranks, contactsHoldAllThatGrainsGetReboundsIncluded)
{
    Scene scene = heap(3, 6, 4, radius, 0.6, friction);
    for (int a : {0, 1}) for (int b : {0, 1}) scene.materials.setPair(a, b, {friction, 0.6});
    for (const Cut& cut : cuts(6))
    {
        RankedScene run(scene, nscd::ContactSettings(), cut.ownerOf);
        for (int k = 0; k < 40; ++k)
        {
            const nscd::Grains before = run.gatherGrains();
            step(run.dynamics(), scene.g, deltaT);
            const nscd::Grains after = run.gatherGrains();
            const std::vector<Vec3> impulses = sumOfImpulses(run.gatherContacts(), before.size());
            ASSERT_LT(worstImbalance(before, after, impulses, scene.g, deltaT, [](std::size_t) { return true; }), 1e-11) << cut.name << ", step " << k;
        }
    }
}

TEST(Ranks, aVolleyStaysOnItsSideOfAWavySheet)
{
    const Scene scene = volleyAtSheet();
    for (const OwnerOf& ownerOf : {OwnerOf([](const Vec3&, std::int64_t id) { return static_cast<int>((id*7919) % ranks()); }),
                                   OwnerOf([](const Vec3&, std::int64_t) { return ranks() - 1; })})
    {
        RankedScene run(scene, nscd::ContactSettings(), ownerOf);
        for (int k = 0; k < 3; ++k)
        {
            step(run.dynamics(), scene.g, deltaT);
            for (const Vec3& x : run.gatherGrains().position) EXPECT_GT(x[2], waveHeight(x)) << k;
        }
    }
}

TEST(Ranks, aRowOfShotsStopsBehindItsFirst)
{
    // Seven in a row, each of another rank than the one before, 20 d a step onto a sheet; and the same on one rank.
    Scene scene(3, 0.3, 0.5);
    scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), wavySheet(60));
    for (int k = 0; k < 7; ++k)
    {
        scene.addGrain(Vec3(0.001, 0.002, 0.03 + 0.0055*k), 0.0025);
        scene.grains.velocity.back() = Vec3(0, 0, -100);
    }
    RankedScene run(scene, nscd::ContactSettings(), [](const Vec3&, std::int64_t id) { return static_cast<int>(id % ranks()); });
    auto alone = scene.build(nscd::ContactSettings());
    const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT), expected = step(alone, scene.g, deltaT);
    EXPECT_EQ(report.stoppedOnWay, 7u);
    EXPECT_EQ(expected.stoppedOnWay, 7u);
    const nscd::Grains all = run.gatherGrains();
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_LT((all.position[i] - alone.grains().position[i]).norm(), 1e-12) << i;
    for (int k = 0; k < 5; ++k) step(run.dynamics(), scene.g, deltaT);
    for (const Vec3& x : run.gatherGrains().position) EXPECT_GT(x[2], waveHeight(x));
}
