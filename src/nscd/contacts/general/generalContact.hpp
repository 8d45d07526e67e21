// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One contact of bodies of any shape: Coulomb's law with a full Delassus operator.
#pragma once

#include "nscd/base/vec3.hpp"

namespace nscd
{

/// The local problem of one contact, all others held: u = W r + u_free.
struct GeneralContact
{
    Eigen::Matrix3d w;         ///< W, symmetric and positive definite [1/kg]
    Eigen::Matrix3d inverse;   ///< of W [kg]
    Vec3 n;                    ///< unit
    double bias;               ///< b [m/s]
    double friction;           ///< mu
};

/// Impulse r with 0 <= r_n, 0 <= u_n + b, r_n (u_n + b) = 0; |r_t| <= mu r_n, and if u_t is not 0, r_t = -mu r_n u_t/|u_t| [N s].
/// Exact, case by case: open where u_free does not close; sticking, r = -W^-1 (u_free + b n), where that lies in the cone; else sliding with
/// r = r_n (n + mu t), t a unit tangent that solves one equation of its angle (in effect the quartic of Bonnefon & Daviet 2011):
/// Newton's method from the sticking direction, and where it fails the sign changes over the whole circle. Of several solutions, which
/// large friction off the center allows, the one nearest to where Newton's method starts.
Vec3 solveCoulomb(const GeneralContact& contact, const Vec3& freeVelocity);

/// A step towards the impulse with |r_t| <= tau, whatever presses (Tresca's law), from r and u = W r + u_free. The contact's `friction` is tau [N s].
/// The normal part with the tangential held, then that with the normal held: p_t = P(r_t - u_t/(tr W - W_nn)), P the projection on |p_t| <= tau. It
/// makes r.W r/2 + r.(u_free + b n) smaller unless r solves the contact, as no eigenvalue of the tangential part of W exceeds its trace.
Vec3 approachTresca(const GeneralContact& contact, const Vec3& r, const Vec3& u);

} // namespace nscd
