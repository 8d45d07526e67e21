// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Triangulated walls act as the surface they are: no ghost contacts at edges and vertices, both sides, nothing tunnels.
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace scenes;
using nscd::Triangle;

namespace
{

constexpr double radius = 0.1, deltaT = 1e-3;

std::vector<Triangle> square(double side)
{
    const Vec3 a(0, 0, 0), b(side, 0, 0), c(side, side, 0), d(0, side, 0);
    return {{a, b, c}, {a, c, d}};
}

/// Triangles around the middle of a square, slivers among them.
std::vector<Triangle> fan(double side)
{
    std::vector<Triangle> triangles;
    const Vec3 middle(0.5*side, 0.5*side, 0);
    const double angles[] = {0, 0.01, 0.02, 0.8, 1.6, 1.601, 2.5, 3.1, 3.8, 4.5, 4.5001, 5.6};
    for (int k = 0; k < 12; ++k)
    {
        const auto rim = [&](double a) { return Vec3(middle + side*Vec3(std::cos(a), std::sin(a), 0)); };
        triangles.push_back({middle, rim(angles[k]), rim(angles[(k + 1) % 12])});
    }
    return triangles;
}

/// Squares of random heights of 0 over a grid whose rows do not meet the next row's vertices: T-junctions.
std::vector<Triangle> brickwork(double side)
{
    std::vector<Triangle> triangles;
    for (int row = 0; row < 8; ++row)
    {
        for (int k = 0; k < 8; ++k)
        {
            const double w = side/8, y = row*w, x = k*w + (row % 2)*0.37*w;
            const Vec3 a(x, y, 0), b(x + w, y, 0), c(x + w, y + w, 0), d(x, y + w, 0);
            triangles.push_back({a, b, d});
            triangles.push_back({b, c, d});
        }
    }
    return triangles;
}

void turn(std::vector<Triangle>& triangles, const nscd::Quaternion& q)
{
    for (Triangle& t : triangles)
    {
        for (Vec3& x : t) x = q*x;
    }
}

/// Brings a grain onto a surface in z = 0, spinning and sliding across its middle, and compares with a plane.
void expectPlane(std::vector<Triangle> triangles, const nscd::Quaternion& q, double tolerance)
{
    Scene tiled(3, 0.4, 0.0), plain(3, 0.4, 0.0);
    turn(triangles, q);
    tiled.walls.addTriangles(tiled.walls.addPatch("floor", 1), triangles);
    plain.addPlane(Vec3::Zero(), q*Vec3::UnitZ());
    for (Scene* scene : {&tiled, &plain})
    {
        scene->g = q*scene->g;
        scene->addGrain(q*Vec3(0.61, 0.61, radius), radius);
        scene->grains.velocity[0] = q*Vec3(1.6, 1.6, 0);
        scene->grains.omega[0] = q*Vec3(0, 3, 1);
    }
    auto a = tiled.build(), b = plain.build();
    for (int k = 0; k < 700; ++k)
    {
        step(a, tiled.g, deltaT);
        step(b, plain.g, deltaT);
        ASSERT_NEAR((a.grains().velocity[0] - b.grains().velocity[0]).norm(), 0, tolerance) << "step " << k;
        ASSERT_NEAR((a.grains().omega[0] - b.grains().omega[0]).norm()*radius, 0, tolerance) << "step " << k;
        ASSERT_EQ(a.contacts().size(), 1u) << "step " << k;
    }
    EXPECT_GT((q.conjugate()*a.grains().position[0])[0], 1.1);
}

std::size_t contactsAt(const Scene& base, const Vec3& x, const Vec3& g)
{
    Scene scene = base;
    scene.addGrain(x, radius);
    scene.g = g;
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    return dynamics.contacts().size();
}

} // namespace

TEST(TriangulatedWall, flatFloorsOfAnyTrianglesArePlanes)
{
    const nscd::Quaternion level = nscd::Quaternion::Identity();
    const nscd::Quaternion tilted(Eigen::AngleAxisd(0.7, Vec3(1, 2, 0.5).normalized()));
    for (const nscd::Quaternion& q : {level, tilted})
    {
        expectPlane(square(2), q, 1e-12);
        expectPlane(fan(2), q, 1e-12);
        expectPlane(brickwork(2), q, 1e-12);
    }
}

TEST(TriangulatedWall, ridgesGiveOneContactValleysTwo)
{
    // A roof along y with slopes of 30 degrees, and the same turned over.
    const double rise = std::tan(M_PI/6);
    const auto roof = [&](double sign)
    {
        const Vec3 a(0, -1, 0), b(0, 1, 0), c(1, 0, -sign*rise), d(-1, 0, -sign*rise);
        Scene scene(3, 0.0, 0.0);
        scene.walls.addTriangles(scene.walls.addPatch("roof", 1), {{a, c, b}, {a, b, d}});
        return scene;
    };
    EXPECT_EQ(contactsAt(roof(1), Vec3(0, 0.2, radius), Vec3(0, 0, -1)), 1u);
    EXPECT_EQ(contactsAt(roof(1), Vec3(0.02, 0, std::sqrt(radius*radius - 4e-4)), Vec3(0, 0, -1)), 1u);
    EXPECT_EQ(contactsAt(roof(-1), Vec3(0, 0, radius/std::cos(M_PI/6)), Vec3(0, 0, -1)), 2u);

    // The load of the valley: each side carries m g/(2 cos 30 degrees).
    Scene valley = roof(-1);
    valley.addGrain(Vec3(0, 0, radius/std::cos(M_PI/6)), radius);
    auto dynamics = valley.build();
    step(dynamics, valley.g, deltaT);
    const double weight = dynamics.grains().mass[0]*gravity;
    EXPECT_NEAR(dynamics.wallForce()[0][2], -weight, 1e-9*weight);
    for (const nscd::LoadedContact& c : dynamics.contacts())
    {
        EXPECT_NEAR(c.impulse.dot(c.normal)/deltaT, weight/(2*std::cos(M_PI/6)), 1e-8*weight);
        EXPECT_NEAR(std::abs(c.normal[0]), 0.5, 1e-12);
    }
}

/// A peak of many triangles, one vertex: one contact, whatever the order of the triangles.
TEST(TriangulatedWall, aPeakIsOneContact)
{
    std::vector<Triangle> cone = fan(1);
    for (Triangle& t : cone)
    {
        for (Vec3& x : t) x[2] = -0.3*(x - Vec3(0.5, 0.5, 0)).norm();
    }
    std::mt19937 random(3);
    for (int order = 0; order < 5; ++order)
    {
        std::shuffle(cone.begin(), cone.end(), random);
        Scene scene(3, 0.0, 0.0);
        scene.walls.addTriangles(scene.walls.addPatch("cone", 1), cone);
        EXPECT_EQ(contactsAt(scene, Vec3(0.5, 0.5, radius), Vec3(0, 0, -1)), 1u);
        EXPECT_EQ(contactsAt(scene, Vec3(0.5 + 1e-8, 0.5, radius), Vec3(0, 0, -1)), 1u);
    }
}

/// Every gap that the list keeps is a local minimum of the distance to the surface, and the smallest is the distance itself.
TEST(TriangulatedWall, theNearestContactIsTheDistanceToTheSurface)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    // Hills: a grid of triangles over a rough height.
    std::vector<Triangle> hills;
    double height[12][12];
    for (auto& row : height) for (double& z : row) z = 0.05*unit(random);
    const auto vertex = [&](int i, int j) { return Vec3(0.06*i, 0.06*j, height[i][j]); };
    for (int i = 0; i < 11; ++i)
    {
        for (int j = 0; j < 11; ++j)
        {
            hills.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            hills.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    Scene scene(3, 0.0, 0.0);
    scene.walls.addTriangles(scene.walls.addPatch("hills", 1), hills);
    for (int k = 0; k < 60; ++k)
    {
        Vec3 x(0.33 + 0.2*unit(random), 0.33 + 0.2*unit(random), 0);
        // Lower the grain until it touches.
        const auto distance = [&]
        {
            double least = 1e9;
            for (const nscd::WallRegion& region : scene.walls.regions) least = std::min(least, nscd::nearestPoint(region, x).distance);
            return least;
        };
        x[2] = 0.5;
        while (distance() > radius*(1 + 1e-12)) x[2] -= distance() - radius;
        Scene one = scene;
        one.addGrain(x, radius);
        one.g = Vec3(0, 0, -1);
        auto dynamics = one.build();
        step(dynamics, one.g, 1e-5);
        ASSERT_GE(dynamics.contacts().size(), 1u);
        double nearest = 1e9;
        for (const nscd::LoadedContact& c : dynamics.contacts())
        {
            const Vec3 point = dynamics.grains().position[0] - (radius + c.gap)*c.normal;
            nearest = std::min(nearest, c.gap);
            // Around the point, the surface is nowhere nearer: no ghost.
            for (const nscd::WallRegion& region : scene.walls.regions)
            {
                if (std::abs(nscd::nearestPoint(region, point).distance) > 1e-9) continue;
                ASSERT_GT(nscd::nearestPoint(region, dynamics.grains().position[0]).distance, radius + c.gap - 1e-9);
            }
        }
        ASSERT_NEAR(nearest, 0.0, 1e-7);
    }
}

TEST(TriangulatedWall, sheetsActOnBothSides)
{
    for (double side : {1.0, -1.0})
    {
        Scene scene(3, 0.5, 0.0);
        scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), square(2));
        scene.addGrain(Vec3(1.3, 0.8, side*radius), radius);
        scene.g *= side;
        auto dynamics = scene.build();
        for (int k = 0; k < 20; ++k) step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.grains().position[0][2], side*radius, 1e-12);
        EXPECT_NEAR(dynamics.wallForce()[0][2], -side*gravity*dynamics.grains().mass[0], 1e-6);
    }
}

TEST(TriangulatedWall, oneSidedSheetsLetGrainsBehindThemBe)
{
    Scene scene(3, 0.5, 0.0);
    scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), square(2), nscd::WallSides::one);
    scene.addGrain(Vec3(1.3, 0.8, -0.7*radius), radius);
    auto dynamics = scene.build();
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(dynamics.grains().position[0][2], -0.7*radius - 0.5*gravity*0.3*(0.3 + deltaT), 1e-9);
}

/// A grain a hundred diameters a step away from a sheet does not pass it.
TEST(TriangulatedWall, nothingTunnelsThroughASheet)
{
    for (const Vec3& velocity : {Vec3(0, 0, -1), Vec3(0.3, -0.2, -1), Vec3(0, 0, -30)})
    {
        Scene scene(3, 0.3, 0.0);
        std::vector<Triangle> sheet = square(40);
        for (Triangle& t : sheet) for (Vec3& x : t) x -= Vec3(20, 20, 0);
        scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), sheet);
        scene.addGrain(Vec3(0.1, 0.3, 0.21), radius);
        scene.grains.velocity[0] = 2*radius/deltaT*velocity;
        auto dynamics = scene.build();
        for (int k = 0; k < 20; ++k)
        {
            step(dynamics, scene.g, deltaT);
            ASSERT_GT(dynamics.grains().position[0][2], radius*(1 - 1e-6)) << "step " << k;
        }
    }
}
