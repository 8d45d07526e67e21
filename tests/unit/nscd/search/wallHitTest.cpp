// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The first place at which a moving sphere meets a region, against the distance sampled along the way.
#include "nscd/search/wallHit.hpp"

#include <gtest/gtest.h>

#include <random>

using nscd::Vec3;

namespace
{

/// Of one region.
nscd::WallHit hit(const nscd::Walls& walls, const nscd::Way& way)
{
    nscd::WallHit first;
    for (std::size_t k = 0; k < walls.regions.size(); ++k) nscd::meet(walls.regions[k], static_cast<int>(k), way, first);
    return first;
}

/// The first of many times at which the nearest point comes within the radius; 2: none.
double sampled(const nscd::Walls& walls, const nscd::Way& way)
{
    constexpr int samples = 4000;
    for (int k = 0; k <= samples; ++k)
    {
        for (const nscd::WallRegion& region : walls.regions)
        {
            const double time = static_cast<double>(k)/samples;
            if (nearestPoint(region, way.start + time*way.displacement).distance <= way.radius) return time;
        }
    }
    return 2.0;
}

} // namespace

TEST(WallHit, isWhereTheDistanceFirstIsTheRadius)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&](double size) { return Vec3(size*unit(random), size*unit(random), size*unit(random)); };
    int hits = 0;
    for (int k = 0; k < 300; ++k)
    {
        nscd::Walls walls;
        walls.addTriangles(walls.addPatch("sheet", 0), {{point(1), point(1), point(1)}, {point(1), point(1), point(1)}});
        const nscd::Way way{point(3), Vec3::Zero(), 0.2};
        const nscd::Way onward{way.start, point(1) - way.start + point(1), 0.2};
        const double expected = sampled(walls, onward);
        if (expected == 0.0) continue;
        const nscd::WallHit found = hit(walls, onward);
        ASSERT_EQ(found.isAny(), expected <= 1.0) << k;
        if (!found.isAny()) continue;
        ++hits;
        EXPECT_NEAR(found.time, expected, 1.0/4000 + 1e-12) << k;
        const nscd::WallProximity near = nearestPoint(walls.regions[found.region], onward.start + found.time*onward.displacement);
        EXPECT_NEAR(near.distance, 0.2, 1e-12);
        EXPECT_LT((near.normal - found.normal).norm(), 1e-10);
        EXPECT_LT(found.normal.dot(onward.displacement), 0.0);
    }
    EXPECT_GT(hits, 60);
}

TEST(WallHit, isTheSameInAGrid)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&](double size) { return Vec3(size*unit(random), size*unit(random), size*unit(random)); };
    nscd::Walls walls;
    const int patch = walls.addPatch("chips", 0);
    for (int k = 0; k < 100; ++k)
    {
        const Vec3 middle = point(1);
        walls.addTriangles(patch, {{middle, middle + point(0.3), middle + point(0.3)}});
    }
    const nscd::WallSearch search(walls, 0.15);
    ASSERT_TRUE(search.hasMany(0));
    int hits = 0;
    for (int k = 0; k < 1500; ++k)
    {
        const nscd::Way way{point(3), point(5), 0.05, 0.02};
        const nscd::WallHit expected = hit(walls, way), found = firstHit(walls, search, 0, way, -1);
        EXPECT_EQ(found.region, expected.region) << k;
        EXPECT_EQ(found.time, expected.time) << k;
        hits += found.isAny();
    }
    EXPECT_GT(hits, 60);
}

TEST(WallHit, isNoneWhereTheWayLeadsNoDeeperThanAllowed)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&](double size) { return Vec3(size*unit(random), size*unit(random), size*unit(random)); };
    int without = 0, with = 0;
    for (int k = 0; k < 2000; ++k)
    {
        nscd::Walls walls;
        walls.addTriangles(walls.addPatch("sheet", 0), {{point(1), point(1), point(1)}});
        const nscd::Way way{point(1), point(0.5), 0.4, 0.2};
        const double start = nearestPoint(walls.regions[0], way.start).distance;
        if (start < 0.4) continue;
        const nscd::WallHit strict = hit(walls, {way.start, way.displacement, way.radius}), allowed = hit(walls, way);
        double nearest = start;
        for (int i = 0; i <= 1000; ++i) nearest = std::min(nearest, nearestPoint(walls.regions[0], way.start + i/1000.0*way.displacement).distance);
        with += allowed.isAny();
        if (allowed.isAny()) EXPECT_GE(allowed.time, strict.time);
        else
        {
            without += strict.isAny();
            EXPECT_GE(nearest, 0.2 - 1e-12) << k;
        }
    }
    EXPECT_GT(without, 20);
    EXPECT_GT(with, 20);
}

TEST(WallHit, ofWhatTouchesFromTheStartIsThereIfItComesNearer)
{
    nscd::Walls walls;
    walls.addTriangles(walls.addPatch("sheet", 0), {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
    for (double side : {1.0, -1.0})
    {
        const Vec3 start(0.2, 0.2, 0.05*side);
        EXPECT_EQ(hit(walls, {start, Vec3(0.3, 0, -side), 0.1}).time, 0.0);
        EXPECT_EQ(hit(walls, {start, Vec3(0.3, 0, -side), 0.1}).normal, Vec3(0, 0, side));
        EXPECT_FALSE(hit(walls, {start, Vec3(0.3, 0, side), 0.1}).isAny());
        EXPECT_FALSE(hit(walls, {start, Vec3(3, 0, 0), 0.1}).isAny());
    }
}

TEST(WallHit, ofAWallOfOneSideIsNoneFromItsBack)
{
    nscd::Walls walls;
    walls.addPolygon(walls.addPatch("floor", 0), {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});
    EXPECT_NEAR(hit(walls, {Vec3(0.5, 0.5, 1), Vec3(0, 0, -2), 0.1}).time, 0.45, 1e-14);
    EXPECT_FALSE(hit(walls, {Vec3(0.5, 0.5, -1), Vec3(0, 0, 2), 0.1}).isAny());
}
