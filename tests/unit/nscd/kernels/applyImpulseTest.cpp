// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What an impulse does to two bodies: momentum, and the change of the relative velocity by W.
#include "nscd/kernels/applyImpulse.hpp"

#include "nscd/base/vec3.hpp"

#include <gtest/gtest.h>

using namespace nscd;

namespace
{

const Vec3 n = Vec3(1, -2, 2)/3.0;

Vec3 relativeVelocity(const Body& a, const Body& b) { return Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(n); }

} // namespace

TEST(ApplyImpulse, changesTheVelocityInTheContactByTheDelassusOperator)
{
    const double massA = 2.0, massB = 3.0, kappa = 0.4;
    Body a{{1, 2, 3}, 1/massA, {0.1, 0.2, 0.3}, 1/(kappa*massA)}, b{{-1, 0, 4}, 1/massB, {0.5, -0.2, 0}, 1/(kappa*massB)};
    const Vec3 before = relativeVelocity(a, b), momentum = massA*Vec3(a.v) + massB*Vec3(b.v), p(0.3, -0.7, 1.1);
    applyImpulse(a, b, n.data(), p.data());
    const double wn = 1/massA + 1/massB, wt = wn + 1/(kappa*massA) + 1/(kappa*massB);
    const Vec3 normal = n.dot(p)*n;
    EXPECT_LT((relativeVelocity(a, b) - before - wn*normal - wt*(p - normal)).norm(), 1e-14);
    EXPECT_LT((massA*Vec3(a.v) + massB*Vec3(b.v) - momentum).norm(), 1e-14);
    EXPECT_LT((Vec3(a.v) - Vec3(1, 2, 3) - p/massA).norm(), 1e-15);
    EXPECT_LT((Vec3(a.s) - Vec3(0.1, 0.2, 0.3) + n.cross(p)/(kappa*massA)).norm(), 1e-15);
}

TEST(ApplyImpulse, leavesWhatHasNoMobilityAlone)
{
    Body a{{1, 2, 3}, 0.5, {0, 0, 0}, 1.0}, wall{{7, 8, 9}, 0.0, {1, 1, 1}, 0.0};
    const Vec3 p(1, 1, 1);
    applyImpulse(a, wall, n.data(), p.data());
    EXPECT_EQ(Vec3(wall.v), Vec3(7, 8, 9));
    EXPECT_EQ(Vec3(wall.s), Vec3(1, 1, 1));
}
