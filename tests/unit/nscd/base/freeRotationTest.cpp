// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free rotation against the closed form of a symmetric top, and what a free body keeps.
#include "nscd/base/freeRotation.hpp"

#include <gtest/gtest.h>

using namespace nscd;

namespace
{

struct Top
{
    Eigen::Matrix3d inertia;
    Quaternion orientation = Quaternion(1, 0.2, 0.1, -0.4).normalized();
    Vec3 angularMomentum = Vec3(0.3, -1.1, 0.7);

    explicit Top(const Vec3& principal) : inertia(principal.asDiagonal()) {}

    Vec3 spin(double deltaT) const { return midpointSpin(orientation, inertia, angularMomentum, deltaT); }
    void step(double deltaT) { orientation = (rotationBy(deltaT*spin(deltaT))*orientation).normalized(); }

    /// L.J^-1 L/2.
    double energy() const
    {
        const Vec3 inBody = orientation.conjugate()*angularMomentum;
        return 0.5*inBody.dot(inertia.inverse()*inBody);
    }
};

/// Error [rad] after a time of a top whose first two moments of inertia are the same: it turns about L by |L|/J_1, and in itself about its axis e by
/// (1/J_3 - 1/J_1) L.e.
double precessionError(int steps)
{
    const double time = 3.0, transverse = 1.0, axial = 1.7;
    Top top(Vec3(transverse, transverse, axial));
    const double along = (top.orientation*Vec3::UnitZ()).dot(top.angularMomentum);
    const Quaternion exact = rotationBy(time/transverse*top.angularMomentum)*top.orientation
        *rotationBy(time*(1/axial - 1/transverse)*along*Vec3::UnitZ());
    for (int k = 0; k < steps; ++k) top.step(time/steps);
    return top.orientation.angularDistance(exact);
}

} // namespace

TEST(FreeRotation, turnsAreThoseOfAnAxisAndAnAngleAcrossTheSeries)
{
    const Vec3 axis = Vec3(1, -2, 0.5).normalized();
    for (double angle : {0.0, 1e-9, 1e-3, 0.03, 0.0999, 0.1001, 1.0, 3.0, 7.0})
    {
        const Quaternion expected(Eigen::AngleAxisd(angle, axis));
        EXPECT_LT((rotationBy(angle*axis).coeffs() - expected.coeffs()).norm(), 2e-16*(1 + angle) + 1e-16) << angle;
    }
}

TEST(FreeRotation, aBodyOnAPrincipalAxisTurnsByItsMomentumOverItsInertia)
{
    Top top(Vec3(1.0, 2.0, 2.8));
    top.angularMomentum = top.orientation*Vec3(0, 3, 0);
    for (double deltaT : {1e-3, 0.1, 2.0}) EXPECT_LT((top.spin(deltaT) - top.orientation*Vec3(0, 1.5, 0)).norm(), 1e-14) << deltaT;
}

TEST(FreeRotation, keepsEnergyAtAnyStep)
{
    for (double deltaT : {0.01, 0.3, 0.8})
    {
        Top top(Vec3(1.0, 2.0, 2.8));
        const double before = top.energy();
        for (int k = 0; k < 1000; ++k) top.step(deltaT);
        EXPECT_NEAR(top.energy(), before, 1e-12*before) << deltaT;
    }
}

TEST(FreeRotation, followsASymmetricTopToSecondOrder)
{
    const double coarse = precessionError(50), fine = precessionError(100);
    EXPECT_GT(coarse, 1e-5);
    EXPECT_NEAR(coarse/fine, 4.0, 0.05);
}
