// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fast grains at surfaces of triangles, at edges and at walls that move: none comes through.
#include "unit/nscd/scenes/shots.hpp"

#include <gtest/gtest.h>

using namespace scenes;

TEST(SweptWalls, holdAVolleyAtAWavySheet)
{
    // 144 spheres of 5 mm at 100 m/s in steps of 1 ms, onto a sheet of 7200 triangles.
    Scene scene(3, 0.3, 0.5);
    scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), wavySheet(60));
    for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
    {
        scene.addGrain(Vec3(0.012*(i - 5.5), 0.012*(j - 5.5), 0.05), 0.0025);
        scene.grains.velocity.back() = Vec3(0, 0, -100);
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 5; ++k)
    {
        step(dynamics, scene.g, 1e-3);
        for (const Vec3& x : dynamics.grains().position) EXPECT_GT(x[2], waveHeight(x)) << k;
    }
}

TEST(SweptWalls, letNoShotThrough)
{
    Tally tally;
    for (const Surface surface : allSurfaces()) shoot(surface, 1000, 7, tally);
    EXPECT_GT(tally.shots, 4000);
    EXPECT_EQ(tally.passed, 0);
    EXPECT_LT(tally.energyGain, 1e-9);
    EXPECT_LT(tally.unconvergedGain, 1e-6);
}
