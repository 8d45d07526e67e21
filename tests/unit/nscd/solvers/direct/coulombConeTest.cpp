// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The smoothed projection on Coulomb's cone against differences, and against the cone itself.
#include "nscd/solvers/direct/coulombCone.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace nscd;

namespace
{

std::mt19937 engine(5);

Vec3 randomVector()
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const double x = unit(engine), y = unit(engine), z = unit(engine);
    return Vec3(x, y, z);
}

/// Nearest point of the cone |p_t| <= p_n, by cases.
Vec3 projected(const Vec3& r, const Vec3& n)
{
    const double rn = r.dot(n), rt = (r - rn*n).norm();
    if (rt <= rn) return r;
    if (rt <= -rn) return Vec3::Zero();
    return 0.5*(rn + rt)*(n + (r - rn*n)/rt);
}

} // namespace

TEST(CoulombCone, impulsesAreAdmissibleAndMoveAsTheirDerivativeSays)
{
    for (double friction : {0.0, 0.01, 0.5, 5.0})
    {
        for (int k = 0; k < 200; ++k)
        {
            const Vec3 n = randomVector().normalized(), r = randomVector(), u = randomVector(), du = 1e-6*randomVector();
            const auto at = [&](const Vec3& velocity) { return smoothedImpulse(r, velocity, n, friction, 2.0, 0.1); };
            const ConePoint point = at(u);
            const double pn = point.impulse.dot(n), pt = (point.impulse - pn*n).norm();
            EXPECT_GT(pn, 0.0);
            EXPECT_LE(pt, friction*pn*(1 + 1e-9) + 1e-12);
            const Vec3 change = 0.5*(at(u + du).impulse - at(u - du).impulse);
            EXPECT_LT((change + point.stiffness*du).norm(), 1e-6*(1 + 1/std::max(0.01, friction))*1e-3 + 1e-6*change.norm());
        }
    }
}

TEST(CoulombCone, withoutSmoothingAndPenaltyOnlyComplementarityIsLeft)
{
    // A closed sticking contact keeps its multiplier; one that parts has none; one that slides holds mu r_n against u_t.
    const Vec3 n = Vec3::UnitZ(), r(0.1, 0, 1);
    EXPECT_LT((smoothedImpulse(r, Vec3::Zero(), n, 0.5, 1e3, 1e-9).impulse - r).norm(), 1e-6);
    EXPECT_LT(smoothedImpulse(Vec3::Zero(), Vec3(0, 0, 1), n, 0.5, 1e3, 1e-9).impulse.norm(), 1e-6);
    const Vec3 sliding = smoothedImpulse(Vec3(-0.5, 0, 1), Vec3(1e-6, 0, 0.5e-6), n, 0.5, 1e3, 1e-9).impulse;
    EXPECT_LT((sliding - Vec3(-0.5, 0, 1)).norm(), 1e-2);
}

/// For mu = 1 the cone is its own dual, and nothing is scaled.
TEST(CoulombCone, withoutSmoothingItIsTheNearestPointOfTheCone)
{
    const double smoothing = 1e-10;
    for (int k = 0; k < 300; ++k)
    {
        const Vec3 n = randomVector().normalized(), r = randomVector();
        const Vec3 p = smoothedImpulse(r, Vec3::Zero(), n, 1.0, 1.0, smoothing).impulse;
        EXPECT_LT((p - projected(r, n)).norm(), 1e-8);
        EXPECT_LT((smoothedImpulse(p, Vec3::Zero(), n, 1.0, 1.0, smoothing).impulse - p).norm(), 1e-8);
        const Vec3 u = randomVector();
        EXPECT_LT((smoothedImpulse(r, u, n, 1.0, 2.0, smoothing).impulse - projected(r - 2*u, n)).norm(), 1e-8);
    }
}

TEST(CoulombCone, aStickingContactIsAsStiffAsItsPenaltySays)
{
    const double friction = 0.5, penalty = 2.0, smoothing = 1e-10;
    const Vec3 n = Vec3::UnitZ();
    const Eigen::Matrix3d stiffness = smoothedImpulse(n, Vec3::Zero(), n, friction, penalty, smoothing).stiffness;
    EXPECT_LT((stiffness - Eigen::Matrix3d(Vec3(penalty*friction, penalty*friction, penalty/friction).asDiagonal())).norm(), 1e-8);
    const Eigen::Matrix3d smooth = smoothedImpulse(n, Vec3::Zero(), n, 0.0, penalty, smoothing).stiffness;
    EXPECT_LT((smooth - penalty*n*n.transpose()).norm(), 1e-8);
}
