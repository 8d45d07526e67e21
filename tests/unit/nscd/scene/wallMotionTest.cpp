// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Motions of walls: rigid, where their formula says, and their velocities against differences.
#include "nscd/scene/wallMotion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace nscd;

namespace
{

const Vec3 point(1, 2, 3), axis = Vec3(1, -1, 2), x(0.3, 5, -2);

} // namespace

TEST(WallMotion, translationsShiftAllPointsAlike)
{
    const WallPose pose = translation(Vec3(1, 2, 3))(0.5);
    EXPECT_LT((pose*x - x - Vec3(0.5, 1, 1.5)).norm(), 1e-15);
    const WallPose swung = oscillation(Vec3(0, 0, 0.1), 2.0, 0.3)(0.7);
    EXPECT_LT((swung*x - x - Vec3(0, 0, 0.1*std::sin(4*M_PI*0.7 + 0.3))).norm(), 1e-15);
    EXPECT_TRUE(swung.linear().isIdentity());
}

TEST(WallMotion, rotationsAreRigidAndHoldTheirAxis)
{
    const double omega = 4.0, time = 0.3, angle = omega*time;
    const WallPose pose = rotation(point, axis, omega)(time);
    EXPECT_LT((pose.linear().transpose()*pose.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((pose*Vec3(point + 7*axis) - point - 7*axis).norm(), 1e-13);
    // Rodrigues' formula.
    const Vec3 e = axis.normalized(), r = x - point;
    const Vec3 expected = point + std::cos(angle)*r + std::sin(angle)*e.cross(r) + (1 - std::cos(angle))*e.dot(r)*e;
    EXPECT_LT((pose*x - expected).norm(), 1e-13);
    EXPECT_LT((rotationBy(point, axis, [](double t) { return t*t; })(std::sqrt(angle))*x - expected).norm(), 1e-13);
    EXPECT_THROW(rotation(point, Vec3::Zero(), 1.0), std::invalid_argument);
    EXPECT_THROW(oscillation(Vec3::UnitX(), -1.0), std::invalid_argument);
}

TEST(WallMotion, displacementsOfAStepAreThoseOfTheMaterialPoint)
{
    const double omega = 4.0, time = 0.3, deltaT = 1e-6;
    const WallMotion motion = rotation(point, axis, omega);
    const Vec3 moved = displacement(motion(time - 0.5*deltaT), motion(time + 0.5*deltaT), x);
    const Twist twist = turningSurface(point, omega*axis.normalized())(time);
    EXPECT_LT((moved/deltaT - twist.at(x)).norm(), 1e-4*twist.at(x).norm());
    // A half turn takes a point to the other side of the axis.
    const WallMotion half = rotation(point, Vec3::UnitZ(), M_PI);
    EXPECT_LT((displacement(half(2.0), half(3.0), point + Vec3(1, 0, 0)) - Vec3(-2, 0, 0)).norm(), 1e-14);
    EXPECT_EQ(belt(Vec3(1, 0, 2))(5.0).at(x), Vec3(1, 0, 2));
}

TEST(WallMotion, theLargestDisplacementIsThatOfAnyPointOfABox)
{
    const Eigen::AlignedBox3d box(Vec3(-1, 0, 2), Vec3(3, 1, 2.5));
    const WallMotion motion = rotation(point, axis, 1.0);
    const WallPose now = motion(0.2), next = motion(0.9);
    double largest = 0.0;
    for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j)
    for (int k = 0; k <= 4; ++k)
    {
        const Vec3 inBox = box.min() + 0.25*Vec3(i, j, k).cwiseProduct(box.sizes());
        largest = std::max(largest, displacement(now, next, now*inBox).norm());
    }
    EXPECT_NEAR(largestDisplacement(now, next, box), largest, 1e-13);
    EXPECT_EQ(largestDisplacement(now, next, Eigen::AlignedBox3d()), 0.0);
}

TEST(WallMotion, speedsAreIntegrated)
{
    const ScalarOfTime ramp = integralOf([](double t) { return t < 0.3137 ? 2*t : 0.6274; });
    const ScalarOfTime sine = integralOf([](double t) { return std::sin(50*t); });
    const ScalarOfTime jump = integralOf([](double t) { return t < 0.5 ? 0.0 : 1.0; });
    const VectorOfTime constant = integralOf([](double) { return Vec3(1, 2, 3); });
    for (double t : {2.0, 0.7, 0.1, 0.3137, 0.0, -0.2})
    {
        EXPECT_NEAR(ramp(t), t < 0.3137 ? t*t : 0.3137*0.3137 + 0.6274*(t - 0.3137), 1e-12);
        EXPECT_NEAR(sine(t), (1 - std::cos(50*t))/50, 1e-12);
        EXPECT_NEAR(jump(t), std::max(0.0, t - 0.5), 1e-12);
        EXPECT_NEAR((constant(t) - t*Vec3(1, 2, 3)).norm(), 0, 1e-12);
    }
    // What was asked before does not matter to the bit.
    EXPECT_EQ(integralOf([](double t) { return std::sin(50*t); })(0.7), sine(0.7));
}

TEST(WallMotion, speedsThatOscillateTooFastAreRefused)
{
    const auto oscillation = [](double frequency) { return integralOf([=](double t) { return std::sin(2*M_PI*frequency*t); }); };
    EXPECT_NEAR(oscillation(2e4)(0.0125), 0, 1e-12);
    EXPECT_THROW(oscillation(1e20)(0.0125), std::invalid_argument);
}
