// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The direct method: what it solves that sweeps do not, and when it is used.
#include "unit/nscd/scenes/scenes.hpp"

#include "nscd/scene/stepWarnings.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

Scene stack(int grains, double topRatio = 1.0)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.grains.mass.back() *= topRatio;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

double baseForceError(const Scene& scene, const nscd::GrainDynamics& dynamics)
{
    double load = 0.0;
    for (double m : scene.grains.mass) load += m*gravity;
    return std::abs(dynamics.wallForce()[0][2] + load)/load;
}

} // namespace

TEST(Direct, stackOfThreeHundredFromCold)
{
    nscd::ContactSettings settings = tight();
    settings.solver = "direct";
    settings.tolerance = settings.displacementTolerance = 1e-8;
    const Scene scene = stack(300);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_TRUE(report.solve.converged);
    EXPECT_EQ(report.solve.sweeps, 0);
    EXPECT_GT(report.solve.newtonSteps, 0);
    EXPECT_LT(baseForceError(scene, dynamics), 1e-6);
}

TEST(Direct, takesOverWhereSweepsWouldGoToTheCap)
{
    // Sweeps alone leave a base force off by more than a half.
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-8;
    const Scene scene = stack(300);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_TRUE(report.solve.converged);
    EXPECT_LT(baseForceError(scene, dynamics), 1e-6);
}

TEST(Direct, makesForcesUnderHeavyBodiesRight)
{
    for (double ratio : {1e3, 1e4})
    {
        const Scene scene = stack(20, ratio);
        auto dynamics = scene.build(nscd::ContactSettings());
        for (int k = 0; k < 50; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, deltaT);
            EXPECT_TRUE(report.solve.converged);
            EXPECT_EQ(nscd::warning(report.solve), "");
            ASSERT_LT(baseForceError(scene, dynamics), 1e-3) << ratio << " step " << k;
        }
    }
}

TEST(Direct, saysSoWhereItIsTooDearForAHeavyBody)
{
    nscd::ContactSettings settings;
    settings.maxSweeps = 100;  // what the direct method may cost goes with it
    const Scene scene = stack(20, 1e4);
    auto dynamics = scene.build(settings);
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(report.solve.hiddenMassRatio, 1e4, 1.0);
    EXPECT_NE(nscd::warning(report.solve).find("1:1e+04"), std::string::npos) << nscd::warning(report.solve);
}
