// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlap is pushed apart: by how much, which of two grains, and nobody else.
#include "nscd/step/overlapCorrection.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.1, deadBand = 1e-6, tolerance = 1e-4, left = 0.1*tolerance;   // what the correction leaves

double deepest(const nscd::ContactList& list) { return -*std::min_element(list.gap.begin(), list.gap.end()); }

/// One pass, as a step makes it.
int correct(nscd::ContactList& list, const Scene& scene)
{
    return nscd::correctOverlaps(list, partsOf(scene), {}, deepest(list), tolerance, deadBand);
}

/// As many as steps would make one after the other.
void correctAll(nscd::ContactList& list, const Scene& scene)
{
    for (int pass = 0; pass < 8 && deepest(list) > tolerance; ++pass) correct(list, scene);
}

Vec3 positionOf(const nscd::ContactList& list, int grain) { return list.position[bodyOf(list, grain)]; }

} // namespace

TEST(OverlapCorrection, twoGrainsShareThePushByTheirMasses)
{
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3::Zero(), radius, 1000.0);
    scene.addGrain(Vec3(0.19, 0, 0), radius, 3000.0);
    nscd::ContactList list = listContacts(scene, 0.05);
    correct(list, scene);
    EXPECT_NEAR(list.gap[usedSlots(list)[0]], -left, 1e-14);
    EXPECT_NEAR(positionOf(list, 0)[0], -0.75*(0.01 - left), 1e-14);
    EXPECT_NEAR(positionOf(list, 1)[0], 0.19 + 0.25*(0.01 - left), 1e-14);
}

TEST(OverlapCorrection, aColumnGoesUpFromItsFloor)
{
    Scene scene(3, 0.3, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int i = 0; i < 5; ++i) scene.addGrain(Vec3(0, 0, 0.95*radius*(2*i + 1)), radius);
    scene.addGrain(Vec3(1, 0, 0.5), radius);
    nscd::ContactList list = listContacts(scene, 0.05);
    correctAll(list, scene);
    EXPECT_LE(deepest(list), tolerance);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(positionOf(list, i)[2], radius*(2*i + 1), (i + 1)*tolerance);
    EXPECT_EQ(positionOf(list, 5), scene.grains.position[5]);
}

TEST(OverlapCorrection, goesByWallsThatTheListLacksToo)
{
    // A column of three whose floor is known to the correction alone, which starts 0.04 below it.
    Scene scene(3, 0.3, 0.0);
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1) - 0.04), radius);
    nscd::ContactList list = listContacts(scene, 0.05);
    const nscd::WallGap floor{bodyOf(list, 0), Vec3::UnitZ(), -0.04};
    nscd::correctOverlaps(list, partsOf(scene), {floor}, 0.04, tolerance, deadBand);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(positionOf(list, i)[2], radius*(2*i + 1), (i + 1)*tolerance) << i;
}

TEST(OverlapCorrection, aCloudLosesItsOverlapAndKeepsItsMassCenter)
{
    Scene scene = cloud(150);
    scene.walls = nscd::Walls();
    nscd::ContactList list = listContacts(scene, 0.05);
    const auto center = [&]
    {
        Vec3 sum = Vec3::Zero();
        for (int body = 0; body < list.owned(); ++body) sum += list.position[body]/list.inverseMass[body];
        return sum;
    };
    const Vec3 before = center();
    ASSERT_GT(deepest(list), 0.02);
    correctAll(list, scene);
    EXPECT_LE(deepest(list), tolerance);
    EXPECT_LT((center() - before).norm(), 1e-12*before.norm());
}

TEST(OverlapCorrection, heldGrainsStay)
{
    Scene scene(3, 0.3, 0.0);
    scene.addGrain(Vec3::Zero(), radius);
    scene.addGrain(Vec3(0.19, 0, 0), radius);
    scene.grains.isFixed[0] = 1;
    nscd::ContactList list = listContacts(scene, 0.05);
    correct(list, scene);
    EXPECT_EQ(positionOf(list, 0), Vec3::Zero());
    EXPECT_NEAR(positionOf(list, 1)[0], 2*radius - left, 1e-14);
}
