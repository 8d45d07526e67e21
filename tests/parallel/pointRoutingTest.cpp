// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Points find the ranks in whose boxes they lie, each once; owners of identities are found.
#include "parallel/idDirectory.hpp"
#include "parallel/pointRouting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

using namespace nscd;

namespace
{

using Box = Eigen::AlignedBox3d;

/// The box of a rank, overlapping its neighbors'; every fifth rank has none.
Box boxOf(int rank)
{
    if (rank % 5 == 4) return Box();
    const double x = 0.1*rank;
    return Box(Vec3(x, 0, 0), Vec3(x + 0.15, 1, 1));
}

/// Points of a rank, the same wherever they are asked for.
std::vector<Vec3> pointsOf(int rank)
{
    std::mt19937 random(rank + 1);
    std::uniform_real_distribution<double> uniform(-0.2, 1.2);
    std::vector<Vec3> points(rank == 1 ? 0 : 50 + 10*rank);
    for (Vec3& x : points) x = Vec3(uniform(random), uniform(random), uniform(random));
    return points;
}

} // namespace

TEST(PointRouting, bringsEachPointToEveryBoxItLiesIn)
{
    const RankTree tree((Communicator()));
    const int rank = tree.all().rank();
    std::set<std::tuple<int, int>> expected;
    for (int origin = 0; origin < tree.all().size(); ++origin)
    {
        const std::vector<Vec3> points = pointsOf(origin);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            if (!boxOf(rank).isEmpty() && boxOf(rank).contains(points[i])) expected.insert({origin, static_cast<int>(i)});
        }
    }
    const std::vector<RoutedPoint> arrived = routePoints(tree, pointsOf(rank), boxOf(rank));
    std::set<std::tuple<int, int>> found;
    for (const RoutedPoint& point : arrived)
    {
        EXPECT_TRUE(found.insert({point.origin, point.index}).second) << "came twice";
        EXPECT_EQ(Vec3(point.position.data()), pointsOf(point.origin)[point.index]);
    }
    EXPECT_EQ(found, expected);
    const auto byOrigin = [](const RoutedPoint& a, const RoutedPoint& b)
    {
        return std::tie(a.origin, a.index) < std::tie(b.origin, b.index);
    };
    EXPECT_TRUE(std::is_sorted(arrived.begin(), arrived.end(), byOrigin));
}

TEST(IdDirectory, knowsEveryOwnerAndWhatHasTwo)
{
    const Communicator all;
    // Rank r owns 100 r .. 100 r + 9.
    std::vector<std::int64_t> own;
    for (int k = 0; k < 10; ++k) own.push_back(100*all.rank() + k);
    const IdDirectory directory(all, own);
    EXPECT_EQ(directory.duplicates(), 0);
    std::vector<std::int64_t> asked;
    std::vector<int> expected;
    for (int r = all.size() - 1; r >= 0; --r)
    {
        asked.insert(asked.end(), {100*r + 3, 100*r + 10, 100*r + 3});
        expected.insert(expected.end(), {r, -1, r});
    }
    EXPECT_EQ(directory.owners(asked), expected);

    own.push_back(7);  // of rank 0
    EXPECT_EQ(IdDirectory(all, own).duplicates(), all.size());
}
