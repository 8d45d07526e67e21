// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What slots of a list hold of their candidates: coefficients of both materials, the wall, all pairs in reach once.
#include "nscd/contacts/listBlocks.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace scenes;

namespace
{

/// A cloud of two materials over a floor of a third; each pair has friction and restitution of its own.
Scene mixture()
{
    Scene scene = cloud(300);
    scene.materials.add("other");
    for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) scene.materials.setPair(a, b, {0.1 + 0.1*a + 0.01*b, 0.2 + 0.1*a + 0.02*b});
    for (std::size_t i = 0; i < scene.grains.size(); i += 3) scene.grains.material[i] = 2;
    return scene;
}

} // namespace

TEST(ListBlocks, slotsHaveTheCoefficientsOfTheirTwoMaterials)
{
    const Scene scene = mixture();
    const nscd::ContactList list = listContacts(scene, 0.01);
    const std::vector<int> material = nscd::materialOfBodies(list, partsOf(scene));
    std::set<std::pair<int, int>> met;
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        const int ofA = scene.grains.material[list.grainOf[a]], ofB = list.wall[slot] >= 0 ? 1 : scene.grains.material[list.grainOf[b]];
        EXPECT_EQ(material[a], ofA);
        const nscd::ContactPair& pair = scene.materials.pair(ofA, ofB);
        EXPECT_EQ(list.blocks[slot/nscd::blockLanes].friction[slot % nscd::blockLanes], pair.friction);
        EXPECT_EQ(list.restitution[slot], pair.restitution);
        met.insert(std::minmax(ofA, ofB));
    }
    EXPECT_EQ(met.size(), 5u);
    EXPECT_EQ(list.candidates, usedSlots(list).size());
}

TEST(ListBlocks, holdEveryPairAndWallWithinReachOnce)
{
    const Scene scene = mixture();
    const double reach = 0.01;
    const nscd::ContactList list = listContacts(scene, reach);
    std::multiset<std::pair<int, int>> expected, found;  // -1: the floor
    for (int i = 0; i < static_cast<int>(scene.grains.size()); ++i)
    {
        for (int j = i + 1; j < static_cast<int>(scene.grains.size()); ++j)
        {
            const double distance = scene.box.nearestImage(scene.grains.position[i] - scene.grains.position[j]).norm();
            if (distance < scene.grains.radius[i] + scene.grains.radius[j] + 2*reach) expected.insert({i, j});
        }
        if (scene.grains.position[i][2] < scene.grains.radius[i] + reach) expected.insert({-1, i});
    }
    for (std::size_t slot : usedSlots(list))
    {
        const auto [a, b] = bodiesOf(list, slot);
        found.insert(std::minmax(list.grainOf[a], list.wall[slot] >= 0 ? -1 : list.grainOf[b]));
    }
    EXPECT_EQ(found, expected);
    EXPECT_GT(expected.size(), 200u);
}
