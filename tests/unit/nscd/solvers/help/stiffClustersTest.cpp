// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Light spheres that stick between heavy ones and the floor, solved with their contacts at once.
#include "unit/nscd/scenes/lawScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

/// A ball of 10 mm that falls onto light ones of 0.5 mm around its foot, held by friction in the wedges between ball and floor.
Scene wedgedBall()
{
    const double small = 0.25e-3, large = 5e-3;
    Scene scene(3, 0.5, 0.0);
    // They touch ball and floor: (x^2 + (large - small)^2) = (large + small)^2.
    const double x = std::sqrt(std::pow(large + small, 2) - std::pow(large - small, 2));
    for (int k = 0; k < 3; ++k)
    {
        const double angle = 2.0*M_PI*k/3.0;
        scene.addGrain(Vec3(x*std::cos(angle), x*std::sin(angle), small), small);
    }
    scene.addGrain(Vec3(0, 0, large + 1e-6), large);
    scene.addPlane(Vec3(0, 0, 0), Vec3::UnitZ());
    return scene;
}

int sweepsOfSteps(bool areClustersOn, int& atCap, const nscd::ContactPair& pair = {0.5, 0.0})
{
    Scene scene = wedgedBall();
    setAll(scene, pair);
    nscd::ContactSettings settings;
    settings.strategy.direct.isOn = false;
    settings.strategy.held.isOn = false;
    settings.strategy.clusters.isOn = areClustersOn;
    nscd::Grains grains = scene.grains;
    grains.velocity.back() = Vec3(0.05, 0.0, 0.0);
    nscd::GrainDynamics dynamics(grains, scene.materials, scene.walls, scene.box, settings);
    int sweeps = 0;
    for (int k = 0; k < 20; ++k)
    {
        const nscd::SolveReport report = step(dynamics, scene.g, 1e-3).solve;
        sweeps += report.sweeps;
        atCap += report.atCap;
    }
    return sweeps;
}

} // namespace

TEST(StiffClusters, takeTheLoadOfAHeavyBodyAtOnce)
{
    int atCap = 0, atCapWithout = 0;
    const int sweeps = sweepsOfSteps(true, atCap), without = sweepsOfSteps(false, atCapWithout);
    EXPECT_EQ(atCap, 0);
    EXPECT_GT(atCapWithout, 0);
    EXPECT_LT(5*sweeps, without);
}

TEST(StiffClusters, takeMomentsAlong)
{
    int atCap = 0, atCapWithout = 0;
    const nscd::ContactPair rolling = rollingPair(0.5, 0.05, 0.02);
    const int sweeps = sweepsOfSteps(true, atCap, rolling), without = sweepsOfSteps(false, atCapWithout, rolling);
    EXPECT_EQ(atCap, 0);
    EXPECT_GT(atCapWithout, 0);
    EXPECT_LT(5*sweeps, without);
}

TEST(StiffClusters, leaveToSweepsWhatTouchesNoUnlikeBody)
{
    // A heap of like spheres lands; the heavy one lies apart.
    const double radius = 1e-3;
    Scene scene(3, 0.5, 0.0);
    for (int k = 0; k < 8; ++k)
    for (int i = 0; i < 25; ++i) scene.addGrain(radius*Vec3(2.1*(i % 5) + 0.1*(k % 3), 2.1*(i/5) + 0.1*(k % 2), 2.02*k + 1.0), radius);
    scene.addGrain(Vec3(0.1, 0, 0.01), 0.01);
    scene.addPlane(Vec3(0, 0, 0), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.strategy.direct.isOn = false;
    settings.tolerance = 1e-4;
    settings.displacementTolerance = 3e-6;
    nscd::GrainDynamics dynamics = scene.build(settings);
    int most = 0;
    for (int k = 0; k < 20; ++k)
    {
        const nscd::SolveReport report = step(dynamics, scene.g, 1e-3).solve;
        EXPECT_EQ(report.newtonSteps, 0) << k;
        most = std::max(most, report.sweeps);
    }
    EXPECT_GT(most, settings.strategy.clusters.sweepsBetween);
}
