// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The table of pairs of materials.
#include "nscd/scene/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace nscd;

namespace
{

Materials two()
{
    Materials materials;
    materials.add("glass");
    materials.add("steel");
    return materials;
}

} // namespace

TEST(Materials, pairsAreSymmetricAndStayWhenMaterialsAreAdded)
{
    Materials materials = two();
    materials.setPair(1, 0, {0.3, 0.9});
    const int wood = materials.add("wood");
    materials.setPair(wood, 0, {0.7, 0.1});
    EXPECT_EQ(materials.pair(0, 1).friction, 0.3);
    EXPECT_EQ(materials.pair(1, 0).restitution, 0.9);
    EXPECT_EQ(materials.pair(0, 2).friction, 0.7);
    EXPECT_EQ(materials.pair(1, 2).friction, 0.0);
    EXPECT_TRUE(materials.isPairSet(0, 1) && materials.isPairSet(2, 0));
    EXPECT_FALSE(materials.isPairSet(1, 2) || materials.isPairSet(0, 0));
    EXPECT_EQ(materials.find("wood"), 2);
    EXPECT_EQ(materials.find("lead"), -1);
}

TEST(Materials, tellWhatAnyPairHas)
{
    EXPECT_FALSE(two().anyFriction() || two().anyRestitution() || two().anyRolling() || two().anyCohesion());
    const auto with = [](const ContactPair& pair)
    {
        Materials materials = two();
        materials.setPair(1, 1, pair);
        return materials;
    };
    EXPECT_TRUE(with({0.1, 0.0}).anyFriction());
    EXPECT_TRUE(with({0.0, 0.1}).anyRestitution());
    EXPECT_TRUE(with({0.0, 0.0, 0.1, 0.0, 0.0, 0.0}).anyRolling());
    EXPECT_TRUE(with({0.0, 0.0, 0.0, 0.1, 0.0, 0.0}).anyRolling());
    EXPECT_TRUE(with({0.0, 0.0, 0.0, 0.0, 0.1, 0.0}).anyCohesion());
    EXPECT_EQ(with({0.0, 0.0, 0.0, 0.0, 0.1, 2e-3}).cohesionRange(), 2e-3);
    EXPECT_EQ(with({0.0, 0.0, 0.0, 0.0, 0.0, 2e-3}).cohesionRange(), 0.0);
}

TEST(Materials, whatCannotBeIsRefused)
{
    Materials materials = two();
    EXPECT_THROW(materials.add("glass"), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 2, {}), std::invalid_argument);
    EXPECT_THROW(materials.setPair(-1, 0, {}), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 0, {-0.1, 0.0}), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 0, {0.1, 1.1}), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 0, {0.1, NAN}), std::invalid_argument);
    EXPECT_THROW(materials.setPair(0, 0, {0.0, 0.0, 0.0, 0.0, INFINITY, 0.0}), std::invalid_argument);
    EXPECT_FALSE(materials.isPairSet(0, 0));
}
