// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that enter on several ranks: the same, at the same places and under the same identities, as on one rank.
#include "rankedScene.hpp"

#include "nscd/tools/grainEntry.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double top = 0.15;   // of the space that ranks know, below that of the regions

/// The slab along x that a place is in, of a tenth of a meter.
int slabOf(const Vec3& x) { return std::min(ranks() - 1, static_cast<int>(10.0*x[0]*ranks())); }

nscd::EntrySource source(const nscd::Region& region, double rate)
{
    nscd::EntrySource source;
    source.region = region;
    source.sizes = nscd::tabulatedSizes({{0.004, 1}, {0.009, 1}});
    source.density = 2500;
    source.amount = [rate](double time) { return rate*time; };
    return source;
}

/// Grains that others have to share with those that enter, of all ranks; the walls are a floor, a plate and two sides.
Scene beginning()
{
    Scene scene(3, 0.3, 0.0);
    for (int k = 0; k < 60; ++k)
    {
        scene.grains.add({0.01 + 0.02*(k % 5), 0.01 + 0.02*(k/5 % 4), 0.02 + 0.04*(k/20)}, 0.004 + 0.0001*(k % 7), 2500, 0, k);
    }
    const int box = scene.walls.addPatch("box", 1);
    scene.walls.addPlane(box, Vec3::Zero(), Vec3::UnitZ());
    scene.walls.addPlane(box, Vec3::Zero(), Vec3::UnitX());
    scene.walls.addPlane(box, {0.1, 0, 0}, -Vec3::UnitX());
    scene.walls.addPolygon(scene.walls.addPatch("plate", 1), {{0.03, 0.02, 0.1}, {0.07, 0.02, 0.1}, {0.07, 0.06, 0.1}, {0.03, 0.06, 0.1}});
    scene.box.length[1] = 0.08;
    return scene;
}

/// Two sources, the second of which reaches out of the space.
nscd::GrainEntry entryInto(const Scene& scene, const std::shared_ptr<nscd::Exchange>& exchange, const std::function<int(const Vec3&)>& rankOf)
{
    nscd::EntrySpace space{scene.grains.shape, scene.box, exchange, rankOf};
    const std::vector<nscd::EntrySource> sources =
    {
        source(nscd::boxRegion({0, 0, 0}, {0.1, 0.08, 0.12}), 900), source(nscd::sphereRegion({0.05, 0, 0.15}, 0.04), 600)
    };
    return nscd::GrainEntry(sources, space, std::vector<nscd::EntryState>(2), 60);
}

void expectSameStates(const nscd::GrainEntry& a, const nscd::GrainEntry& b)
{
    for (std::size_t s = 0; s < 2; ++s)
    {
        EXPECT_EQ(a.states()[s].due, b.states()[s].due);
        EXPECT_EQ(a.states()[s].entered, b.states()[s].entered);
        EXPECT_EQ(a.states()[s].tried, b.states()[s].tried);
        EXPECT_EQ(a.states()[s].enteredMass, b.states()[s].enteredMass);
    }
}

} // namespace

/// Nothing moves, so that grains are the same to the bit; owners are others than the slabs that new grains go to.
TEST(GrainEntryOnRanks, letsTheSameGrainsInAtTheSamePlaces)
{
    const Scene scene = beginning();
    nscd::GrainDynamics alone(scene.grains, scene.materials, scene.walls, scene.box, {});
    nscd::GrainEntry ofOne = entryInto(scene, std::make_shared<nscd::Exchange>(), [](const Vec3& x) { return x[2] < top ? 0 : -1; });
    RankedScene ranked(scene, {}, [](const Vec3&, std::int64_t id) { return static_cast<int>(id % ranks()); });
    const auto exchange = std::make_shared<nscd::MpiExchange>();
    // Each rank knows its own slab and the beginning of the next.
    const auto rankOf = [&](const Vec3& x)
    {
        const int rank = slabOf(x);
        return x[2] < top && (rank == exchange->rank() || rank == exchange->rank() + 1) ? rank : -1;
    };
    nscd::GrainEntry ofAll = entryInto(scene, exchange, rankOf);
    for (int k = 1; k <= 10; ++k)
    {
        EXPECT_EQ(ofOne.enter(alone, 0.1*k), ofAll.enter(ranked.dynamics(), 0.1*k));
        expectSameStates(ofOne, ofAll);
    }
    ASSERT_GT(ofOne.states()[0].waiting(), 20);
    ASSERT_GT(ofOne.states()[1].waiting(), 20);
    ASSERT_GT(alone.grains().size(), 150u);

    const nscd::Grains& all = alone.grains();
    const nscd::Grains& own = ranked.dynamics().grains();
    double number = static_cast<double>(own.size());
    exchange->sum(&number, 1);
    EXPECT_EQ(number, static_cast<double>(all.size()));
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const std::size_t k = static_cast<std::size_t>(own.id[i]);
        EXPECT_EQ(own.position[i], all.position[k]);
        EXPECT_EQ(own.radius[i], all.radius[k]);
        EXPECT_LT(own.position[i][2], top);
        if (k >= 60) EXPECT_EQ(slabOf(own.position[i]), exchange->rank());
    }
}
