// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Coulomb's cone of admissible impulses: the nearest point of it, and how that moves.
#pragma once

#include "vec3.hpp"

namespace nscd
{

/// Point of the cone r_n >= 0, |r_t| <= mu r_n nearest to z, and the symmetric derivative of that point by z.
struct ConePoint
{
    Vec3 point;
    Eigen::Matrix3d derivative;
};

/// With tau = |z_t|: z where tau <= mu z_n; 0 where mu tau <= -z_n; else r_n = (z_n + mu tau)/(1 + mu^2), r_t = mu r_n z_t/tau.
/// Errors: none; n must be a unit vector, mu >= 0 and finite
ConePoint nearestInCone(const Vec3& z, const Vec3& n, double friction);

} // namespace nscd
