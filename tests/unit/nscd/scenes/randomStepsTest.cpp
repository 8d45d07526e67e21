// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Time steps that change at random from one to the next: a column of spheres collapses as with steps of one length.
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

using namespace scenes;

namespace
{

constexpr double end = 0.3;   // s: the last grains have come to rest

/// 250 spheres of 5 mm in a quarter of a trough.
Scene column(double restitution)
{
    Scene scene(3, 0.3, restitution);
    nscd::addLattice(scene.grains, {{0, 0, 0}, {0.03, 0.03, 0.06}, {5, 5, 10}, 0.005, 0.1, 0.3}, 2500.0, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int axis = 0; axis < 2; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(Vec3(0.12, 0.03, 0.0), -Vec3::Unit(axis));
    }
    return scene;
}

/// Mean position at the end, with steps as long as they come.
Vec3 collapse(double restitution, const std::function<double()>& nextStep)
{
    const Scene scene = column(restitution);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (double time = 0.0; time < end;)
    {
        const double deltaT = std::min(nextStep(), std::max(1e-5, end - time));
        EXPECT_LT(step(dynamics, scene.g, deltaT).overlapMax, 1e-3);
        time += deltaT;
    }
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : dynamics.grains().position) sum += x;
    return sum/static_cast<double>(dynamics.grains().size());
}

} // namespace

// Factors of 0.1 to 10 on 1 ms, each as likely as any other: their mean over time is 5 ms.
TEST(RandomSteps, endWhereStepsOfOneLengthDo)
{
    for (double restitution : {0.0, 0.5})
    {
        const Vec3 expected = collapse(restitution, [] { return 5e-3; });
        for (unsigned seed = 1; seed <= 2; ++seed)
        {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> exponent(-1, 1);
            const Vec3 found = collapse(restitution, [&] { return 1e-3*std::pow(10.0, exponent(random)); });
            EXPECT_LT((found - expected).norm(), 0.05*expected.norm()) << restitution << ' ' << seed;
            EXPECT_NEAR(found[1], 0.015, 0.05*0.015);
        }
    }
}
