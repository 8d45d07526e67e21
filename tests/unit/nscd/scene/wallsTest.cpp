// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls of polygons: nearest points, corners and shared edges felt once.
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <cfenv>

using namespace scenes;

namespace
{

/// A square of side 1 in z = 0 with its corner at (x, y), seen from above.
void addSquare(nscd::Walls& walls, double x, double y)
{
    walls.addPolygon(0, {Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0)});
}

} // namespace

TEST(Wall, nearestPointOfFaceEdgeAndCorner)
{
    nscd::Walls walls;
    walls.addPatch("floor", 0);
    addSquare(walls, 0, 0);
    const nscd::WallRegion& square = walls.regions[0];
    EXPECT_EQ(square.normal, Vec3::UnitZ());

    const nscd::WallProximity face = nscd::nearestPoint(square, Vec3(0.3, 0.4, 0.2));
    EXPECT_TRUE(face.isInside);
    EXPECT_NEAR(face.distance, 0.2, 1e-15);
    EXPECT_NEAR((face.point - Vec3(0.3, 0.4, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR(nscd::nearestPoint(square, Vec3(0.3, 0.4, -0.2)).distance, -0.2, 1e-15);

    const nscd::WallProximity edge = nscd::nearestPoint(square, Vec3(1.3, 0.5, 0.4));
    EXPECT_FALSE(edge.isInside);
    EXPECT_NEAR(edge.distance, 0.5, 1e-15);
    EXPECT_NEAR((edge.normal - Vec3(0.6, 0, 0.8)).norm(), 0, 1e-15);

    const nscd::WallProximity corner = nscd::nearestPoint(square, Vec3(1.1, 1.2, 0.2));
    EXPECT_NEAR(corner.distance, 0.3, 1e-15);
    EXPECT_NEAR((corner.point - Vec3(1, 1, 0)).norm(), 0, 1e-15);
}

TEST(Wall, outlinesMayBeConcaveOrHaveHoles)
{
    nscd::Walls walls;
    walls.addPatch("floor", 0);
    walls.addPolygon(0, {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0)});
    EXPECT_TRUE(nscd::nearestPoint(walls.regions[0], Vec3(1.5, 0.5, 0.1)).isInside);
    EXPECT_FALSE(nscd::nearestPoint(walls.regions[0], Vec3(1.5, 1.5, 0.1)).isInside);

    nscd::WallRegion holed = walls.regions[0];
    const Vec3 hole[4] = {Vec3(0.2, 0.2, 0), Vec3(0.2, 0.8, 0), Vec3(0.8, 0.8, 0), Vec3(0.8, 0.2, 0)};
    for (int k = 0; k < 4; ++k) holed.edges.push_back({hole[k], hole[(k + 1) % 4]});
    EXPECT_FALSE(nscd::nearestPoint(holed, Vec3(0.5, 0.5, 0.1)).isInside);
    EXPECT_TRUE(nscd::nearestPoint(holed, Vec3(0.1, 0.5, 0.1)).isInside);
}

TEST(Wall, refusesWhatIsNoWall)
{
    nscd::Walls walls;
    walls.addPatch("floor", 0);
    EXPECT_THROW(walls.addPlane(0, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
    EXPECT_THROW(walls.addPolygon(0, {Vec3(0, 0, 0), Vec3(1, 0, 0)}), std::invalid_argument);
    EXPECT_THROW(walls.addPolygon(0, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}), std::invalid_argument);
    walls.addPlane(0, Vec3::Zero(), Vec3::UnitX());
    EXPECT_THROW(nscd::bounds(walls.regions[0]), std::invalid_argument);
}

namespace
{

constexpr double radius = 0.1, deltaT = 1e-3;

/// A floor of 3 x 3 unit squares with a wall of three at x = 0, as a mesh whose faces were not merged would give.
Scene tiledFloor(double friction)
{
    Scene scene(3, friction, 0.0);
    const int patch = scene.walls.addPatch("floor", 1);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j) addSquare(scene.walls, i, j);
        scene.walls.addPolygon(patch, {Vec3(0, i, 0), Vec3(0, i + 1, 0), Vec3(0, i + 1, 1), Vec3(0, i, 1)});
    }
    return scene;
}

} // namespace

TEST(Wall, aGrainOnASharedEdgeOrCornerHasOneContact)
{
    for (const Vec3& at : {Vec3(1, 1.5, radius), Vec3(1, 1, radius), Vec3(1 + 1e-9, 2, radius), Vec3(1.02, 1.97, radius), Vec3(1.5, 1.5, radius)})
    {
        Scene scene = tiledFloor(0.3);
        scene.addGrain(at, radius);
        auto dynamics = scene.build();
        for (int k = 0; k < 3; ++k) step(dynamics, scene.g, deltaT);
        ASSERT_EQ(dynamics.contacts().size(), 1u) << at.transpose();
        EXPECT_NEAR((dynamics.contacts()[0].normal - Vec3::UnitZ()).norm(), 0, 1e-12);
        const double force = dynamics.grains().mass[0]*gravity;
        EXPECT_NEAR(dynamics.wallForce()[0][2], -force, 1e-9*force);
        EXPECT_NEAR((dynamics.grains().position[0] - at).norm(), 0, 1e-12);
    }
}

TEST(Wall, aGrainInACornerTouchesBothWalls)
{
    Scene scene = tiledFloor(0.0);
    scene.addGrain(Vec3(radius, 1.5, radius), radius);
    scene.g = Vec3(-1, 0, -1);
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    EXPECT_EQ(dynamics.contacts().size(), 2u);
    const double mass = dynamics.grains().mass[0];
    EXPECT_NEAR((dynamics.wallForce()[0] - mass*scene.g).norm(), 0, 1e-9*mass);
}

TEST(Wall, slotsOfSuppressedEdgesRaiseNoFloatingPointError)
{
    Scene scene = tiledFloor(0.3);
    scene.addGrain(Vec3(1.02, 1.97, radius), radius);
    auto dynamics = scene.build();
    std::feclearexcept(FE_ALL_EXCEPT);
    for (int k = 0; k < 3; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
}

TEST(Wall, rollsOverSeamsAsOverAPlane)
{
    Scene tiled = tiledFloor(0.5), plain(3, 0.5, 0.0);
    plain.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (Scene* scene : {&tiled, &plain})
    {
        scene->addGrain(Vec3(0.3, 0.98, radius), radius);
        scene->grains.velocity[0] = Vec3(1.5, 0.7, 0);
    }
    auto a = tiled.build(), b = plain.build();
    for (int k = 0; k < 1200; ++k)
    {
        step(a, tiled.g, deltaT);
        step(b, plain.g, deltaT);
        ASSERT_NEAR((a.grains().position[0] - b.grains().position[0]).norm(), 0, 1e-9) << "step " << k;
    }
    EXPECT_GT(a.grains().position[0][0], 1.5);
}

TEST(Wall, aGrainTipsOverTheEdgeOfAFloor)
{
    Scene scene(3, 0.0, 0.0);
    scene.walls.addPatch("floor", 1);
    addSquare(scene.walls, 0, 0);
    scene.addGrain(Vec3(1.01, 0.5, radius), radius);
    auto dynamics = scene.build();
    for (int k = 0; k < 800; ++k)
    {
        step(dynamics, scene.g, deltaT);
        const nscd::WallProximity near = nscd::nearestPoint(scene.walls.regions[0], dynamics.grains().position[0]);
        ASSERT_GT(near.distance, 0.999*radius) << "step " << k;
    }
    EXPECT_LT(dynamics.grains().position[0][2], -radius);
}
