// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Disc and polygon: known areas, brute force, shares of a filled plane.
#include "overlapShapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using overlapShapes::pi;
using overlapShapes::RandomPoints;
using Eigen::Vector2d;

double overlap(const std::vector<Vector2d>& polygon, const Vector2d& center, double radius)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        sum += closures::discEdgeContribution(center, radius, polygon[i], polygon[(i + 1)%polygon.size()]);
    }
    return sum;
}

} // namespace

TEST(DiscOverlap, circularSegmentQuarterAndWhole)
{
    const std::vector<Vector2d> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_NEAR(overlap(square, {0, 0}, 0.4), pi*0.16/4, 1e-15);
    EXPECT_NEAR(overlap(square, {0.5, 0.5}, 0.4), pi*0.16, 1e-15);
    EXPECT_NEAR(overlap(square, {0.5, 0.5}, 4.0), 1.0, 1e-14);
    EXPECT_NEAR(overlap(square, {-3, 0.5}, 0.4), 0.0, 1e-15);
    const double angle = 2*std::acos(0.5);
    EXPECT_NEAR(overlap(square, {0.5, -0.2}, 0.4), 0.08*(angle - std::sin(angle)), 1e-15);
}

TEST(DiscOverlap, agreesWithCountedLinesOnStars)
{
    RandomPoints random(7);
    for (int trial = 0; trial < 30; ++trial)
    {
        std::vector<Vector2d> polygon;
        for (int i = 0; i < 7; ++i)
        {
            const double r = random.number(0.2, 1.0), angle = 2*pi*i/7;
            polygon.emplace_back(r*std::cos(angle), r*std::sin(angle));
        }
        const Vector2d center(random.number(-0.6, 0.6), random.number(-0.6, 0.6));
        const double radius = random.number(0.1, 0.9);
        const int n = 20000;
        double area = 0;
        for (int k = 0; k < n; ++k)
        {
            const double x = center.x() - radius + 2*radius*(k + 0.5)/n;
            const double half = std::sqrt(radius*radius - (x - center.x())*(x - center.x()));
            for (std::size_t i = 0; i < polygon.size(); ++i)
            {
                const Vector2d a = polygon[i], b = polygon[(i + 1)%polygon.size()];
                if ((a.x() <= x) == (b.x() <= x)) continue;
                const double y = a.y() + (b.y() - a.y())*(x - a.x())/(b.x() - a.x());
                const double height = std::min(std::max(y - center.y(), -half), half) + half;
                area += (b.x() < a.x() ? 1 : -1)*height*2*radius/n;
            }
        }
        EXPECT_NEAR(overlap(polygon, center, radius), area, 2e-5*pi*radius*radius) << trial;
    }
}

TEST(DiscOverlap, sharesInAWarpedGridFillTheDisc)
{
    RandomPoints random(8);
    const int n = 4;
    std::array<std::array<Vector2d, n + 1>, n + 1> nodes;
    for (int i = 0; i <= n; ++i) for (int j = 0; j <= n; ++j)
    {
        nodes[i][j] = Vector2d(i + random.number(-0.25, 0.25), j + random.number(-0.25, 0.25));
    }
    for (int trial = 0; trial < 100; ++trial)
    {
        const Vector2d center = trial == 0 ? nodes[2][2] : Vector2d(random.number(1.6, 2.4), random.number(1.6, 2.4));
        const double radius = random.number(0.05, 1.2);
        double sum = 0;
        for (int i = 0; i < n; ++i) for (int j = 0; j < n; ++j)
        {
            sum += overlap({nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1]}, center, radius);
        }
        EXPECT_NEAR(sum, pi*radius*radius, 1e-13*pi*radius*radius) << trial;
    }
}
