// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moments of unions against closed forms and against a grid.
#include "nscd/scene/unionMoments.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace nscd;

namespace
{

const double pi = std::acos(-1.0);

/// Brute force: the middles of cells of width h within a cube of half width `reach`.
VolumeMoments onGrid(const std::vector<Ball>& balls, double reach, double h)
{
    VolumeMoments sum;
    for (double x = -reach + 0.5*h; x < reach; x += h)
    for (double y = -reach + 0.5*h; y < reach; y += h)
    for (double z = -reach + 0.5*h; z < reach; z += h)
    {
        const Vec3 p(x, y, z);
        bool isInside = false;
        for (const Ball& ball : balls) isInside = isInside || (p - ball.center).squaredNorm() < ball.radius*ball.radius;
        if (!isInside) continue;
        sum.volume += h*h*h;
        sum.first += h*h*h*p;
        sum.second += h*h*h*p*p.transpose();
    }
    return sum;
}

} // namespace

TEST(UnionMoments, ofOneBallAreItsClosedForm)
{
    const double r = 0.7, volume = 4.0/3.0*pi*r*r*r;
    const Vec3 c(0.2, -0.5, 1.1);
    const VolumeMoments ball = unionOfBalls({{c, r}});
    EXPECT_NEAR(ball.volume, volume, 1e-12*volume);
    EXPECT_LT((ball.first - volume*c).norm(), 1e-12*volume);
    EXPECT_LT((ball.second - volume*(0.2*r*r*Eigen::Matrix3d::Identity() + c*c.transpose())).norm(), 1e-11*volume);
}

/// Spherical caps: two unit balls at a distance 2 c have 2 (4 pi/3) - 2 pi h^2 (3 - h)/3 with h = 1 - c.
TEST(UnionMoments, ofTwoBallsCountTheLensOnce)
{
    for (double c : {0.05, 0.3, 0.8, 1.2})
    {
        const double h = std::max(0.0, 1 - c), expected = 8*pi/3 - 2*pi*h*h*(3 - h)/3;
        EXPECT_NEAR(unionOfBalls({{Vec3(c, 0, 0), 1.0}, {Vec3(-c, 0, 0), 1.0}}).volume, expected, 1e-11*expected) << c;
        EXPECT_NEAR(unionOfBalls({{Vec3(0, 0, c), 1.0}, {Vec3(0, 0, -c), 1.0}}).volume, expected, 1e-11*expected) << c;
    }
}

TEST(UnionMoments, ofThreeBallsAgreeWithAGrid)
{
    const std::vector<Ball> balls = {{Vec3(0.1, 0, -0.2), 0.6}, {Vec3(-0.4, 0.3, 0.1), 0.5}, {Vec3(0.2, 0.5, 0.3), 0.4}};
    const VolumeMoments exact = unionOfBalls(balls), grid = onGrid(balls, 1.0, 0.025);
    EXPECT_NEAR(exact.volume, grid.volume, 2e-3*grid.volume);
    EXPECT_LT((exact.first - grid.first).norm(), 2e-3*grid.volume);
    EXPECT_LT((exact.second - grid.second).norm(), 2e-3*grid.second.norm());
}

TEST(UnionMoments, aBallInsideAnotherOrTwiceAddsNothing)
{
    const Ball large{Vec3(0.1, 0.2, 0.3), 1.0}, small{Vec3(0.3, 0.1, 0.2), 0.5};
    const VolumeMoments one = unionOfBalls({large});
    for (const std::vector<Ball>& balls : {std::vector<Ball>{large, small}, {small, large}, {large, large}})
    {
        EXPECT_NEAR(unionOfBalls(balls).volume, one.volume, 1e-12*one.volume);
        EXPECT_LT((unionOfBalls(balls).second - one.second).norm(), 1e-11*one.volume);
    }
}

TEST(UnionMoments, ofDiscsAreClosedForms)
{
    const double r = 0.5;
    const VolumeMoments disc = unionOfDiscs({{Vec3(1, 2, 7), r}});
    EXPECT_NEAR(disc.volume, pi*r*r, 1e-14);
    EXPECT_LT((disc.first - pi*r*r*Vec3(1, 2, 0)).norm(), 1e-13);
    EXPECT_NEAR(disc.second(0, 0), pi*r*r*(0.25*r*r + 1), 1e-13);
    EXPECT_NEAR(disc.second(0, 1), pi*r*r*2, 1e-13);
    EXPECT_NEAR(disc.second(1, 1), pi*r*r*(0.25*r*r + 4), 1e-13);
    const double c = 0.4, lens = 2*std::acos(c) - 2*c*std::sqrt(1 - c*c);
    EXPECT_NEAR(unionOfDiscs({{Vec3(c, 0, 0), 1.0}, {Vec3(-c, 0, 0), 1.0}}).volume, 2*pi - lens, 1e-13);
}
