// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lists of grains that fly many diameters a step: as short as their meetings, or refused in words.
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, spacing = 0.75e-3;

/// n^3 spheres of 0.2 mm in a periodic box, with a velocity that is common to all and one of each [m/s].
Scene cloud(int n, const Vec3& common, double ofEach)
{
    Scene scene(3, 0.3, 0.0);
    scene.box.length = Vec3::Constant(n*spacing);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < n*n*n; ++i)
    {
        scene.addGrain(spacing*Vec3(i % n + 0.5, i/n % n + 0.5, i/(n*n) + 0.5), 1e-4);
        scene.grains.velocity.back() = common + ofEach*Vec3(normal(random), normal(random), normal(random));
    }
    return scene;
}

std::string refusal(const Scene& scene)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    try
    {
        step(dynamics, Vec3::Zero(), deltaT);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(FastFlow, hasListsThatGrowWithTheGrainsAlone)
{
    // 14 mm a step through a box of 6 mm, and one of 12 mm.
    const auto candidates = [](int n)
    {
        const Scene scene = cloud(n, Vec3(4, 7, -11), 0.1);
        auto dynamics = scene.build(nscd::ContactSettings());
        std::size_t most = 0;
        for (int k = 0; k < 4; ++k) most = std::max(most, step(dynamics, Vec3::Zero(), deltaT).candidates);
        return static_cast<double>(most)/static_cast<double>(scene.grains.size());
    };
    const double few = candidates(8), many = candidates(16);
    EXPECT_LT(few, 20.0);
    EXPECT_LT(many, 1.3*few);
}

TEST(FastFlow, missesNoPair)
{
    // Seen by whoever moves with it, a flow is a cloud at rest.
    const Vec3 common(4, 7, -11);
    auto flow = cloud(5, common, 0.15).build(), rest = cloud(5, Vec3::Zero(), 0.15).build();
    for (int k = 0; k < 6; ++k)
    {
        step(flow, Vec3::Zero(), deltaT);
        step(rest, Vec3::Zero(), deltaT);
        for (std::size_t i = 0; i < flow.grains().size(); ++i)
        {
            EXPECT_LT((flow.grains().velocity[i] - common - rest.grains().velocity[i]).norm(), 1e-6) << k;
        }
    }
    EXPECT_LT(nscd::kineticEnergy(rest.grains()), 0.95*nscd::kineticEnergy(cloud(5, Vec3::Zero(), 0.15).grains));
}

TEST(FastFlow, isRefusedForWaysOfMoreThanAPeriod)
{
    EXPECT_NE(refusal(cloud(4, Vec3::Zero(), 14.0)).find("at most the period, 0.003 m: use a smaller time step"), std::string::npos);
    EXPECT_EQ(refusal(cloud(4, Vec3::Zero(), 0.1)), "");
}

TEST(FastFlow, isRefusedForPairsWithoutEnd)
{
    Scene scene = cloud(16, Vec3::Zero(), 14.0);
    scene.box.length.setZero();
    EXPECT_NE(refusal(scene).find("at most 1000 a grain (or a million): grains fly too far in a step"), std::string::npos);
}
