// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls that move, on several ranks: every rank holds them all, and forces and torques are those of all ranks' grains.
#include "rankedScene.hpp"

#include "unit/nscd/scenes/drums.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;


nscd::ContactSettings fine()
{
    nscd::ContactSettings settings;
    settings.tolerance = 1e-9;
    settings.displacementTolerance = 1e-10;
    settings.maxSweeps = 100000;
    return settings;
}

} // namespace

TEST(Ranks, aDrumTurnsTheSameOnAnyNumberOfRanks)
{
    const Scene scene = drum(6.0, 0.005, 32);
    constexpr int steps = 40;
    auto serial = scene.build(fine());
    for (int k = 0; k < steps; ++k) step(serial, scene.g, deltaT);

    RankedScene run(scene, fine(), [](const Vec3& x, std::int64_t) { return std::min(ranks() - 1, static_cast<int>((x[0] + 0.05)/0.1*ranks())); });
    for (int k = 0; k < steps; ++k) step(run.dynamics(), scene.g, deltaT);

    const nscd::Grains all = run.gatherGrains();
    double worst = 0;
    for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, (all.position[i] - serial.grains().position[i]).norm());
    EXPECT_LT(worst, 1e-6*0.01);
    const double weight = nscd::totalVolume(scene.grains)*2500*gravity;
    EXPECT_GT(serial.wallForce()[0].norm(), 0.1*weight);
    EXPECT_NEAR((run.dynamics().wallForce()[0] - serial.wallForce()[0]).norm(), 0, 1e-4*weight);
    EXPECT_NEAR((run.dynamics().wallTorque()[0] - serial.wallTorque()[0]).norm(), 0, 1e-4*weight*0.05);
}
