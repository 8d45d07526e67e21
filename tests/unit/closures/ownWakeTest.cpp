// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The own wake: Oseen's flow, its limits when fields are smoothed, what inertia and others leave of it.
#include "closures/ownWake.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

const double pi = std::acos(-1.0);

} // namespace

TEST(OwnWake, inCellsFarOffIsOseens)
{
    const Matrix3d flow = closures::flowInOtherCell(Vector3d(0, 0, 200), 1, 0);
    EXPECT_NEAR(flow(2, 2)/(2/(8*pi*200)), 1, 1e-12);
    EXPECT_NEAR(flow(0, 0)/(1/(8*pi*200)), 1, 1e-12);
    EXPECT_EQ((flow - Matrix3d(flow.diagonal().asDiagonal())).norm(), 0);
    // Any direction: the flow of a force f at r is (f + r (r f)/r^2)/(8 pi r).
    const Vector3d r(100, -200, 50), f(0.3, 0.1, -2);
    const Vector3d expected = (f + r*r.dot(f)/r.squaredNorm())/(8*pi*r.norm());
    EXPECT_LT((closures::flowInOtherCell(r, 1, 0)*f - expected).norm(), 1e-12*expected.norm());
}

/// What was measured with grains between two cells: 0.0951/h along the force, 0.0438/h across it.
TEST(OwnWake, inCellsThatTouchIsAsMeasured)
{
    const Matrix3d flow = closures::flowInOtherCell(Vector3d(0, 2, 0), 2, 0);
    EXPECT_NEAR(flow(1, 1), 0.0951/2, 1e-5);
    EXPECT_NEAR(flow(0, 0), 0.0438/2, 2e-5);
}

TEST(OwnWake, inOneCellFallsWithItsSide)
{
    EXPECT_NEAR(closures::flowInOwnCell(8, 0), 0.1235/2, 1e-15);
    EXPECT_NEAR(closures::flowInOwnCell(1, 0)/closures::flowInOwnCell(64, 0), 4, 1e-14);
    EXPECT_EQ(closures::wakeInFraction(0), 1);
    EXPECT_NEAR(closures::wakeInFraction(0.5), 1.045, 1e-15);
}

/// Spread over many cells by smoothing, it does not matter any more in which cell a force is.
TEST(OwnWake, ofSmoothedFieldsForgetsTheCells)
{
    const double area = 9, side = 0.01;
    const double inside = closures::flowInOwnCell(side*side*side, area);
    EXPECT_NEAR(inside/(0.020403/3), 1, 1e-5);
    const double here = closures::flowInOtherCell(Vector3d(1e-4, 1e-4, 1e-4), side, area).trace()/3;
    EXPECT_NEAR(here/inside, 1, 1e-5);
    EXPECT_NEAR(closures::flowInOtherCell(Vector3d(300, 0, 0), side, area)(0, 0)/(2/(8*pi*300)), 1, 1e-3);
}

TEST(OwnWake, isLessWithInertiaAndSoonerWithFlow)
{
    EXPECT_EQ(closures::wakeInertia(0), 1);
    EXPECT_NEAR(closures::wakeInertia(1e4)*2001.10, 1, 1e-7);
    EXPECT_NEAR(1/closures::wakeInertia(0.05), 1 + 0.01 + 0.05, 1e-14);
    EXPECT_NEAR(closures::wakeTime(1e-3, 1000, 2e-3, 0), 1, 1e-14);
    EXPECT_NEAR(closures::wakeTime(1e-12, 1000, 2e-3, 0.1), 0.02, 1e-9);
}

TEST(OwnWake, isThatOfLoneGrains)
{
    EXPECT_EQ(closures::loneliness(-0.001), 1);
    EXPECT_EQ(closures::loneliness(0.001), 1);
    EXPECT_NEAR(closures::loneliness(0.0055), 0.5, 1e-14);
    EXPECT_EQ(closures::loneliness(0.01), 0);
    EXPECT_EQ(closures::loneliness(0.6), 0);
}

TEST(OwnWake, isThatOfAParcelUnlessItIsOfManyGrains)
{
    EXPECT_EQ(closures::wakeOfParcel(0.3), 1);
    EXPECT_EQ(closures::wakeOfParcel(5), 1);
    EXPECT_NEAR(closures::wakeOfParcel(7.5), 0.5, 1e-14);
    EXPECT_EQ(closures::wakeOfParcel(10), 0);
    EXPECT_EQ(closures::wakeOfParcel(500), 0);
}
