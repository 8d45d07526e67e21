// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A deep bed on several ranks that lost its impulses: its weight comes down, by momentum where a warm solve has forces off.
#include "rankedScene.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double stepLength = 1e-3;

} // namespace

TEST(Ranks, aDeepBedThatLostItsImpulsesIsCarriedAgain)
{
    const Scene scene = looseBed(4, 30);
    const double height = scene.grains.position.back()[2] + scene.grains.radius.back();
    nscd::ContactSettings settings;
    settings.sleep = false;
    RankedScene run(scene, settings, [=](const Vec3& x, std::int64_t) { return std::min(ranks() - 1, static_cast<int>(x[2]/height*ranks())); });
    for (int k = 0; k < 300; ++k) stepDamped(run.dynamics(), scene.g, stepLength);
    double weight = 0.0;
    for (double mass : scene.grains.mass) weight += mass*gravity;
    for (int k = 0; k < 20; ++k)
    {
        if (k % 10 == 0) run.dynamics().restore({}, stepLength);
        const nscd::StepReport report = step(run.dynamics(), scene.g, stepLength);
        EXPECT_TRUE(report.solve.converged) << "step " << k;
        EXPECT_NEAR(-run.dynamics().wallForce()[0][2], weight, 0.1*weight) << "step " << k;   // seen: 0.07, as what lost its friction slides
    }
}
