// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grids of bodies: every body in its cell, cells wide enough.
#include "nscd/search/cellGrid.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

using namespace nscd;

namespace
{

struct Bodies
{
    std::vector<Vec3> position;
    std::vector<double> size;

    Bodies(int number, const Vec3& lower, const Vec3& extent)
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int i = 0; i < number; ++i)
        {
            position.push_back(lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(extent));
            size.push_back(0.01*(1 + unit(random)));
        }
    }

    CellGrid filled(const PeriodicBox& box) const
    {
        CellGrid grid;
        grid.bodies.resize(position.size());
        std::iota(grid.bodies.begin(), grid.bodies.end(), 0);
        grid.fill(position, size, box);
        return grid;
    }
};

void expectSorted(const Bodies& bodies, const CellGrid& grid)
{
    std::set<int> found;
    for (int z = 0; z < grid.count[2]; ++z)
    for (int y = 0; y < grid.count[1]; ++y)
    for (int x = 0; x < grid.count[0]; ++x)
    {
        const int cell = grid.row(y, z) + x;
        for (int m = grid.cellStart[cell]; m < grid.cellStart[cell + 1]; ++m)
        {
            const int i = grid.body[m];
            EXPECT_TRUE(found.insert(i).second) << i;
            const Vec3 inCells = (bodies.position[i] - grid.lower).cwiseQuotient(grid.cellSize) - Vec3(x, y, z);
            EXPECT_GE(inCells.minCoeff(), -1e-12);
            EXPECT_LE(inCells.maxCoeff(), 1 + 1e-12);
            EXPECT_EQ(grid.placeOf[i], m);
            EXPECT_EQ(Vec3(grid.x[0][m], grid.x[1][m], grid.x[2][m]), bodies.position[i]);
            EXPECT_EQ(grid.size[m], bodies.size[i]);
        }
    }
    EXPECT_EQ(found.size(), bodies.position.size());
}

} // namespace

TEST(CellGrid, hasEveryBodyOnceInTheCellItIsIn)
{
    const Bodies bodies(2000, Vec3(-1, 2, 0), Vec3(1, 0.3, 0.5));
    const CellGrid grid = bodies.filled(PeriodicBox());
    expectSorted(bodies, grid);
    EXPECT_GT(grid.count[0], 10);
    EXPECT_GE(grid.cellSize.minCoeff(), 2*grid.maxSize);
    EXPECT_EQ(grid.maxSize, *std::max_element(bodies.size.begin(), bodies.size.end()));
}

TEST(CellGrid, cellsOfPeriodicAxesFillThePeriod)
{
    PeriodicBox box;
    box.lower = Vec3(0, -0.5, 0);
    box.length = Vec3(0, 1.0, 0);
    const Bodies bodies(2000, Vec3(0, -0.5, 0), Vec3(0.5, 1, 0.5));
    const CellGrid grid = bodies.filled(box);
    expectSorted(bodies, grid);
    EXPECT_EQ(grid.lower[1], -0.5);
    EXPECT_NEAR(grid.count[1]*grid.cellSize[1], 1.0, 1e-14);
}

TEST(CellGrid, hasNotManyMoreCellsThanBodies)
{
    const CellGrid grid = Bodies(20, Vec3::Zero(), Vec3(1e5, 1e5, 1e5)).filled(PeriodicBox());
    EXPECT_LE(static_cast<double>(grid.count[0])*grid.count[1]*grid.count[2], 4.0*20 + 64);
}

TEST(CellGrid, whatLiesBeyondBelongsToTheLastCell)
{
    const CellGrid grid = Bodies(500, Vec3::Zero(), Vec3::Ones()).filled(PeriodicBox());
    EXPECT_EQ(grid.cellOf(-9, -9, -9), (CellGrid::Cell{0, 0, 0}));
    EXPECT_EQ(grid.cellOf(9, 9, 9), (CellGrid::Cell{grid.count[0] - 1, grid.count[1] - 1, grid.count[2] - 1}));
}
