// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Regions: volumes against formulas, a closed surface against the box that it is, discs' planes, open surfaces.
#include "nscd/tools/regions.hpp"

#include "unit/nscd/tools/closedSurfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

using closedSurfaces::boxOfTriangles;
using nscd::Vec3;

namespace
{

/// Four standard deviations of the share that ten thousand points give.
double scatter(double share) { return 4.0*std::sqrt(share*(1.0 - share)/10000.0); }

void expectVolume(const nscd::Region& region, double volume)
{
    const double share = volume/region.bounds.volume();
    EXPECT_NEAR(nscd::shareOfBounds(region), share, scatter(share));
    EXPECT_NEAR(region.volume, volume, 1e-12*volume);
}

} // namespace

TEST(Regions, haveTheVolumesOfTheirFormulas)
{
    expectVolume(nscd::sphereRegion({1, 2, 3}, 0.5), 4.0/3.0*M_PI*0.125);
    expectVolume(nscd::cylinderRegion({1, 2, 3}, {1, 2, 5}, 0.5), M_PI*0.25*2.0);
    expectVolume(nscd::cylinderRegion({1, 2, 3}, {2, 4, 5}, 0.5), M_PI*0.25*3.0);
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
    expectVolume(nscd::surfaceRegion({{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}}), 1.0/6.0);
}

TEST(Regions, holdTheirPointsAndNoOthers)
{
    const nscd::Region cylinder = nscd::cylinderRegion({0, 0, 0}, {3, 0, 4}, 1.0);
    EXPECT_TRUE(cylinder.holds(Vec3(1.5, 0.99, 2)));
    EXPECT_FALSE(cylinder.holds(Vec3(1.5, 1.01, 2)));
    EXPECT_FALSE(cylinder.holds(Vec3(-0.1, 0, -0.1)));
    const nscd::Region surface = nscd::surfaceRegion(boxOfTriangles());
    EXPECT_TRUE(surface.holds(Vec3(0.01, 1.99, 2.99)));
    EXPECT_FALSE(surface.holds(Vec3(-0.01, 1, 1)));
    EXPECT_FALSE(surface.holds(Vec3(0.5, 1, 3.01)));
}

/// Volumes of boxes around cylinders cannot tell bounds that are too narrow.
TEST(Regions, lieWithinTheirBounds)
{
    const nscd::Region cylinder = nscd::cylinderRegion({1, 2, 3}, {2, 4, 5}, 0.5);
    const nscd::RandomNumbers random = nscd::randomNumbers(3);
    for (int k = 0; k < 10000; ++k)
    {
        const Vec3 x = Vec3(4*random(), 6*random(), 8*random());
        EXPECT_TRUE(!cylinder.holds(x) || cylinder.bounds.contains(x)) << x.transpose();
    }
}

TEST(Regions, givePointsInside)
{
    const nscd::Region sphere = nscd::sphereRegion({1, 0, 0}, 2.0);
    const nscd::RandomNumbers random = nscd::randomNumbers(2);
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 10000; ++k)
    {
        const Vec3 x = nscd::randomPoint(sphere, random);
        ASSERT_TRUE(sphere.holds(x));
        sum += x;
    }
    // Each coordinate of a point has the deviation R/sqrt(5).
    EXPECT_LT((sum/10000.0 - Vec3(1, 0, 0)).cwiseAbs().maxCoeff(), 4.0*2.0/std::sqrt(5.0*10000.0));
}

TEST(Regions, ofDiscsLieInTheirPlane)
{
    const nscd::Region disc = nscd::inPlane(nscd::sphereRegion({0, 0, 0.3}, 0.5), 2, 0.0);
    const nscd::RandomNumbers random = nscd::randomNumbers(2);
    for (int k = 0; k < 1000; ++k)
    {
        const Vec3 x = nscd::randomPoint(disc, random);
        ASSERT_EQ(x.z(), 0.0);
        ASSERT_LE(x.norm(), 0.4 + 1e-12);
    }
    EXPECT_EQ(nscd::shareOfBounds(nscd::inPlane(nscd::sphereRegion({0, 0, 2}, 0.5), 2, 0.0)), 0.0);
}

TEST(Regions, refuseOpenSurfaces)
{
    std::vector<nscd::Triangle> triangles = boxOfTriangles();
    std::swap(triangles[3][0], triangles[3][1]);
    EXPECT_THROW(nscd::surfaceRegion(triangles), std::invalid_argument);
    triangles = boxOfTriangles();
    triangles.pop_back();
    EXPECT_THROW(nscd::surfaceRegion(triangles), std::invalid_argument);
}
