// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts that are packed on each rank, those within it before those with others, are solved as they are where they lie on one.
#include "rankedScene.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01, spacing = 2.3*radius;

nscd::ContactSettings packing(nscd::ContactSettings settings, bool isOn)
{
    settings.strategy.packing.isOn = isOn;
    settings.strategy.packing.longSolve = settings.strategy.packing.longShock = 0;
    settings.strategy.packing.largeProblem = 1;
    return settings;
}

} // namespace

/// Velocities are unique without friction: a heap that lands, with and without rebounds.
TEST(Ranks, packedContactsMoveGrainsAsOnOne)
{
    for (double restitution : {0.0, 0.3})
    for (int spacings : {std::max(1, 8/ranks()), 1})   // of a slab
    {
        Scene scene = heap(3, 8, 5, radius, 0.7, 0.0);
        scene.materials.setPair(0, 0, {0.0, restitution});
        const auto ownerOf = [=](const Vec3& x, std::int64_t) { return static_cast<int>(std::max(0.0, x[0])/(spacings*spacing)) % ranks(); };
        RankedScene run(scene, packing(tight(), true), ownerOf);
        auto serial = scene.build(packing(tight(), false));
        std::size_t contacts = 0;
        for (int k = 0; k < 60; ++k)
        {
            EXPECT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged) << k;
            contacts = step(serial, scene.g, deltaT).solve.contacts;
        }
        EXPECT_GT(contacts, 100u);
        double worst = 0.0;
        const nscd::Grains all = run.gatherGrains();
        for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, (all.position[i] - serial.grains().position[i]).norm());
        EXPECT_LT(worst, 1e-8*radius) << restitution << " " << spacings;
    }
}
