// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Periodic boxes: a scene moved by any distance does the same.
#include "unit/nscd/scenes/heaps.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

/// A heap on a floor, periodic in both horizontal directions, moved by `shift`.
Scene periodicHeap(const Vec3& shift)
{
    Scene scene = heap(3, 4, 5, radius, 0.7, 0.4);
    const double width = scene.walls.regions[2].point[0];
    scene.walls = nscd::Walls();
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.box.length = Vec3(width, width, 0);
    for (Vec3& x : scene.grains.position) x = scene.box.wrap(x + shift);
    return scene;
}

} // namespace

TEST(Periodic, theMovedSceneDoesTheSame)
{
    const Vec3 shift(0.037, -0.011, 0);
    Scene scene = periodicHeap(Vec3::Zero()), moved = periodicHeap(shift);
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-8;
    settings.maxSweeps = 100000;
    auto a = scene.build(settings), b = moved.build(settings);
    // A collapse is chaotic: only the first contacts can be compared grain by grain.
    for (int k = 0; k < 40; ++k)
    {
        step(a, scene.g, deltaT);
        step(b, moved.g, deltaT);
    }
    EXPECT_GT(a.contacts().size(), 5u);
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const Vec3 difference = scene.box.nearestImage(b.grains().position[i] - a.grains().position[i] - shift);
        ASSERT_NEAR(difference.norm(), 0.0, 1e-6*radius) << i;
    }
}

TEST(Periodic, weightAndSidewaysMomentumAreKept)
{
    const Scene scene = periodicHeap(Vec3(0.02, 0.02, 0));
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, deltaT);
    for (int k = 0; k < 1500; ++k) stepDamped(dynamics, scene.g, deltaT);
    step(dynamics, scene.g, deltaT);
    double mass = 0.0;
    for (double m : scene.grains.mass) mass += m;
    EXPECT_NEAR(dynamics.wallForce()[0][2], -mass*gravity, 1e-4*mass*gravity);
    Vec3 forces = Vec3::Zero();
    for (const Vec3& force : dynamics.contactForce()) forces += force;
    EXPECT_NEAR((forces + dynamics.wallForce()[0]).norm(), 0.0, 1e-12*mass*gravity);
    for (const Vec3& x : dynamics.grains().position)
    {
        for (int axis : {0, 1})
        {
            EXPECT_GE(x[axis], 0.0);
            EXPECT_LT(x[axis], scene.box.length[axis]);
        }
    }
}

/// A floor that ends at the periodic sides goes on across them, also for a grain that crosses one by a diameter before its list is built anew.
TEST(Periodic, aFiniteWallGoesOnAcrossTheBorder)
{
    const double length = 20*radius;
    Scene scene(3, 0.0, 0.0);
    const auto at = [=](double x, double y) { return Vec3(x*length, y*length, 0); };
    std::vector<nscd::Triangle> floor;
    for (int half : {0, 1})
    {
        const double y = 0.5*half, next = y + 0.5;
        floor.push_back({at(-1, y), at(30, y), at(30, next)});
        floor.push_back({at(-1, y), at(30, next), at(-1, next)});
    }
    scene.walls.addTriangles(scene.walls.addPatch("floor", 1), floor);
    scene.box.length = Vec3(0, length, 0);
    for (int direction : {1, -1})
    {
        scene.addGrain(Vec3(5*radius*direction + 6*radius, 7*radius, radius), radius);
        scene.grains.velocity.back() = Vec3(0.3, direction*0.6*radius/deltaT, 0);
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 300; ++k)
    {
        step(dynamics, scene.g, deltaT);
        for (const Vec3& x : dynamics.grains().position) ASSERT_NEAR(x.z(), radius, 1e-6*radius) << k;
    }
}

TEST(Periodic, aPairTouchesThroughTheBorder)
{
    Scene scene(3, 0.0, 1.0);
    scene.box.length = Vec3(1, 0, 0);
    scene.addGrain(Vec3(0.005, 0, 0), radius);
    scene.addGrain(Vec3(0.985, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(-1, 0, 0);
    auto dynamics = scene.build();
    step(dynamics, Vec3::Zero(), deltaT);
    EXPECT_NEAR(dynamics.grains().velocity[0][0], 0, 1e-10);
    EXPECT_NEAR(dynamics.grains().velocity[1][0], -1, 1e-10);
}
