// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that enter: numbers and masses against rates, no overlap, waiting, one sequence for any steps and stops.
#include "nscd/search/overlaps.hpp"
#include "nscd/tools/grainEntry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using nscd::Vec3;

namespace
{

constexpr double density = 2500.0;

/// A channel along y with a shelf in it, gravity, and grains that enter above it.
struct Pour
{
    nscd::PeriodicBox box;
    nscd::GrainDynamics dynamics;
    nscd::GrainEntry entry;

    Pour(const std::vector<nscd::EntrySource>& sources, const nscd::PeriodicBox& periods = {}, const nscd::ContactSettings& settings = {}) :
        box(periods), dynamics({}, materials(), walls(), periods, settings), entry(sources, {{}, periods}, std::vector<nscd::EntryState>(sources.size()), 0)
    {}

    static nscd::Materials materials()
    {
        nscd::Materials materials;
        materials.add("glass");
        materials.setPair(0, 0, {0.3, 0.0});
        return materials;
    }

    static nscd::Walls walls()
    {
        nscd::Walls walls;
        const int box = walls.addPatch("box", 0);
        for (const int axis : {0, 2})
        {
            walls.addPlane(box, Vec3::Zero(), Vec3::Unit(axis));
            walls.addPlane(box, {0.1, 0.1, 0.2}, -Vec3::Unit(axis));
        }
        walls.addPolygon(walls.addPatch("shelf", 0), {{0.03, 0.03, 0.05}, {0.07, 0.03, 0.05}, {0.07, 0.07, 0.05}, {0.03, 0.07, 0.05}});
        return walls;
    }

    void expectNoOverlap() const
    {
        EXPECT_TRUE(nscd::grainOverlaps(dynamics.grains(), box, 2e-3).empty());
        EXPECT_TRUE(nscd::wallOverlaps(dynamics.grains(), dynamics.walls(), 2e-3).empty());
    }

    bool enter(double time) { return entry.enter(dynamics, time) > 0; }

    nscd::StepReport step(double deltaT)
    {
        dynamics.beginStep(deltaT);
        return dynamics.advance(nscd::gravityForces(dynamics.grains(), {0, 0, -9.81}, deltaT));
    }
};

nscd::EntrySource source(double rate, const nscd::Region& region = nscd::boxRegion({0, 0, 0.1}, {0.1, 0.1, 0.2}))
{
    nscd::EntrySource source;
    source.region = region;
    source.sizes = nscd::tabulatedSizes({{0.006, 1}, {0.012, 1}});
    source.density = density;
    source.velocity = {0, 0, -0.5};
    source.amount = [rate](double time) { return rate*time; };
    return source;
}

} // namespace

TEST(GrainEntry, letsInWhatIsDue)
{
    Pour pour({source(200)});
    for (int k = 0; k < 500; ++k)
    {
        const double time = 1e-3*(k + 1);
        pour.enter(time);
        pour.step(1e-3);
        const nscd::EntryState state = pour.entry.states()[0];
        ASSERT_EQ(state.due, (k + 1)/5);
        ASSERT_EQ(state.entered, std::int64_t(pour.dynamics.grains().size()));
    }
    EXPECT_EQ(pour.entry.states()[0].entered, 100);
}

TEST(GrainEntry, addsUpMasses)
{
    nscd::EntrySource byMass = source(0.2);
    byMass.isMass = true;
    Pour pour({byMass});
    const double largest = density*M_PI/6.0*0.012*0.012*0.012;
    for (int k = 1; k <= 100; ++k)
    {
        const double time = 2e-3*k;
        pour.enter(time);
        const nscd::EntryState state = pour.entry.states()[0];
        ASSERT_LE(state.dueMass, 0.2*time*(1.0 + 1e-8));
        ASSERT_GT(state.dueMass, 0.2*time - largest);
    }
    double sum = 0.0;
    for (const double mass : pour.dynamics.grains().mass) sum += mass;
    EXPECT_EQ(pour.entry.states()[0].waiting(), 0);
    EXPECT_NEAR(pour.entry.states()[0].enteredMass, sum, 1e-12*sum);
}

TEST(GrainEntry, endsWithANumber)
{
    nscd::EntrySource some = source(1e4);
    some.number = 7;
    Pour pour({some});
    pour.enter(1.0);
    EXPECT_FALSE(pour.enter(2.0));
    EXPECT_EQ(pour.dynamics.grains().size(), 7u);
    EXPECT_EQ(pour.entry.states()[0].due, 7);
}

/// More than the region holds, which reaches behind walls and across a period.
TEST(GrainEntry, leavesNoOverlapAndLetsTheRestWait)
{
    nscd::PeriodicBox periods;
    periods.length[1] = 0.1;
    Pour pour({source(2000, nscd::boxRegion({-0.02, 0, 0}, {0.12, 0.1, 0.2}))}, periods);
    pour.enter(1.0);
    const nscd::EntryState state = pour.entry.states()[0];
    EXPECT_EQ(state.due, 2000);
    EXPECT_GT(state.entered, 300);
    EXPECT_GT(state.waiting(), 500);
    EXPECT_NEAR(state.waitingMass(), state.dueMass - state.enteredMass, 0.0);
    EXPECT_TRUE(nscd::grainOverlaps(pour.dynamics.grains(), pour.box, 0.0).empty());
    EXPECT_TRUE(nscd::wallOverlaps(pour.dynamics.grains(), pour.dynamics.walls(), 0.0).empty());
}

/// A region that fills up, empties as grains fall out of it, and takes those that waited.
TEST(GrainEntry, takesThoseThatWaitedWhenThereIsRoom)
{
    nscd::EntrySource burst = source(1e5, nscd::boxRegion({0.04, 0.04, 0.18}, {0.06, 0.06, 0.19}));
    burst.number = 60;
    Pour pour({burst});
    pour.enter(1.0);
    EXPECT_LT(pour.entry.states()[0].entered, 20);
    for (int k = 0; k < 1000; ++k)
    {
        pour.step(1e-3);
        if (pour.enter(1.0)) pour.expectNoOverlap();
    }
    EXPECT_EQ(pour.entry.states()[0].waiting(), 0);
    EXPECT_EQ(pour.dynamics.grains().size(), 60u);
}

/// Sizes depend on neither the steps nor the places; a run that goes on from states does as one that was not stopped.
TEST(GrainEntry, hasOneSequenceForAnyStepsAndStops)
{
    Pour whole({source(300), source(100)}), often({source(300), source(100)});
    whole.enter(0.5);
    for (int k = 1; k <= 50; ++k)
    {
        often.enter(0.01*k);
        if (k == 20) often.entry = nscd::GrainEntry(often.entry.sources(), {}, often.entry.states(), often.entry.nextId());
    }
    const auto radiiOf = [](const Pour& pour)
    {
        std::vector<double> radii = pour.dynamics.grains().radius;
        std::sort(radii.begin(), radii.end());
        return radii;
    };
    ASSERT_EQ(whole.dynamics.grains().size(), 200u);
    EXPECT_EQ(radiiOf(whole), radiiOf(often));
    EXPECT_NE(whole.dynamics.grains().radius[0], whole.dynamics.grains().radius[150]) << "sources have sequences of their own";
    for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(often.dynamics.grains().id[i], std::int64_t(i));
}

TEST(GrainEntry, keepsImpulsesAndVelocitiesOfThoseInside)
{
    Pour pour({source(300)});
    pour.enter(0.1);
    for (int k = 0; k < 300; ++k) pour.step(1e-3);
    const nscd::Grains before = pour.dynamics.grains();
    ASSERT_TRUE(pour.enter(0.2));
    const nscd::Grains& after = pour.dynamics.grains();
    ASSERT_GT(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after.velocity[i], before.velocity[i]);
    EXPECT_EQ(after.velocity.back(), Vec3(0, 0, -0.5));
    double lastDeltaT = 0.0;
    EXPECT_FALSE(pour.dynamics.checkpoint(lastDeltaT).empty());
}

/// Places that no rank knows hold no grain.
TEST(GrainEntry, entersWhereThePlaceIsKnown)
{
    nscd::EntrySpace space;
    space.rankOf = [](const Vec3& x) { return x[0] < 0.05 ? 0 : -1; };
    Pour pour({source(100)});
    pour.entry = nscd::GrainEntry({source(100)}, space, {nscd::EntryState()}, 0);
    pour.enter(1.0);
    ASSERT_GT(pour.dynamics.grains().size(), 50u);
    for (const Vec3& x : pour.dynamics.grains().position) EXPECT_LT(x[0], 0.05);
}

TEST(GrainEntry, wakesThoseThatSleep)
{
    nscd::ContactSettings sleepy;
    sleepy.sleep = true;
    nscd::EntrySource two = source(1.0, nscd::boxRegion({0.01, 0.01, 0.02}, {0.09, 0.09, 0.19}));
    two.number = 2;
    two.velocity = Vec3::Zero();
    Pour pour({two}, {}, sleepy);
    pour.enter(1.0);
    nscd::StepReport report;
    for (int k = 0; k < 1000; ++k) report = pour.step(1e-3);
    ASSERT_EQ(report.asleep, 1u);
    ASSERT_TRUE(pour.enter(2.0));
    EXPECT_EQ(pour.step(1e-3).asleep, 0u);
}

/// A region by functions of its own: closed until 0.1 s, and of the places it draws only those in one half count.
TEST(GrainEntry, asksARegionOfAProgram)
{
    nscd::EntrySource own = source(100), box = source(50);
    bool isOpen = false;
    own.region.begin = [&isOpen] { return isOpen; };
    own.region.draw = [](const nscd::RandomNumbers& random) { const double x = 0.1*random(); return nscd::EntryTry{{x, 0.05, 0.15}, x < 0.05 ? 0u : 1u}; };
    own.region.holds = [](const nscd::EntryTry& at) { return at.part == 1; };
    Pour pour({own, box});
    std::vector<std::size_t> sources;
    for (int k = 1; k <= 200; ++k)
    {
        isOpen = k > 100;
        const std::size_t before = pour.dynamics.grains().size();
        pour.enter(1e-3*k);
        for (const std::size_t s : pour.entry.sourcesOfLast()) sources.push_back(s);
        ASSERT_EQ(sources.size(), pour.dynamics.grains().size());
        for (std::size_t i = before; i < sources.size(); ++i)
        {
            if (sources[i] != 0) continue;
            ASSERT_TRUE(isOpen);
            ASSERT_GE(pour.dynamics.grains().position[i][0], 0.05);
        }
        if (k == 100) EXPECT_EQ(pour.entry.states()[0].waiting(), 10);
        pour.step(1e-3);
    }
    EXPECT_GT(pour.entry.states()[0].entered, 8);
    EXPECT_EQ(std::count(sources.begin(), sources.end(), 1u), 10);
}
