// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Search for walls against a look at each.
#include "nscd/search/wallSearch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace nscd;

namespace
{

std::mt19937 engine(9);

Vec3 randomPoint()
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const double x = unit(engine), y = unit(engine), z = unit(engine);
    return Vec3(x, y, z);
}

void addRubble(Walls& walls, int patch, int triangles)
{
    for (int k = 0; k < triangles; ++k)
    {
        const Vec3 at = randomPoint();
        const double size = k % 10 == 0 ? 1.0 : 0.1;
        const Vec3 b = at + size*randomPoint(), c = at + size*randomPoint();
        walls.addPolygon(patch, {at, b, c});
    }
}

/// Looks regions up at random points, with `added` to the distance of those of patches that move.
void expectAllFound(const Walls& walls, const WallSearch& search, const std::vector<double>& added)
{
    std::size_t number = 0;
    for (int k = 0; k < 250; ++k)
    {
        const Vec3 center = 1.3*randomPoint();
        const double distance = 0.1 + 0.05*randomPoint()[0];
        std::vector<int> found, expected;
        search.find(center, distance, found, added);
        for (int region = 0; region < static_cast<int>(walls.regions.size()); ++region)
        {
            const int patch = walls.regions[region].patch;
            const double within = distance + (walls.patches[patch].motion && !added.empty() ? added[patch] : 0.0);
            if (std::abs(nearestPoint(walls, region, center).distance) < within) expected.push_back(region);
        }
        ASSERT_EQ(found, expected);
        number += found.size();
    }
    EXPECT_GT(number, 20u);
}

} // namespace

TEST(WallSearch, findsWhatBruteForceFinds)
{
    for (int triangles : {12, 300})   // fewer than a grid is made for, and more
    {
        Walls walls;
        walls.addPatch("rubble", 0);
        addRubble(walls, 0, triangles);
        walls.addPlane(0, Vec3(0, 0, -0.2), Vec3::UnitZ());
        expectAllFound(walls, WallSearch(walls, 0.08), {});
    }
}

TEST(WallSearch, findsWallsThatHaveMovedWithoutBeingBuiltAnew)
{
    Walls walls;
    walls.addPatch("still", 0);
    walls.addPatch("moving", 0);
    addRubble(walls, 1, 200);
    addRubble(walls, 0, 100);
    walls.setMotion(1, rotation(Vec3(0.1, 0, 0), Vec3(1, 2, 3), 1.0));
    const WallSearch search(walls, 0.08);
    for (double time : {0.0, 0.7, 2.0})
    {
        moveWalls(walls, time);
        expectAllFound(walls, search, {});
        expectAllFound(walls, search, {0.03, 0.05});
    }
}

TEST(WallSearch, knowsTheExtentOfPatchesAndWhichHavePlanes)
{
    Walls walls;
    walls.addPatch("floor", 0);
    walls.addPatch("sheet", 0);
    walls.addPlane(0, Vec3::Zero(), Vec3::UnitZ());
    walls.addPolygon(1, {Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(0, 3, 1.5)});
    const WallSearch search(walls, 0.1);
    EXPECT_TRUE(search.hasPlane(0));
    EXPECT_FALSE(search.hasPlane(1));
    EXPECT_EQ(search.extent(1).min(), Vec3(0, 0, 1));
    EXPECT_EQ(search.extent(1).max(), Vec3(2, 3, 1.5));
}
