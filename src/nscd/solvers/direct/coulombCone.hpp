// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Coulomb's cone of admissible impulses: the nearest point of it, smoothed, and how that point moves.
#pragma once

#include "nscd/base/vec3.hpp"

namespace nscd
{

/// A point inside Coulomb's cone, and the symmetric derivative of -p by u that belongs to it.
struct ConePoint
{
    Vec3 impulse;                ///< p [N s]
    Eigen::Matrix3d stiffness;   ///< -dp/du [kg]
};

/// Impulse p of a stiff contact with relative velocity u: the smoothed projection of r - rho u on the cone.
/// Equation: with R = (mu r_n, r_t) and U = (u_n/mu, u_t) Coulomb's cone and its dual both become |x_t| <= x_0, where
///           R = rho f(R0/rho - U), f the function f(x) = (x + sqrt(x^2 + 4 eta^2))/2 of the two spectral values x_0 -+ |x_t|
///           (Fukushima, Luo & Tseng 2001, eq. 4.1): the proximal point of -(rho eta)^2 log, and of the cone itself as eta -> 0.
///           rho = penalty mu, so that the normal stiffness is penalty/mu. For mu = 0: p = rho f(r_n/rho - u_n) n, rho = penalty.
/// Shapes:   n a unit vector; r: multiplier [N s]; u [m/s]; penalty [kg]; smoothing eta > 0 [m/s]
ConePoint smoothedImpulse(const Vec3& r, const Vec3& u, const Vec3& n, double friction, double penalty, double smoothing);

} // namespace nscd
