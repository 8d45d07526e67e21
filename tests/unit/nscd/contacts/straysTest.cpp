// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lists that are mended for strays against all pairs that may meet, and steps on such lists.
#include "nscd/contacts/listBlocks.hpp"
#include "nscd/contacts/strays.hpp"
#include "nscd/step/sweptPairs.hpp"
#include "unit/nscd/scenes/gases.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <map>

using namespace scenes;

namespace
{

constexpr double pathTime = 2.0, slack = 0.02;

/// The list of a scene whose grains go on with their velocities for `pathTime`, give or take a slack.
nscd::ContactList listByPaths(const Scene& scene)
{
    nscd::Exchange alone;
    const nscd::WallSearch wallSearch(scene.walls, 2*meanDiameter(scene));
    std::vector<double> reach;
    for (const Vec3& v : scene.grains.velocity) reach.push_back(slack + pathTime*v.norm());
    nscd::ExpectedMotion expected;
    expected.velocity = scene.grains.velocity;
    expected.time = pathTime;
    for (const Vec3& v : scene.grains.velocity) expected.meanVelocity += v/static_cast<double>(scene.grains.size());
    expected.areStraysFollowed = true;
    nscd::ContactList list = nscd::buildContactList(partsOf(scene), wallSearch, reach, {}, meanDiameter(scene), alone, nscd::ContactList(), expected);
    nscd::updateGeometry(list, partsOf(scene));
    for (int body = 0; body < list.owned(); ++body)
    {
        for (int k = 0; k < 3; ++k) list.bodies[body].v[k] = scene.grains.velocity[list.grainOf[body]][k];
    }
    return list;
}

/// All go on as they do.
void move(nscd::ContactList& list, double deltaT)
{
    for (int body = 0; body < list.owned(); ++body) list.position[body] += deltaT*Vec3(list.bodies[body].v);
    list.age += deltaT;
}

bool follow(nscd::ContactList& list, const std::vector<int>& strays, const Scene& scene, const nscd::Exchange& exchange = nscd::Exchange())
{
    const nscd::WallSearch wallSearch(scene.walls, 2*meanDiameter(scene));
    return nscd::followStrays(list, strays, partsOf(scene), wallSearch, exchange, 0.5*pathTime);
}

/// Strays that are many have no room otherwise.
void makeRoom(nscd::ContactList& list, const Scene& scene, std::size_t blocks)
{
    nscd::appendFreeBlocks(list, partsOf(scene), blocks);
    list.interfaceBlock = list.blocks.size();
}

Vec3 randomVelocity(double speed, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    return speed*Vec3(unit(random), unit(random), unit(random));
}

/// How often a list has pairs of bodies, lower one first, by their image.
std::map<std::tuple<int, int, std::array<signed char, 3>>, int> pairsOf(const nscd::ContactList& list)
{
    std::map<std::tuple<int, int, std::array<signed char, 3>>, int> pairs;
    for (std::size_t slot : usedSlots(list))
    {
        auto [a, b] = bodiesOf(list, slot);
        if (list.wall[slot] >= 0) continue;
        std::array<signed char, 3> image = list.image[slot];
        if (a > b)
        {
            std::swap(a, b);
            for (signed char& shift : image) shift = static_cast<signed char>(-shift);
        }
        ++pairs[{a, b, image}];
    }
    return pairs;
}

/// Whether two bodies may come to touch before the list's time is over, if each stays within the slack of its velocity: at many instants.
bool mayTouch(const nscd::ContactList& list, int a, int b, const Vec3& shift)
{
    for (int k = 0; k <= 100; ++k)
    {
        const double left = 0.01*k*(pathTime - list.age);
        const Vec3 x = list.position[a] + left*Vec3(list.bodies[a].v) - list.position[b] - left*Vec3(list.bodies[b].v) - shift;
        if (x.norm() < list.radius[a] + list.radius[b] + 2*slack) return true;
    }
    return false;
}

/// A cloud far above its floor, periodic along x and y, in which each grain has a velocity, and all have one in common.
Scene flyingCloud(int grains, double speed, std::mt19937& random)
{
    Scene scene = cloud(grains);
    for (Vec3& x : scene.grains.position) x.z() += 1.0;
    for (Vec3& v : scene.grains.velocity) v = Vec3(3*speed, 0, 0) + randomVelocity(speed, random);
    return scene;
}

} // namespace

TEST(Strays, areThoseFurtherOffTheirPathsThanTheSlack)
{
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 4; ++i)
    {
        scene.addGrain(Vec3(i, 0, 0), 0.1);
        scene.grains.velocity.back() = Vec3(0, 0.3, 0);
    }
    nscd::ContactList list = listByPaths(scene);
    const double deltaT = 0.5*pathTime;
    EXPECT_TRUE(nscd::findStrays(list, deltaT, 4).empty());
    setVelocity(list, 1, Vec3(0, 0.3, 0.99*slack/deltaT));
    setVelocity(list, 2, Vec3(0, 0.3, 1.01*slack/deltaT));
    setVelocity(list, 3, Vec3::Zero());
    EXPECT_EQ(nscd::findStrays(list, deltaT, 4), (std::vector<int>{std::min(bodyOf(list, 2), bodyOf(list, 3)), std::max(bodyOf(list, 2), bodyOf(list, 3))}));
    EXPECT_EQ(nscd::findStrays(list, deltaT, 0).size(), 1);
    EXPECT_TRUE(nscd::isWithinTime(list, deltaT));
    list.age = 0.6*pathTime;
    EXPECT_FALSE(nscd::isWithinTime(list, deltaT));
}

TEST(Strays, meetAllThatTheyMayMeetOnTheirNewPaths)
{
    std::mt19937 random(3);
    std::size_t lacking = 0;
    for (const double age : {0.0, 0.4*pathTime})
    {
        const Scene scene = flyingCloud(300, 0.02, random);
        nscd::ContactList list = listByPaths(scene);
        makeRoom(list, scene, 10*list.blocks.size());
        const auto before = pairsOf(list);
        move(list, age);
        // One body in ten, in two turns: of the second those of the first are strays too.
        for (const int turn : {0, 5})
        {
            std::vector<int> strays;
            for (int body = turn; body < list.owned(); body += 10) strays.push_back(body);
            for (int body : strays) setVelocity(list, list.grainOf[body], Vec3(0.06, 0, 0) + randomVelocity(0.1, random));
            ASSERT_TRUE(follow(list, strays, scene));
            EXPECT_TRUE(nscd::findStrays(list, pathTime - age, 300).empty());
        }
        const auto after = pairsOf(list);
        for (const auto& pair : after) EXPECT_EQ(pair.second, 1);
        for (int a = 0; a < list.owned(); a += 5)
        for (int b = 0; b < list.owned(); ++b)
        for (signed char i = -2; i <= 2; ++i)
        for (signed char j = -2; j <= 2; ++j)
        {
            if (a == b || !mayTouch(list, a, b, Vec3(i, j, 0))) continue;
            const std::array<signed char, 3> image{i, j, 0}, opposite{static_cast<signed char>(-i), static_cast<signed char>(-j), 0};
            const std::tuple key(std::min(a, b), std::max(a, b), a < b ? image : opposite);
            EXPECT_EQ(after.count(key), 1) << a << " " << b << " " << int(i) << " " << int(j);
            lacking += 1 - before.count(key);
        }
    }
    EXPECT_GT(lacking, 100);   // seen: 265
}

TEST(Strays, areAppendedWithTheirGeometryAsFastPairs)
{
    Scene scene(3, 0.3, 0.5);
    for (const double x : {0.0, 1.0, 5.0}) scene.addGrain(Vec3(x, 0, 0), 0.1);
    nscd::ContactList list = listByPaths(scene);
    ASSERT_EQ(list.candidates, 0);
    setVelocity(list, 0, Vec3(0.5, 0, 0));
    ASSERT_TRUE(follow(list, {bodyOf(list, 0)}, scene));
    ASSERT_EQ(list.candidates, 1);
    const std::size_t slot = usedSlots(list)[0];
    EXPECT_NEAR(list.gap[slot], 0.8, 1e-15);
    EXPECT_NEAR(std::abs(nscd::normal(list, slot).x()), 1.0, 1e-15);
    EXPECT_EQ(list.blocks[slot/nscd::blockLanes].friction[slot % nscd::blockLanes], 0.3);
    EXPECT_EQ(list.restitution[slot], 0.5);
    EXPECT_EQ(list.fastPairs, std::vector<std::size_t>{slot});
    // They touch after 1.6 s.
    EXPECT_FALSE(nscd::doAnyTouch(list, partsOf(scene), 0, 1.5));
    EXPECT_TRUE(nscd::doAnyTouch(list, partsOf(scene), 0, 1.7));
}

TEST(Strays, mayPassWhatTheyAreListedWith)
{
    // At rest, beside one another: a pair that is slow until one of them is struck, and then goes past the other.
    Scene scene(3, 0.3, 0.0);
    for (const double x : {0.0, 0.23, 0.46}) scene.addGrain(Vec3(x, 0, 0), 0.1);
    nscd::ContactList list = listByPaths(scene);
    nscd::findFastPairs(list);
    ASSERT_EQ(list.candidates, 2);
    ASSERT_TRUE(list.fastPairs.empty());
    list.fastPairs.push_back(usedSlots(list)[0]);
    list.fastPairs.shrink_to_fit();
    setVelocity(list, 0, Vec3(0.05, 0.3, 0));
    ASSERT_TRUE(follow(list, {bodyOf(list, 0)}, scene));
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        const bool isOfStray = a == bodyOf(list, 0) || b == bodyOf(list, 0);
        EXPECT_EQ(std::count(list.fastPairs.begin(), list.fastPairs.end(), slot), isOfStray || slot == usedSlots(list)[0]);
    }
    EXPECT_TRUE(std::is_sorted(list.fastPairs.begin(), list.fastPairs.end()));
}

TEST(Strays, withoutPathsMayGoAnywhereAsFast)
{
    constexpr double reach = 0.03;
    std::mt19937 random(4);
    Scene scene = flyingCloud(300, 0.0, random);
    nscd::ContactList list = listContacts(scene, reach);
    makeRoom(list, scene, list.blocks.size());
    const auto before = pairsOf(list);
    std::vector<int> strays;
    for (int body = 0; body < list.owned(); body += 10)
    {
        strays.push_back(body);
        list.position[body] += 0.5*reach*Vec3::UnitX();
        setVelocity(list, list.grainOf[body], randomVelocity(0.1, random));
    }
    ASSERT_TRUE(follow(list, strays, scene));
    EXPECT_TRUE(nscd::findStrays(list, 0.5*pathTime, 300).empty());
    const auto after = pairsOf(list);
    std::size_t lacking = 0;
    for (int a : strays)
    for (int b = 0; b < list.owned(); ++b)
    for (signed char i = -1; i <= 1; ++i)
    for (signed char j = -1; j <= 1; ++j)
    {
        const double range = std::max(reach, 0.5*pathTime*Vec3(list.bodies[a].v).norm()) + std::max(reach, 0.5*pathTime*Vec3(list.bodies[b].v).norm());
        if (a == b || (list.position[a] - list.position[b] - Vec3(i, j, 0)).norm() > list.radius[a] + list.radius[b] + range) continue;
        const std::array<signed char, 3> image{i, j, 0}, opposite{static_cast<signed char>(-i), static_cast<signed char>(-j), 0};
        const std::tuple key(std::min(a, b), std::max(a, b), a < b ? image : opposite);
        EXPECT_EQ(after.count(key), 1) << a << " " << b;
        lacking += 1 - before.count(key);
    }
    EXPECT_GT(lacking, 50);   // seen: 288
}

TEST(Strays, thatReachFurtherThanHalfAPeriodOrNowhereAreNotFollowed)
{
    std::mt19937 random(5);
    const Scene scene = flyingCloud(20, 0.0, random);
    for (const double speed : {1.0/pathTime, std::numeric_limits<double>::quiet_NaN()})
    {
        nscd::ContactList list = listByPaths(scene);
        makeRoom(list, scene, 100);
        setVelocity(list, 3, Vec3(0, speed, 0));
        ASSERT_EQ(nscd::findStrays(list, 0.5*pathTime, 20), std::vector<int>{bodyOf(list, 3)});
        EXPECT_FALSE(follow(list, {bodyOf(list, 3)}, scene));
        nscd::ContactList withoutPaths = listContacts(scene, slack);
        makeRoom(withoutPaths, scene, 100);
        setVelocity(withoutPaths, 3, Vec3(0, speed, 0));
        EXPECT_FALSE(follow(withoutPaths, {bodyOf(withoutPaths, 3)}, scene));
    }
}

TEST(Strays, forWhichThereIsNoRoomNeedAList)
{
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 30; ++i) scene.addGrain(Vec3(i, 0, 0), 0.1);
    nscd::ContactList list = listByPaths(scene);
    setVelocity(list, 0, Vec3(15, 0, 0));   // meets all others, each in a block of its own
    EXPECT_FALSE(follow(list, {bodyOf(list, 0)}, scene));
    EXPECT_EQ(list.candidates, 0);
}

TEST(Strays, nearGrainsOfOtherRanksNeedAList)
{
    struct Neighbors : nscd::Exchange
    {
        bool isAwayFromOthers(const Vec3& center, double size) const override { return center.x() + size < 1.0; }
    };
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3::Zero(), 0.1);
    nscd::ContactList list = listByPaths(scene);
    const double most = (1.0 - 0.1 - slack)/pathTime;
    setVelocity(list, 0, Vec3(0.99*most, 0, 0));
    EXPECT_TRUE(follow(list, {0}, scene, Neighbors()));
    setVelocity(list, 0, Vec3(1.01*most, 0, 0));
    EXPECT_FALSE(follow(list, {0}, scene, Neighbors()));
}

TEST(Strays, thatComeToOtherWallsNeedAList)
{
    Scene scene(3, 0.3, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (const double z : {0.101, 1.0}) scene.addGrain(Vec3(z, 0, z), 0.1);
    nscd::ContactList list = listByPaths(scene);
    ASSERT_EQ(list.slotsOfWalls.size(), 1);
    setVelocity(list, 0, Vec3(0.1, 0, -0.1));
    EXPECT_TRUE(follow(list, {bodyOf(list, 0)}, scene));
    setVelocity(list, 1, Vec3(0, 0, -0.3));
    EXPECT_TRUE(follow(list, {bodyOf(list, 1)}, scene));
    setVelocity(list, 1, Vec3(0, 0, -0.5));
    EXPECT_FALSE(follow(list, {bodyOf(list, 1)}, scene));
}

TEST(Strays, meetWhatTheySolveAnewFor)
{
    constexpr double radius = 0.01, deltaT = 1e-3, speed = 3*radius/deltaT;
    Scene scene(3, 0.3, 0.0);
    // A heavy grain comes, over five steps, to a row of three that touch; the last of these goes further than its slack then, to one that no impact was foreseen for.
    const double places[] = {-17, 0, 2, 4, 8.6};
    for (const double place : places) scene.addGrain(Vec3(place*radius, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(speed, 0, 0);
    scene.grains.mass[0] *= 100.0;
    // Layers that go past one another, never to touch, make lists long.
    for (int n = 0; n < 600; ++n)
    {
        scene.addGrain(Vec3(n % 10, 100 + n/10 % 10, n/100)*3*radius, radius);
        scene.grains.velocity.back() = Vec3(n/100 % 2 == 0 ? 0.5*speed : -0.5*speed, 0, 0);
    }
    auto dynamics = scene.build();
    for (int k = 0; k < 8; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_LT(report.overlapUncorrected, 1e-6) << k;
    }
    EXPECT_GT(dynamics.grains().velocity[4].x(), 0.0);
}

TEST(Strays, spareAGasLists)
{
    constexpr double radius = 0.01, deltaT = 1e-3, width = 0.255;
    const Scene scene = heavyAndLightGas(width, radius, deltaT);
    auto dynamics = scene.build(nscd::ContactSettings());
    int lists = 0;
    double nearest = width, uncorrected = 0.0;
    for (int k = 0; k < 100; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        lists += report.listRebuilt;
        uncorrected = std::max(uncorrected, report.overlapUncorrected);
        nearest = std::min(nearest, smallestDistance(dynamics.grains().position));
    }
    EXPECT_LT(uncorrected, 1e-3);
    EXPECT_GT(nearest, 2*radius*(1 - 1e-3));
    EXPECT_LE(lists, 62);   // seen: 55, and 71 where each stray makes a new one
}
