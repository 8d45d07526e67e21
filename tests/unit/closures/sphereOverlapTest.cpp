// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ball and polyhedron: known volumes, brute force, shares of a filled space, continuity.
#include "overlapShapes.hpp"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>

namespace
{

using namespace overlapShapes;
using Eigen::Vector2d;

/// Length of the line (x, y, any z) inside both the ball and the polyhedron, by sorted crossings with its triangles.
double lineOverlap(const Polyhedron& cell, const Vector3d& center, double radius, double x, double y)
{
    const double half2 = radius*radius - (x - center.x())*(x - center.x()) - (y - center.y())*(y - center.y());
    if (half2 <= 0) return 0;
    const double low = center.z() - std::sqrt(half2), high = center.z() + std::sqrt(half2);
    double sum = 0;
    for (const Face& f : cell)
    {
        for (std::size_t k = 1; k + 1 < f.size(); ++k)
        {
            const Vector3d n = (f[k] - f[0]).cross(f[k + 1] - f[0]);
            const auto side = [&](const Vector3d& p, const Vector3d& q)
            {
                return (q.x() - p.x())*(y - p.y()) - (q.y() - p.y())*(x - p.x());
            };
            const double a = side(f[0], f[k]), b = side(f[k], f[k + 1]), c = side(f[k + 1], f[0]);
            if (!((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0))) continue;
            const double z = f[0].z() - (n.x()*(x - f[0].x()) + n.y()*(y - f[0].y()))/n.z();
            sum += (n.z() > 0 ? 1 : -1)*(std::min(std::max(z, low), high) - low);
        }
    }
    return sum;
}

/// Midpoint rule over n x n lines through the ball.
double bruteForce(const Polyhedron& cell, const Vector3d& center, double radius, int n)
{
    const double h = 2*radius/n;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            sum += lineOverlap(cell, center, radius, center.x() - radius + (i + 0.5)*h, center.y() - radius + (j + 0.5)*h);
        }
    }
    return sum*h*h;
}

/// Share of a sphere of radius 0.4 in the unit cell with a corner at the origin (validation case C25; digits beyond its
/// seven by quadrature of circle-quadrant areas over z with 25 digits).
double cornerShare(const Vector3d& center)
{
    return overlap(box(Vector3d::Zero(), Vector3d::Ones()), center, 0.4)/ballVolume(0.4);
}

} // namespace

TEST(SphereOverlap, sharesOfCaseC25)
{
    figures::expectNear("C25 center at the corner", "share in the cell", cornerShare({0, 0, 0}), 0.125, 1e-14);
    figures::expectNear("C25 one face cuts", "share in the cell", cornerShare({0.5, 0.5, 0.2}), 0.84375, 1e-14);
    figures::expectNear("C25 corner inside", "share in the cell", cornerShare({0.1, 0.2, 0.15}), 0.4265588930608432, 1e-14);
    figures::expectNear("C25 center outside", "share in the cell", cornerShare({-0.1, -0.1, -0.1}), 0.0273901808479746, 1e-14);
    figures::expectNear("C25 one edge cuts", "share in the cell", cornerShare({0.1, 0.2, 0.5}), 0.5701074723799777, 1e-14);
}

TEST(SphereOverlap, capAndWholeBallAndNothing)
{
    const Polyhedron half = box({-5, -5, 0}, {5, 5, 5});
    for (double z : {-0.999, -0.5, -1e-9, 0.0, 1e-9, 0.3, 0.999})
    {
        const double depth = 1 + z;
        EXPECT_NEAR(overlap(half, {0.2, -0.1, z}, 1.0), pi*depth*depth*(3 - depth)/3, 1e-13) << z;
    }
    EXPECT_NEAR(overlap(half, {0, 0, 2}, 1.0), ballVolume(1.0), 1e-13);
    EXPECT_NEAR(overlap(half, {0, 0, -2}, 1.0), 0.0, 1e-13);
    EXPECT_NEAR(overlap(half, {0, 0, -1}, 1.0), 0.0, 1e-13);
    EXPECT_NEAR(overlap(half, {0, 0, 2}, 100.0), 500.0, 500e-13);
}

TEST(SphereOverlap, lengthsScale)
{
    const Polyhedron cell = tetrahedron({0, 0, 0}, {1, 0.1, 0}, {0.2, 1, 0}, {0.1, 0.3, 0.9});
    const double expected = overlap(cell, {0.3, 0.2, 0.1}, 0.35);
    for (double scale : {1e-6, 1e4})
    {
        Polyhedron scaled = cell;
        for (Face& face : scaled) for (Vector3d& p : face) p *= scale;
        const double got = overlap(scaled, scale*Vector3d(0.3, 0.2, 0.1), scale*0.35);
        EXPECT_NEAR(got/std::pow(scale, 3), expected, 1e-14);
    }
}

TEST(SphereOverlap, agreesWithBruteForceOnTetrahedra)
{
    RandomPoints random(1);
    for (int trial = 0; trial < 40; ++trial)
    {
        const Vector3d a = random.point(-1, 1), b = random.point(-1, 1), c = random.point(-1, 1), d = random.point(-1, 1);
        const Polyhedron cell = tetrahedron(a, b, c, d);
        const Vector3d center = random.point(-0.8, 0.8);
        const double radius = random.number(0.2, 1.0);
        const double got = overlap(cell, center, radius);
        EXPECT_NEAR(got, bruteForce(cell, center, radius, 400), 1e-4*ballVolume(radius)) << trial;
        EXPECT_GE(got, -1e-14*ballVolume(radius));
    }
}

TEST(SphereOverlap, agreesWithBruteForceOnWarpedHexahedraAndNonConvexCells)
{
    RandomPoints random(2);
    for (int trial = 0; trial < 40; ++trial)
    {
        std::array<Vector3d, 8> p;
        for (int c = 0; c < 8; ++c) p[c] = Vector3d(c & 1, (c >> 1) & 1, (c >> 2) & 1) + random.point(-0.3, 0.3);
        const Polyhedron cell = hexOfTriangles(p, [](const int*) { return 0; });
        const Vector3d center = random.point(-0.2, 1.2);
        const double radius = random.number(0.1, 0.8);
        EXPECT_NEAR(overlap(cell, center, radius), bruteForce(cell, center, radius, 400), 1e-4*ballVolume(radius)) << trial;
    }
}

TEST(SphereOverlap, nonConvexFaceIsTheDifferenceOfItsParts)
{
    // An L-shaped prism against the two boxes it is made of.
    const std::vector<Vector2d> L = {{0, 0}, {1, 0}, {1, 0.4}, {0.3, 0.4}, {0.3, 1}, {0, 1}};
    Polyhedron prism(2);
    for (std::size_t i = 0; i < L.size(); ++i)
    {
        const Vector2d a = L[i], b = L[(i + 1)%L.size()];
        prism[0].emplace_back(a.x(), a.y(), 1);
        prism[1].insert(prism[1].begin(), Vector3d(a.x(), a.y(), 0));
        prism.push_back({{a.x(), a.y(), 0}, {b.x(), b.y(), 0}, {b.x(), b.y(), 1}, {a.x(), a.y(), 1}});
    }
    RandomPoints random(3);
    for (int trial = 0; trial < 200; ++trial)
    {
        const Vector3d center = random.point(-0.2, 1.2);
        const double radius = random.number(0.05, 0.9);
        const double parts =
            overlap(box({0, 0, 0}, {1, 0.4, 1}), center, radius) + overlap(box({0, 0.4, 0}, {0.3, 1, 1}), center, radius);
        EXPECT_NEAR(overlap(prism, center, radius), parts, 1e-14*ballVolume(radius)) << trial;
    }
}

TEST(SphereOverlap, sharesInAWarpedGridFillTheBall)
{
    RandomPoints random(4);
    const int n = 4;
    std::array<std::array<std::array<Vector3d, n + 1>, n + 1>, n + 1> nodes;
    for (int i = 0; i <= n; ++i) for (int j = 0; j <= n; ++j) for (int k = 0; k <= n; ++k)
    {
        nodes[i][j][k] = Vector3d(i, j, k) + random.point(-0.25, 0.25);
    }
    // The diagonal of a face starts at its least corner in space, which both neighbors see alike.
    const auto cutAt = [](const int* corners) { return int(std::min_element(corners, corners + 4) - corners); };
    for (int trial = 0; trial < 50; ++trial)
    {
        const Vector3d center = trial == 0 ? nodes[2][2][2] : random.point(1.6, 2.4);
        const double radius = random.number(0.05, 1.2);
        double sum = 0;
        for (int cell = 0; cell < n*n*n; ++cell)
        {
            std::array<Vector3d, 8> p;
            for (int c = 0; c < 8; ++c)
            {
                p[c] = nodes[cell%n + (c & 1)][cell/n%n + ((c >> 1) & 1)][cell/n/n + ((c >> 2) & 1)];
            }
            const double share = overlap(hexOfTriangles(p, cutAt), center, radius);
            EXPECT_GE(share, -1e-14*ballVolume(radius));
            sum += share;
        }
        EXPECT_NEAR(sum, ballVolume(radius), 1e-13*ballVolume(radius)) << trial;
    }
}

TEST(SphereOverlap, aFaceTakenBySidesGivesOppositeNumbers)
{
    const Face face = {{0, 0, 0.1}, {1, 0.1, 0.1}, {0.8, 1, 0.1}, {-0.1, 0.7, 0.1}};
    const Face reversed(face.rbegin(), face.rend());
    const Vector3d center(0.2, 0.3, -0.1);
    for (double radius : {0.05, 0.3, 0.7, 3.0})
    {
        const double forth = closures::ballFaceContribution(center, radius, face.data(), 4, areaNormal(face));
        const double back = closures::ballFaceContribution(center, radius, reversed.data(), 4, areaNormal(reversed));
        EXPECT_NEAR(forth, -back, 1e-15*ballVolume(radius));
        EXPECT_NE(forth, 0.0);
    }
}

TEST(SphereOverlap, doubledCornersAndCornersAtTheFootTrapNothing)
{
    // A run may stop at invalid operations and divisions by zero; a repeated corner must cause neither.
    const Face face = {{0, 0, 0.5}, {0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
    const Face clean = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
    std::feclearexcept(FE_ALL_EXCEPT);
    for (double radius : {0.2, 0.5, 0.6, 1.0, 3.0})
    {
        for (const Vector3d& center : {Vector3d(0, 0, 0), Vector3d(0, 0, 0.5), Vector3d(0.3, 0, 0.1), Vector3d(2, 0, 0)})
        {
            const double got = closures::ballFaceContribution(center, radius, face.data(), 6, {0, 0, 1});
            const double expected = closures::ballFaceContribution(center, radius, clean.data(), 4, {0, 0, 1});
            EXPECT_NEAR(got, expected, 1e-14*ballVolume(radius));
        }
        EXPECT_EQ(closures::discEdgeContribution({0, 0}, radius, {4, 4}, {4, 4}), 0);
    }
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

TEST(SphereOverlap, facesOfManyEdgesInAnyUnit)
{
    // A prism over a polygon of 300 edges, far wider than the ball and around it.
    for (double unit : {1e-9, 1.0, 1e9})
    {
        Polyhedron prism(2);
        for (int i = 0; i < 300; ++i)
        {
            const double a = 2*pi*i/300, b = 2*pi*(i + 1)/300, R = 50*unit;
            const Vector3d p(R*std::cos(a), R*std::sin(a), 0), q(R*std::cos(b), R*std::sin(b), 0), up(0, 0, 40*unit);
            prism[0].push_back(p + up);
            prism[1].insert(prism[1].begin(), p);
            prism.push_back({p, q, q + up, p + up});
        }
        const double radius = unit;
        EXPECT_NEAR(overlap(prism, unit*Vector3d(7, 3, 20), radius)/ballVolume(radius), 1, 1e-13);
        EXPECT_NEAR(overlap(prism, unit*Vector3d(7, 3, 0), radius)/ballVolume(radius), 0.5, 1e-13);
    }
}

TEST(SphereOverlap, isSmoothWhereTheCenterMeetsFacesEdgesAndCorners)
{
    const Polyhedron cell = box(Vector3d::Zero(), Vector3d::Ones());
    const double radius = 0.4;
    const std::array<Vector3d, 8> places =
    {{
        {0, 0.5, 0.5}, {0, 0, 0.5}, {0, 0, 0}, {1, 1, 1}, {0.4, 0.5, 0.5}, {0.4, 0.4, 0.4}, {-0.4, 0.5, 0.5}, {-0.4, 0, 0}
    }};
    RandomPoints random(5);
    for (const Vector3d& place : places)
    {
        const double there = overlap(cell, place, radius);
        for (double step : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17})
        {
            for (int trial = 0; trial < 20; ++trial)
            {
                const Vector3d offset = step*random.point(-1, 1);
                const double bound = pi*radius*radius*offset.norm()*1.0000001 + 2e-15;
                EXPECT_NEAR(overlap(cell, place + offset, radius), there, bound) << place.transpose() << " step " << step;
            }
        }
    }
}

TEST(SphereOverlap, footOnAnEdgeOrCornerOfTheFace)
{
    // Slanted prism: the foot of the center falls on edges and corners of faces away from the center.
    RandomPoints random(6);
    for (double z : {0.05, 0.25, 0.4, 0.6})
    {
        for (const Vector3d& center : {Vector3d(0, 0, z), Vector3d(0, 0.5, z), Vector3d(1, 1, z), Vector3d(0.5, 0.5, z)})
        {
            const double there = overlap(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), center, 0.4);
            const double beside =
                overlap(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), center + random.point(-1e-13, 1e-13), 0.4);
            EXPECT_NEAR(there, beside, 1e-12*ballVolume(0.4));
        }
    }
}
