// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Test of the search for overlaps against brute force.
#include "nscd/search/overlaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using nscd::Vec3;

TEST(Overlaps, agreeWithTheSumOverAllPairs)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    nscd::Grains grains;
    for (int i = 0; i < 2000; ++i)
    {
        const double radius = 0.005*std::pow(10, uniform(random));
        grains.add(Vec3(uniform(random), uniform(random), 2*uniform(random)), radius, 1, 0, i);
    }
    nscd::PeriodicBox box;
    box.length = Vec3(1, 0, 2);
    nscd::Walls walls;
    const int patch = walls.addPatch("square", 0);
    walls.addPolygon(patch, {Vec3(0.2, 0.2, 1), Vec3(0.8, 0.2, 1), Vec3(0.8, 0.9, 1.2), Vec3(0.2, 0.9, 1.2)});

    std::size_t pairs = 0, atWall = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        for (std::size_t j = i + 1; j < grains.size(); ++j)
        {
            const double distance = box.nearestImage(grains.position[i] - grains.position[j]).norm();
            const double share = (grains.radius[i] + grains.radius[j] - distance)/(2*std::min(grains.radius[i], grains.radius[j]));
            pairs += share > 0.02;
        }
        const double distance = nscd::nearestPoint(walls.regions[0], grains.position[i]).distance;
        atWall += distance >= 0 && (grains.radius[i] - distance)/(2*grains.radius[i]) > 0.02;
    }
    ASSERT_GT(pairs, 20u);
    ASSERT_GT(atWall, 5u);
    EXPECT_EQ(grainOverlaps(grains, box, 0.02).size(), pairs);
    EXPECT_EQ(wallOverlaps(grains, walls, 0.02).size(), atWall);
}

/// Cells as wide as grains would be more than memory holds.
TEST(Overlaps, areFoundWhereOneGrainIsFarAway)
{
    nscd::Grains grains;
    for (const double x : {0.0, 0.01, 1e12}) grains.add(Vec3(x, 0, 0), 0.01, 1, 0, std::int64_t(grains.size()));
    nscd::Walls walls;
    walls.addPolygon(walls.addPatch("square", 0), {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)});
    EXPECT_EQ(grainOverlaps(grains, nscd::PeriodicBox(), 0.01).size(), 1u);
    EXPECT_EQ(wallOverlaps(grains, walls, 0.01).size(), 2u);
}

/// 10 000 grains in the space of one have 5e7 pairs: neither memory nor time for all of them.
TEST(Overlaps, areNotAllListedWhereThereAreTooMany)
{
    nscd::Grains grains;
    for (int i = 0; i < 10000; ++i) grains.add(Vec3(1e-6*i, 0, 0), 1, 1, 0, i);
    const std::size_t number = grainOverlaps(grains, nscd::PeriodicBox(), 0.01).size();
    EXPECT_GE(number, nscd::mostOverlaps);
    EXPECT_LT(number, nscd::mostOverlaps + 20000);
}
