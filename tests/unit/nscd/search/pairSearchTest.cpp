// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pair search against brute force.
#include "nscd/search/pairSearch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

using namespace nscd;

namespace
{

using Key = std::tuple<int, int, int, int, int>;

std::set<Key> keys(const std::vector<BodyPair>& pairs)
{
    std::set<Key> found;
    for (const BodyPair& p : pairs)
    {
        const bool isNew = found.insert({p.a, p.b, p.image[0], p.image[1], p.image[2]}).second;
        EXPECT_TRUE(isNew) << "pair " << p.a << ' ' << p.b << " found twice";
        EXPECT_LT(p.a, p.b);
    }
    return found;
}

std::set<Key> bruteForce(const std::vector<Vec3>& x, const std::vector<double>& size, const PeriodicBox& box)
{
    std::set<Key> found;
    const auto images = [&](int axis) { return box.isPeriodic(axis) ? 1 : 0; };
    for (int a = 0; a < static_cast<int>(x.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(x.size()); ++b)
    for (int i = -images(0); i <= images(0); ++i)
    for (int j = -images(1); j <= images(1); ++j)
    for (int k = -images(2); k <= images(2); ++k)
    {
        const Vec3 image = x[b] + Vec3(i*box.length[0], j*box.length[1], k*box.length[2]);
        const double reach = size[a] + size[b];
        if ((x[a] - image).squaredNorm() < reach*reach) found.insert({a, b, i, j, k});
    }
    return found;
}

struct Cloud
{
    std::vector<Vec3> position;
    std::vector<double> size;
};

Cloud cloud(int bodies, const Vec3& extent, double smallest, double largest)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    Cloud cloud;
    for (int i = 0; i < bodies; ++i)
    {
        cloud.position.push_back(Vec3(unit(random), unit(random), unit(random)).cwiseProduct(extent));
        cloud.size.push_back(smallest*std::pow(largest/smallest, unit(random)));
    }
    return cloud;
}

void expectAllPairs(const Cloud& cloud, const PeriodicBox& box)
{
    const double largest = *std::max_element(cloud.size.begin(), cloud.size.end());
    const std::set<Key> expected = bruteForce(cloud.position, cloud.size, box);
    EXPECT_EQ(keys(findPairs(cloud.position, cloud.size, box, 0.9*largest)), expected);
    EXPECT_GT(expected.size(), cloud.size.size()/4);
}

} // namespace

TEST(PairSearch, findsWhatBruteForceFinds)
{
    expectAllPairs(cloud(600, Vec3(1, 1, 1), 0.04, 0.05), PeriodicBox());
    expectAllPairs(cloud(600, Vec3(1, 1, 1), 0.01, 0.1), PeriodicBox());
    expectAllPairs(cloud(600, Vec3(1, 0, 1), 0.005, 0.05), PeriodicBox());
    expectAllPairs(cloud(600, Vec3(0.02, 30, 0.02), 0.01, 0.1), PeriodicBox());
}

TEST(PairSearch, findsPairsAcrossPeriodicBorders)
{
    PeriodicBox box;
    box.length = Vec3(1, 1, 1);
    expectAllPairs(cloud(500, box.length, 0.04, 0.05), box);
    expectAllPairs(cloud(500, box.length, 0.01, 0.1), box);
    box.length = Vec3(1, 0, 0.25);
    expectAllPairs(cloud(400, Vec3(1, 2, 0.25), 0.01, 0.1), box);
    box.lower = Vec3(-0.5, 0, -0.1);
    Cloud shifted = cloud(400, Vec3(1, 2, 0.25), 0.01, 0.1);
    for (Vec3& x : shifted.position) x += Vec3(-0.5, 0, -0.1);
    expectAllPairs(shifted, box);
}

TEST(PairSearch, onePeriodOnly)
{
    // A period of one or two cells: a pair can touch through both borders at once.
    PeriodicBox box;
    box.length = Vec3(1, 1, 1);
    expectAllPairs(cloud(12, box.length, 0.3, 0.45), box);
    expectAllPairs(cloud(30, box.length, 0.2, 0.25), box);
}

TEST(PairSearch, handlesNoAndFewBodies)
{
    EXPECT_TRUE(findPairs({}, {}, PeriodicBox(), 0.0).empty());
    EXPECT_TRUE(findPairs({Vec3(1, 2, 3)}, {0.1}, PeriodicBox(), 0.1).empty());
    EXPECT_EQ(findPairs({Vec3(0, 0, 0), Vec3(1e9, 0, 0), Vec3(0, 0.1, 0)}, {0.1, 0.1, 0.1}, PeriodicBox(), 0.1).size(), 1u);
}

TEST(PairSearch, refusesAPeriodShorterThanAGrain)
{
    PeriodicBox box;
    box.length = Vec3(0.15, 0, 0);
    EXPECT_THROW(findPairs({Vec3::Zero()}, {0.1}, box, 0.1), std::invalid_argument);
}
