// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// What a face takes from a ball, against its definition by the contributions of the closures.

#include "closures/sphereOverlap.hpp"
#include "coupling/mapping/overlap/ballFaceExcess.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace Foam::nscdCoupling;

// Signed solid angle of a triangle seen from the origin (van Oosterom & Strackee 1983).
double solidAngle(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    const double ra = a.norm(), rb = b.norm(), rc = c.norm();
    return 2*std::atan2(a.dot(b.cross(c)), ra*rb*rc + a.dot(b)*rc + a.dot(c)*rb + b.dot(c)*ra);
}

double solidAngle(const Vector3d& center, const std::vector<Vector3d>& v)
{
    double sum = 0;
    for (std::size_t k = 2; k < v.size(); ++k) sum += solidAngle(v[0] - center, v[k - 1] - center, v[k] - center);
    return sum;
}

// Regular polygon of n corners of unit circumference radius, turned in space.
std::vector<Vector3d> polygon(const int n, const Eigen::Quaterniond& turn)
{
    std::vector<Vector3d> corners;
    for (int k = 0; k < n; ++k)
    {
        corners.push_back(turn*Vector3d(std::cos(2*M_PI*k/n), std::sin(2*M_PI*k/n), 0));
    }
    return corners;
}

TEST(mappingExcess, isTheContributionLessThePartOfTheSolidAngle)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(-1, 1);
    for (int trial = 0; trial < 20000; ++trial)
    {
        const int n = 3 + trial % 5;
        const Eigen::Quaterniond turn = Eigen::Quaterniond(random(generator), random(generator), random(generator), 1).normalized();
        const std::vector<Vector3d> corners = polygon(n, turn);
        const Vector3d normal = turn*Vector3d::UnitZ();
        const Vector3d center = 1.5*Vector3d(random(generator), random(generator), random(generator));
        const double radius = std::abs(random(generator))*1.5 + 0.01;
        const double ball = 4.0/3*M_PI*std::pow(radius, 3);
        const double expected = closures::ballFaceContribution(center, radius, corners.data(), n, normal)
            - std::pow(radius, 3)/3*solidAngle(center, corners);
        EXPECT_NEAR(ballFaceExcess(center, radius, corners.data(), n, normal)/ball, expected/ball, 3e-14) << "trial " << trial;
    }
}

TEST(mappingExcess, withTheFootOnCornersAndEdges)
{
    const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const double height : {0.01, 0.1, 0.7, -0.4})
    {
        for (const double radius : {0.3, 0.9, 1.2, 4.0})
        {
            for (const Vector2d& foot : {Vector2d(0, 0), Vector2d(1, 1), Vector2d(0.5, 0), Vector2d(1, 0.25), Vector2d(2, 0)})
            {
                const Vector3d center(foot[0], foot[1], -height);
                const double expected = closures::ballFaceContribution(center, radius, corners.data(), 4, Vector3d::UnitZ())
                    - std::pow(radius, 3)/3*solidAngle(center, corners);
                const double ball = 4.0/3*M_PI*std::pow(radius, 3);
                EXPECT_NEAR(ballFaceExcess(center, radius, corners.data(), 4, Vector3d::UnitZ())/ball, expected/ball, 3e-14)
                    << "foot " << foot.transpose() << " height " << height << " radius " << radius;
            }
        }
    }
}

TEST(mappingExcess, ofADiscAndAnEdge)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(-1, 1);
    for (int trial = 0; trial < 20000; ++trial)
    {
        const Vector2d a(random(generator), random(generator));
        const Vector2d b(random(generator), random(generator));
        const Vector2d center(random(generator), random(generator));
        const double radius = std::abs(random(generator)) + 0.01;
        const Vector2d p = a - center;
        const Vector2d q = b - center;
        const double expected = closures::discEdgeContribution(center, radius, a, b)
            - radius*radius/2*std::atan2(p[0]*q[1] - p[1]*q[0], p.dot(q));
        EXPECT_NEAR(discEdgeExcess(center, radius, a, b)/(M_PI*radius*radius), expected/(M_PI*radius*radius), 3e-14);
    }
}

} // End anonymous namespace
