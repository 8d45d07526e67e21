// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Order along the curve against keys whose bits are interleaved one by one.
#include "nscd/base/mortonOrder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace nscd;

namespace
{

long key(const Vec3& x)
{
    long bits = 0;
    for (int bit = 0; bit < 10; ++bit)
    {
        for (int axis = 0; axis < 3; ++axis) bits |= ((static_cast<long>(x[axis]) >> bit) & 1) << (3*bit + axis);
    }
    return bits;
}

/// Points of a lattice in random order, some of them twice.
std::vector<Vec3> shuffledLattice(int perSide, double spacing)
{
    std::vector<Vec3> points;
    for (int n = 0; n < perSide*perSide*perSide; ++n)
    {
        const Vec3 x(n % perSide, n/perSide % perSide, n/(perSide*perSide));
        points.insert(points.end(), n % 7 == 0 ? 2 : 1, spacing*x);
    }
    std::shuffle(points.begin(), points.end(), std::mt19937(4));
    return points;
}

} // namespace

TEST(MortonOrder, isThatOfInterleavedBitsAndKeepsTheOrderOfTies)
{
    const double spacing = 0.25;
    const std::vector<Vec3> points = shuffledLattice(13, spacing);
    std::vector<int> expected(points.size());
    std::iota(expected.begin(), expected.end(), 0);
    const auto keyOf = [&](int i) { return key(points[i]/spacing); };
    std::stable_sort(expected.begin(), expected.end(), [&](int i, int j) { return keyOf(i) < keyOf(j); });
    EXPECT_EQ(mortonOrder(points, spacing), expected);

    std::vector<Vec3> elsewhere = points;
    for (Vec3& x : elsewhere) x -= Vec3(8, 16, 32);
    EXPECT_EQ(mortonOrder(elsewhere, spacing), expected);
}

TEST(MortonOrder, holdsSmallCellsInLargeScenes)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 100; ++k) points.push_back(Vec3(1e6*(99 - k), 0, 0));
    std::vector<int> expected(100);
    std::iota(expected.rbegin(), expected.rend(), 0);
    EXPECT_EQ(mortonOrder(points, 1e-6), expected);
}

TEST(MortonOrder, takesNoneAndOne)
{
    EXPECT_TRUE(mortonOrder({}, 1.0).empty());
    EXPECT_EQ(mortonOrder({Vec3(1, 2, 3)}, 1.0), std::vector<int>{0});
}
