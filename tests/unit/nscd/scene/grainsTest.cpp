// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Arrays of grains, and sums over them.
#include "nscd/scene/grains.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace nscd;

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Two spheres that move and turn, and a held one.
Grains three()
{
    Grains grains;
    for (int i = 0; i < 3; ++i) grains.add(Vec3(i, 2*i, 0), 0.1*(i + 1), 1000.0, 0, 40 + i);
    grains.velocity[0] = Vec3(3, 0, 4);
    grains.omega[1] = Vec3(0, 0, 10);
    grains.isFixed[2] = 1;
    return grains;
}

} // namespace

TEST(Grains, haveVolumeAndMassOfTheirShape)
{
    Grains grains = three();
    EXPECT_DOUBLE_EQ(grains.mass[1], 1000.0*4.0/3.0*pi*0.008);
    EXPECT_DOUBLE_EQ(totalVolume(grains), 4.0/3.0*pi*(0.001 + 0.008 + 0.027));
    Grains discs;
    discs.shape.dimensions = 2;
    discs.shape.thickness = 0.5;
    discs.add(Vec3::Zero(), 0.2, 1000.0, 0, 0);
    EXPECT_DOUBLE_EQ(discs.mass[0], 1000.0*pi*0.04*0.5);
    EXPECT_DOUBLE_EQ(discs.shape.inertiaFactor(), 0.5);
    EXPECT_DOUBLE_EQ(grains.shape.inertiaFactor(), 0.4);
}

TEST(Grains, sumsAreThoseOfOwnGrains)
{
    Grains grains = three();
    const double m = grains.mass[0];
    EXPECT_LT((massCenter(grains) - (8*Vec3(1, 2, 0) + 27*Vec3(2, 4, 0))/36).norm(), 1e-15);
    EXPECT_NEAR(kineticEnergy(grains), 0.5*m*25 + 0.5*0.4*8*m*0.04*100, 1e-12);
    EXPECT_DOUBLE_EQ(massExtremes(grains)[0], 8*m);   // the held one does not count
    EXPECT_DOUBLE_EQ(massExtremes(grains)[1], 1/m);
    EXPECT_TRUE(bodyOfGrains(grains).empty());
    grains.nOwned = 1;
    EXPECT_DOUBLE_EQ(totalVolume(grains), 4.0/3.0*pi*0.001);
    EXPECT_EQ(massCenter(grains), Vec3::Zero());
    EXPECT_EQ(massCenter(Grains()), Vec3::Zero());
}

TEST(Grains, theListOfArraysNamesEachOnceAndHasThemAll)
{
    Grains grains = three();
    std::set<std::string> names;
    std::size_t bytes = 0;
    Grains::forEachMember([&](const char* name, auto array)
    {
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ((grains.*array).size(), 3u) << name;
        bytes += sizeof(grains.*array);
    });
    // What a grain has and the list does not would not be copied, sent or stored.
    EXPECT_EQ(bytes, sizeof(Grains) - sizeof(GrainShape) - sizeof(std::size_t) - sizeof(Clumps));
    grains.reserve(100);
    grains.forEachArray([](auto& values) { EXPECT_GE(values.capacity(), 100u); });
    grains.shrinkToFit();
    grains.forEachArray([](auto& values) { EXPECT_EQ(values.capacity(), 3u); });
}

TEST(Grains, whatCannotBeIsRefused)
{
    Grains grains;
    EXPECT_THROW(grains.add(Vec3(0, NAN, 0), 0.1, 1000, 0, 0), std::invalid_argument);
    EXPECT_THROW(grains.add(Vec3::Zero(), 0.0, 1000, 0, 0), std::invalid_argument);
    EXPECT_THROW(grains.add(Vec3::Zero(), 0.1, -1, 0, 0), std::invalid_argument);
    EXPECT_THROW(grains.add(Vec3::Zero(), 0.1, INFINITY, 0, 0), std::invalid_argument);
    EXPECT_EQ(grains.size(), 0u);
}
