// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The convex problem of a direct solve: its minimum, and the impulses that multipliers lead to.
#include "nscd/solvers/direct/convexContact.hpp"

#include <gtest/gtest.h>

using namespace nscd;

namespace
{

constexpr int grains = 4;
constexpr double kappa = 0.4;
const Vec3 up = Vec3::UnitZ();

/// Unit masses on top of one another that fall on a floor at unit speed, and drift along it.
ConvexContact fallingStack(double friction, const Vec3& drift)
{
    std::vector<ConeContact> contacts;
    for (int i = 0; i < grains; ++i)
    {
        contacts.push_back({static_cast<std::size_t>(i), {i, i - 1}, up, Vec3::Zero(), 0.0, friction, 5.0, Vec3::Zero(), 0.0, Vec3::Zero()});
    }
    Eigen::VectorXd motion(6*grains), mass(6*grains);
    for (int i = 0; i < grains; ++i)
    {
        motion.segment<3>(6*i) = drift - up;
        motion.segment<3>(6*i + 3).setZero();
        mass.segment<3>(6*i).setOnes();
        mass.segment<3>(6*i + 3).setConstant(kappa);
    }
    return ConvexContact(contacts, motion, mass, {0, 1, 2, 3, 4, 5});
}

/// The proximal method of multipliers around the convex problem.
Eigen::VectorXd solve(ConvexContact& convex)
{
    Eigen::VectorXd x = convex.motion();
    for (int round = 0; round < 60; ++round)
    {
        convex.minimize(x, 1e-13, 1e-3, 1e-12);
        for (ConeContact& c : convex.contacts())
        {
            const Vec3 u = convex.relativeVelocity(c, x);
            c.multiplier = c.impulse;
            c.slip = (u - u.dot(c.n)*c.n).norm();
        }
    }
    return x;
}

} // namespace

TEST(ConvexContact, atItsMinimumMotionIsWhatItsImpulsesMake)
{
    for (double friction : {0.0, 0.3})
    {
        ConvexContact convex = fallingStack(friction, Vec3(0.5, 0.2, 0));
        Eigen::VectorXd x = convex.motion();
        EXPECT_GT(convex.minimize(x, 1e-12, 1e-2, 1e-6), 0);
        EXPECT_LT((x - convex.motion()).norm(), 1e-11);
        for (const ConeContact& c : convex.contacts()) EXPECT_GT(c.impulse.dot(up), 0.0);
    }
}

TEST(ConvexContact, multipliersStopAStack)
{
    ConvexContact convex = fallingStack(0.0, Vec3::Zero());
    const Eigen::VectorXd x = solve(convex);
    EXPECT_LT(x.norm(), 1e-6);
    for (int i = 0; i < grains; ++i) EXPECT_NEAR(convex.contacts()[i].impulse.dot(up), grains - i, 1e-6);
}

/// Below the lowest grain mu times the weight; what is above slides along with the same velocity.
TEST(ConvexContact, frictionSlowsDownAsCoulombSays)
{
    const double friction = 0.1;
    ConvexContact convex = fallingStack(friction, Vec3(2, 0, 0));
    const Eigen::VectorXd x = solve(convex);
    const Vec3 below = convex.contacts()[0].impulse;
    EXPECT_NEAR(below.dot(up), grains, 1e-5);
    EXPECT_NEAR(below[0], -friction*grains, 1e-5);
    double momentum = 0.0;
    for (int i = 0; i < grains; ++i) momentum += x[6*i];
    EXPECT_NEAR(momentum, 2.0*grains - friction*grains, 1e-5);
}

TEST(ConvexContact, relativeVelocityIsThatOfTheTwoSurfaces)
{
    const ConvexContact convex = fallingStack(0.3, Vec3::Zero());
    Eigen::VectorXd x = Eigen::VectorXd::Zero(6*grains);
    x.segment<3>(6) = Vec3(1, 2, 3);        // grain 1
    x.segment<3>(9) = Vec3(0, 0.5, 0);      // its R omega
    x.segment<3>(0) = Vec3(0, 0, 1);
    EXPECT_LT((convex.relativeVelocity(convex.contacts()[1], x) - (Vec3(1, 2, 2) + up.cross(Vec3(0, 0.5, 0)))).norm(), 1e-15);
    EXPECT_EQ(convex.relativeVelocity(convex.contacts()[0], x), Vec3(0, 0, 1));
}
