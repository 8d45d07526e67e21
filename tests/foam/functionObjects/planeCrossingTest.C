// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of crossing(): each way once, and through periodic sides.
#include "functionObjects/planeCrossing.H"

#include <gtest/gtest.h>

using namespace Foam::nscdCoupling;

namespace
{

const nscd::PeriodicBox closed;
const nscd::PeriodicBox periodic{Vec3(0, 0, 0), Vec3(0, 0, 1)};

Plane level(double z) { return {Vec3(5, 5, z), Vec3(0, 0, 3)}; }

int across(double z, const Vec3& from, const Vec3& to, const nscd::PeriodicBox& box = periodic)
{
    return crossing(level(z), from, to, box);
}

} // namespace

TEST(PlaneCrossing, hasTheSignOfTheNormal)
{
    EXPECT_EQ(across(0.5, Vec3(0, 0, 0.4), Vec3(0, 0, 0.6), closed), 1);
    EXPECT_EQ(across(0.5, Vec3(0, 0, 0.6), Vec3(0, 0, 0.4), closed), -1);
    EXPECT_EQ(across(0.5, Vec3(0, 0, 0.6), Vec3(0, 0, 0.9), closed), 0);
    const Plane slanted{Vec3(0, 0, 0), Vec3(1, 1, 0)};
    EXPECT_EQ(crossing(slanted, Vec3(-1, 0.9, 0), Vec3(-0.8, 0.9, 7), closed), 1);
}

TEST(PlaneCrossing, countsAWayThatEndsOnThePlaneOnce)
{
    const Vec3 below(0, 0, 0.4), on(0, 0, 0.5), above(0, 0, 0.6);
    EXPECT_EQ(across(0.5, below, on, closed) + across(0.5, on, above, closed), 1);
    EXPECT_EQ(across(0.5, below, on, closed) + across(0.5, on, below, closed), 0);
}

TEST(PlaneCrossing, followsTheWayThroughAPeriodicSide)
{
    const Vec3 low(0, 0, 0.05), high(0, 0, 0.95);
    EXPECT_EQ(across(0.5, high, low), 0);
    EXPECT_EQ(across(0.98, high, low), 1);
    EXPECT_EQ(across(0.02, high, low), 1);
    EXPECT_EQ(across(0.98, low, high), -1);
    EXPECT_EQ(across(0.02, low, high), -1);
    for (const double side : {0.0, 1.0}) EXPECT_EQ(across(side, high, low), 1) << side;
}

TEST(PlaneCrossing, countsAPlaneAlongThePeriodOnce)
{
    const Plane upright{Vec3(0, 0, 0), Vec3(1, 0, 0)};
    EXPECT_EQ(crossing(upright, Vec3(-0.1, 0, 0.95), Vec3(0.1, 0, 0.05), periodic), 1);
}
