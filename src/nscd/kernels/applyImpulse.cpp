// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Plain code: for contacts that are visited one by one.
#include "nscd/kernels/applyImpulse.hpp"

namespace nscd
{

void applyImpulse(Body& a, Body& b, const double n[3], const double delta[3])
{
    const double moment[3] =
    {
        n[1]*delta[2] - n[2]*delta[1],
        n[2]*delta[0] - n[0]*delta[2],
        n[0]*delta[1] - n[1]*delta[0]
    };
    for (int k = 0; k < 3; ++k)
    {
        a.v[k] += a.invMass*delta[k];
        b.v[k] -= b.invMass*delta[k];
        a.s[k] -= a.invSpin*moment[k];
        b.s[k] -= b.invSpin*moment[k];
    }
}

Vec3 relativeVelocity(const Body& a, const Body& b, const Vec3& n)
{
    return Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(n);
}

} // namespace nscd
