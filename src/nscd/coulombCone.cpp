// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Euclidean projection on Coulomb's cone.
#include "coulombCone.hpp"

namespace nscd
{

ConePoint nearestInCone(const Vec3& z, const Vec3& n, double friction)
{
    const double zn = z.dot(n);
    const Vec3 zt = z - zn*n;
    const double tau = zt.norm();
    if (friction*tau <= -zn) return {Vec3::Zero(), Eigen::Matrix3d::Zero()};
    if (tau <= friction*zn) return {z, Eigen::Matrix3d::Identity()};
    if (friction == 0.0) return {zn*n, n*n.transpose()};

    const double rn = (zn + friction*tau)/(1.0 + friction*friction);
    const Vec3 t = zt/tau, edge = n + friction*t, across = n.cross(t);
    return
    {
        rn*edge,
        edge*edge.transpose()/(1.0 + friction*friction) + friction*rn/tau*across*across.transpose()
    };
}

} // namespace nscd
