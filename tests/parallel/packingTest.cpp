// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts that are packed on each rank, those within it before those with others, are solved as they are where they lie on one.
#include "rankedScene.hpp"

#include "unit/nscd/scenes/impulseBalance.hpp"

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

/// Slabs and layers; while a heap lands its upper layers have no contacts. Some ranks may have no grain.
std::vector<OwnerOf> owners()
{
    const auto cell = [](double x) { return std::max(0, static_cast<int>(std::floor(x/spacing))); };
    return
    {
        [=](const Vec3& x, std::int64_t) { return cell(x[0])/std::max(1, 8/ranks()) % ranks(); },
        [=](const Vec3& x, std::int64_t) { return cell(x[0]) % ranks(); },
        [=](const Vec3& x, std::int64_t) { return cell(x[2])/2 % ranks(); },
        [](const Vec3&, std::int64_t) { return ranks() - 1; }
    };
}

Scene landingHeap(double friction, double restitution)
{
    Scene scene = heap(3, 8, 5, radius, 0.7, friction);
    for (int a : {0, 1}) for (int b : {0, 1}) scene.materials.setPair(a, b, {friction, restitution});
    return scene;
}

} // namespace

/// Velocities are unique without friction.
TEST(Ranks, packedContactsMoveGrainsAsOnOne)
{
    for (double restitution : {0.0, 0.3})
    for (const OwnerOf& ownerOf : owners())
    {
        const Scene scene = landingHeap(0.0, restitution);
        RankedScene run(scene, packing(tight(), true), ownerOf);
        auto serial = scene.build(packing(tight(), false));
        std::size_t contacts = 0;
        for (int k = 0; k < 50; ++k)
        {
            EXPECT_TRUE(step(run.dynamics(), scene.g, deltaT).solve.converged) << k;
            contacts = step(serial, scene.g, deltaT).solve.contacts;
        }
        EXPECT_GT(contacts, 50u);
        EXPECT_GT(run.dynamics().times().seconds(nscd::GrainPart::packContacts), 0.0) << "nothing was packed";
        double worst = 0.0;
        const nscd::Grains all = run.gatherGrains();
        for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, (all.position[i] - serial.grains().position[i]).norm());
        EXPECT_LT(worst, 1e-8*radius) << restitution;
    }
}

TEST(Ranks, packedContactsHoldAllThatGrainsGet)
{
    for (double restitution : {0.0, 0.6})
    for (const OwnerOf& ownerOf : owners())
    {
        const Scene scene = landingHeap(0.5, restitution);
        RankedScene run(scene, packing(nscd::ContactSettings(), true), ownerOf);
        for (int k = 0; k < 60; ++k)
        {
            const nscd::Grains before = run.gatherGrains();
            step(run.dynamics(), scene.g, deltaT);
            const std::vector<Vec3> impulses = sumOfImpulses(run.gatherContacts(), before.size());
            const double worst = worstImbalance(before, run.gatherGrains(), impulses, scene.g, deltaT, [](std::size_t) { return true; });
            ASSERT_LT(worst, 1e-11) << restitution << ", step " << k;
        }
    }
}
