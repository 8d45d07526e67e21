// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of a list against those of two spheres, and of a sphere and a plane.
#include "nscd/contacts/contactGeometry.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace scenes;

TEST(ContactGeometry, isThatOfSpheresAndPlanesAcrossPeriodicSides)
{
    Scene scene = cloud(400);
    nscd::ContactList list = listContacts(scene, 0.01);
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, 0.002);
    for (Vec3& x : list.position) x += Vec3(normal(random), normal(random), normal(random));
    nscd::updateGeometry(list, partsOf(scene));
    int acrossSides = 0;
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        const bool isPair = list.wall[slot] < 0;
        Vec3 x = isPair ? Vec3(list.position[a] - list.position[b]) : Vec3(0, 0, list.position[a][2]);
        for (int axis = 0; axis < 3 && isPair; ++axis) x[axis] -= list.image[slot][axis]*scene.box.length[axis];
        if (isPair) { EXPECT_LT((x - scene.box.nearestImage(x)).norm(), 1e-15); }
        acrossSides += isPair && list.image[slot] != std::array<signed char, 3>{0, 0, 0};
        const Vec3 n = isPair ? Vec3(x.normalized()) : Vec3(Vec3::UnitZ());
        const double gap = isPair ? x.norm() - list.radius[a] - list.radius[b] : x[2] - list.radius[a];
        EXPECT_LT((nscd::normal(list, slot) - n).norm(), 1e-15);
        EXPECT_NEAR(list.gap[slot], gap, 1e-15);
    }
    EXPECT_GT(acrossSides, 20);
}

TEST(ContactGeometry, coincidentCentersAreRefusedByName)
{
    Scene scene(3, 0.0, 0.0);
    for (double x : {0.0, 1.0, 1.0}) scene.addGrain(Vec3(x, 0, 0), 0.1);
    try
    {
        listContacts(scene, 0.01);
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        const std::string text = error.what();
        EXPECT_TRUE(text.find("grains 1 and 2") != std::string::npos || text.find("grains 2 and 1") != std::string::npos) << text;
    }
}

TEST(ContactGeometry, aWallOfOneSideIsFeltUpToHalfARadiusBehindIt)
{
    const double radius = 0.1;
    for (double height : {0.05, -0.04, -0.06})
    {
        Scene scene(3, 0.0, 0.0);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        scene.addGrain(Vec3(0, 0, height), radius);
        const nscd::ContactList list = listContacts(scene, radius);
        ASSERT_EQ(usedSlots(list).size(), 1u);
        const double gap = list.gap[usedSlots(list)[0]];
        if (height > -0.5*radius) EXPECT_NEAR(gap, height - radius, 1e-15) << height;
        else EXPECT_EQ(gap, std::numeric_limits<double>::max()) << height;
    }
}

TEST(ContactGeometry, normalsOfDiscsStayInTheirPlane)
{
    Scene scene(2, 0.0, 0.0);
    scene.grains.shape.emptyAxis = 1;
    scene.addPlane(Vec3::Zero(), Vec3(0.3, 0.2, 1));
    scene.addGrain(Vec3(0, 0, 0.1), 0.1);
    const nscd::ContactList list = listContacts(scene, 0.1);
    ASSERT_EQ(usedSlots(list).size(), 1u);
    EXPECT_LT((nscd::normal(list, usedSlots(list)[0]) - Vec3(0.3, 0, 1).normalized()).norm(), 1e-15);
}
