// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Volume, surface, sphericity and shadows of clumps against closed forms and against points on spheres.
#include "nscd/scene/clumpForm.hpp"

#include "nscd/scene/grains.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace nscd;

namespace
{

const double pi = std::acos(-1.0);

/// Two balls of radius R at a distance 2 c along an axis.
std::vector<Ball> pair(double c, double r, const Vec3& axis) { return {{c*axis.normalized(), r}, {-c*axis.normalized(), r}}; }

/// Each ball's share of points on it that are in no other ball.
double surfaceByPoints(const std::vector<Ball>& balls, int points)
{
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    double sum = 0;
    for (const Ball& ball : balls)
    {
        int open = 0;
        for (int k = 0; k < points; ++k)
        {
            const Vec3 x = ball.center + ball.radius*Vec3(normal(random), normal(random), normal(random)).normalized();
            bool isHidden = false;
            for (const Ball& other : balls) isHidden = isHidden || (&other != &ball && (x - other.center).norm() < other.radius);
            open += !isHidden;
        }
        sum += 4*pi*ball.radius*ball.radius*open/points;
    }
    return sum;
}

} // namespace

TEST(ClumpForm, surfaceOfTwoBallsIsThatOutsideTheLens)
{
    const double r = 0.7;
    for (double c : {0.05, 0.3, 0.69, 0.7, 1.2})
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.3, -0.8, 0.5), Vec3(1e-9, 0, 1)})
    {
        const double height = std::max(0.0, r - c), expected = 8*pi*r*r - 4*pi*r*height;
        EXPECT_NEAR(surfaceOfBalls(pair(c, r, axis)), expected, 1e-9*expected) << c << " along " << axis.transpose();
    }
}

TEST(ClumpForm, whatIsInsideOrTwiceThereAddsNothing)
{
    const double r = 0.4, own = 4*pi*r*r;
    EXPECT_NEAR(surfaceOfBalls({{Vec3(1, 2, 3), r}}), own, 1e-12*own);
    EXPECT_NEAR(surfaceOfBalls({{Vec3(1, 2, 3), r}, {Vec3(1, 2.1, 3), 0.2}}), own, 1e-12*own);
    EXPECT_NEAR(surfaceOfBalls({{Vec3(1, 2, 3), r}, {Vec3(1, 2, 3), r}}), own, 1e-12*own);
}

TEST(ClumpForm, surfaceOfManyBallsAgreesWithPointsOnThem)
{
    const std::vector<Ball> balls = {{Vec3(0, 0, 0), 1.0}, {Vec3(1.2, 0.1, 0), 0.8}, {Vec3(0.3, 0.8, 0.2), 0.7}, {Vec3(0.5, 0.4, 0.9), 0.6}};
    const double found = surfaceOfBalls(balls);
    EXPECT_NEAR(found, surfaceByPoints(balls, 400000), 2e-3*found);
    // However it is turned.
    const Quaternion turn = Quaternion(0.3, 0.5, -0.2, 0.7).normalized();
    std::vector<Ball> turned;
    for (const Ball& ball : balls) turned.push_back({turn*ball.center, ball.radius});
    EXPECT_NEAR(surfaceOfBalls(turned), found, 1e-8*found);
}

TEST(ClumpForm, sphericityOfASphereAndOfTwo)
{
    GrainShape shape;
    const ClumpForm one = formOf(makeClumpShape({{Vec3(5, 0, 0), 0.3}}, 2500, shape), shape);
    EXPECT_NEAR(one.sphericity(), 1, 1e-14);
    EXPECT_LE(one.sphericity(), 1);
    EXPECT_NEAR(one.equivalentDiameter(), 0.6, 1e-14);
    // Two that touch: d^3 = 2 D^3, d^2/(2 D^2) = 2^(-1/3).
    const ClumpForm two = formOf(makeClumpShape(pair(0.3, 0.3, Vec3::UnitY()), 2500, shape), shape);
    EXPECT_NEAR(two.volume, 2*one.volume, 1e-14);
    EXPECT_NEAR(two.sphericity(), std::pow(2.0, -1.0/3), 1e-9);
}

TEST(ClumpForm, shadowsOfTwoBalls)
{
    const double r = 0.7;
    for (double c : {0.2, 0.5, 0.9})
    for (double angle : {0.0, 0.4, 1.1, 0.5*pi})
    {
        const Quaternion turn(Eigen::AngleAxisd(angle, Vec3::UnitY()));
        // Discs of radius R whose centers are 2 c sin(angle) apart.
        const double half = c*std::sin(angle);
        const double lens = half < r ? 2*r*r*std::acos(half/r) - 2*half*std::sqrt(r*r - half*half) : 0;
        EXPECT_NEAR(projectedArea(pair(c, r, Vec3::UnitZ()), turn*Vec3::UnitZ()), 2*pi*r*r - lens, 1e-12) << c << ", " << angle;
        EXPECT_NEAR(projectedArea(pair(c, r, Vec3::UnitZ()), -3.0*(turn*Vec3::UnitZ())), 2*pi*r*r - lens, 1e-12) << c << ", " << angle;
    }
}
