// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Wrapping and nearest images against all images.
#include "nscd/base/periodicBox.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace nscd;

namespace
{

PeriodicBox alongXAndZ()
{
    PeriodicBox box;
    box.lower = Vec3(-1, 0, 0.3);
    box.length = Vec3(2, 0, 0.7);
    return box;
}

} // namespace

TEST(PeriodicBox, wrapsByWholePeriodsAlongItsAxesAlone)
{
    const PeriodicBox box = alongXAndZ();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-10, 10);
    for (int k = 0; k < 500; ++k)
    {
        const Vec3 x(uniform(random), uniform(random), uniform(random)), wrapped = box.wrap(x);
        EXPECT_EQ(wrapped[1], x[1]);
        for (int axis : {0, 2})
        {
            EXPECT_GE(wrapped[axis], box.lower[axis]);
            EXPECT_LT(wrapped[axis], box.lower[axis] + box.length[axis]);
            const double periods = (x[axis] - wrapped[axis])/box.length[axis];
            EXPECT_NEAR(periods, std::round(periods), 1e-13);
        }
        EXPECT_EQ(box.wrap(wrapped), wrapped);
    }
}

TEST(PeriodicBox, keepsWhatRoundsToItsUpperEndInside)
{
    const PeriodicBox box = alongXAndZ();
    const double justBelow = std::nextafter(-1.0, -2.0);
    EXPECT_LT(box.wrap(Vec3(justBelow, 0, 0.5))[0], 1.0);
    EXPECT_EQ(box.wrap(Vec3(1.0, 0, 0.5))[0], -1.0);
}

TEST(PeriodicBox, nearestImagesAreTheShortestOfAll)
{
    const PeriodicBox box = alongXAndZ();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-2, 2);
    for (int k = 0; k < 500; ++k)
    {
        const Vec3 dx(uniform(random), uniform(random), uniform(random));
        double shortest = dx.norm();
        for (int i = -2; i <= 2; ++i)
        for (int m = -4; m <= 4; ++m) shortest = std::min(shortest, (dx + Vec3(2*i, 0, 0.7*m)).norm());
        EXPECT_NEAR(box.nearestImage(dx).norm(), shortest, 1e-14);
    }
}

TEST(PeriodicBox, withoutPeriodsChangesNothing)
{
    const Vec3 x(1e9, -3, 0);
    EXPECT_FALSE(PeriodicBox().any());
    EXPECT_TRUE(alongXAndZ().any());
    EXPECT_EQ(PeriodicBox().wrap(x), x);
    EXPECT_EQ(PeriodicBox().nearestImage(x), x);
}
