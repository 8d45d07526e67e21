// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that fall by more than a diameter in a step onto others, on several ranks.
#include "rankedScene.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 2e-3, radius = 0.6e-3;
const Vec3 box(0.0107, 0.0072, 0.12);

Scene rain()
{
    Scene scene(3, 0.1, 0.3);
    nscd::addLattice(scene.grains, {Vec3::Zero(), box, {8, 5, 40}, radius, 0.1, 1.0}, 2500.0, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int axis = 0; axis < 2; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(box[axis]*Vec3::Unit(axis), -Vec3::Unit(axis));
    }
    return scene;
}

/// Of all pairs, listed or not [d].
double deepestOverlap(const nscd::Grains& grains)
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) deepest = std::max(deepest, grains.radius[i] + grains.radius[j] - (grains.position[i] - grains.position[j]).norm());
    return deepest/(2.0*radius);
}

} // namespace

TEST(Ranks, rainInLongStepsHasShortListsThatMissNoPair)
{
    const Scene scene = rain();
    RankedScene run(scene, nscd::ContactSettings(), [](const Vec3& x, std::int64_t) { return std::min(ranks() - 1, static_cast<int>(x[0]/box[0]*ranks())); });
    double listed = 0.0;
    for (int k = 0; k < 50; ++k)
    {
        const nscd::StepReport report = step(run.dynamics(), scene.g, deltaT);
        if (k >= 30) listed += static_cast<double>(report.candidates)/static_cast<double>(scene.grains.size());
        if (k % 10 == 9) EXPECT_LT(deepestOverlap(run.gatherGrains()), 1e-3) << k;
    }
    EXPECT_LT(listed/20, 30.0);   // candidates a grain; before, 62 on one rank and 101 on two
}
