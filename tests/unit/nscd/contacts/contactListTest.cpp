// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lists of grains that are expected to move on as they do: what is left out, and when a list is stale.
#include "nscd/step/contactStep.hpp"
#include "unit/nscd/scenes/scenes.hpp"
#include "nscd/search/wallSearch.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3, margin = 0.05*radius;

using Pairs = std::set<std::pair<int, int>>;

struct Listed
{
    nscd::ContactList list;

    /// Each grain may be `slack` off its path.
    Listed(const Scene& scene, double slack, double time, bool isExpected)
    {
        nscd::ExpectedMotion expected;
        expected.time = time;
        if (isExpected) expected.velocity = scene.grains.velocity;
        for (const Vec3& v : scene.grains.velocity) expected.meanVelocity += v/static_cast<double>(scene.grains.size());
        nscd::Exchange alone;
        const nscd::Scene parts{scene.grains, scene.materials, scene.walls, scene.box};
        std::vector<double> reaches;
        for (const Vec3& v : scene.grains.velocity) reaches.push_back(slack + time*v.norm());
        list = nscd::buildContactList(parts, nscd::WallSearch(scene.walls, 4*radius), reaches, {}, 2*radius, alone, nscd::ContactList(), expected);
        for (std::size_t body = 0; body < list.grainOf.size(); ++body)
        {
            for (int k = 0; k < 3; ++k) list.bodies[body].v[k] = scene.grains.velocity[list.grainOf[body]][k];
        }
    }

    Pairs pairs() const
    {
        Pairs found;
        for (std::size_t slot = 0; slot < list.slots(); ++slot)
        {
            if (!list.isUsed(slot)) continue;
            const nscd::ContactBlock& block = list.blocks[slot/nscd::blockLanes];
            found.insert(std::minmax(list.grain(block.a[slot % nscd::blockLanes]), list.grain(block.b[slot % nscd::blockLanes])));
        }
        return found;
    }

    int bodyOf(int grain) const { return static_cast<int>(std::find(list.grainOf.begin(), list.grainOf.end(), grain) - list.grainOf.begin()); }
};

/// A dense periodic cloud that shears, with some motion of its own.
Scene shearedCloud()
{
    Scene scene(3, 0.3, 0.0);
    const double length = 12*radius;
    scene.box.length = Vec3::Constant(length);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int k = 0; k < 400; ++k)
    {
        const Vec3 x = 0.5*length*Vec3(unit(random) + 1, unit(random) + 1, unit(random) + 1);
        scene.addGrain(x, radius);
        scene.grains.velocity.back() = Vec3(30*x[2], 0, 0) + 0.3*Vec3(unit(random), unit(random), unit(random));
    }
    return scene;
}

double shortestDistance(const Scene& scene, const Vec3& x)
{
    Vec3 nearest = x;
    for (int axis = 0; axis < 3; ++axis) nearest[axis] -= scene.box.length[axis]*std::round(x[axis]/scene.box.length[axis]);
    return nearest.norm();
}

} // namespace

TEST(ExpectedMotion, grainsThatMoveTogetherOrApartAreNoCandidates)
{
    Scene scene(3, 0.3, 0.0);
    const auto addTwo = [&](double y, double distance, double speed, double otherSpeed)
    {
        scene.addGrain(Vec3(0, y, 0), radius);
        scene.grains.velocity.back() = Vec3(speed, 0, 0);
        scene.addGrain(Vec3(distance, y, 0), radius);
        scene.grains.velocity.back() = Vec3(otherSpeed, 0, 0);
    };
    addTwo(0.0, 2.5*radius, 5, 5);
    addTwo(20*radius, 3.2*radius, 2, 5);   // by 0.9 radii in the time
    addTwo(40*radius, 3.2*radius, 5, 2);
    EXPECT_EQ(Listed(scene, 0.2*radius, 3*deltaT, false).pairs(), (Pairs{{0, 1}, {2, 3}, {4, 5}}));
    EXPECT_EQ(Listed(scene, 0.2*radius, 3*deltaT, true).pairs(), (Pairs{{4, 5}}));
}

/// Each grain anywhere within its slack around its path, at any time of it, and around its end later: none that is left out touches.
TEST(ExpectedMotion, noPairThatComesToTouchIsLeftOut)
{
    const Scene scene = shearedCloud();
    const double time = 3*deltaT;
    const Listed listed(scene, 0.3*radius, time, true);
    const Pairs pairs = listed.pairs();
    EXPECT_LT(2*pairs.size(), 3*Listed(scene, 0.3*radius, time, false).pairs().size());
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    const int grains = static_cast<int>(scene.grains.size());
    int touching = 0, onWay = 0;
    for (int sample = 0; sample <= 20; ++sample)
    {
        std::vector<Vec3> x(grains);
        for (int i = 0; i < grains; ++i)
        {
            const int body = listed.bodyOf(i);
            const Vec3 off(normal(random), normal(random), normal(random));
            x[i] = scene.grains.position[i] + sample/20.0*listed.list.path[body] + 0.999*listed.list.slack[body]*off.normalized();
            onWay += listed.list.path[body] != Vec3::Zero();
        }
        for (int i = 0; i < grains; ++i)
        for (int j = i + 1; j < grains; ++j)
        {
            if (shortestDistance(scene, x[i] - x[j]) >= 2*radius) continue;
            ++touching;
            EXPECT_TRUE(pairs.count({i, j})) << i << ' ' << j << " at " << sample;
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(onWay, 21*grains/2);
}

TEST(ExpectedMotion, aListIsStaleOnceAGrainIsElsewhere)
{
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 2; ++i)
    {
        scene.addGrain(Vec3(2.5*radius*i, 0, 0), radius);
        scene.grains.velocity.back() = Vec3(5, 0, 0);
    }
    Listed listed(scene, margin, 3*deltaT, true);
    nscd::ContactList& list = listed.list;
    ASSERT_NEAR(list.slack[0], margin, 1e-12*radius);
    for (int step = 0; step < 3; ++step)
    {
        EXPECT_TRUE(nscd::coversMotion(list, deltaT, true)) << step;
        list.bodies[1].v[1] = 1.1*(step + 1)*margin/deltaT;   // thrown off its path
        EXPECT_FALSE(nscd::coversMotion(list, deltaT, true)) << step;
        list.bodies[1].v[1] = 0.0;
        nscd::moveGrains(list, scene.grains, scene.box, deltaT, false);
    }
    // Where the path ends, grains are expected to stay.
    EXPECT_FALSE(nscd::coversMotion(list, deltaT, true));
    for (int body = 0; body < 2; ++body) list.bodies[body].v[0] = 0.9*margin/deltaT;
    EXPECT_TRUE(nscd::coversMotion(list, deltaT, true));
}
