// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The turn that a free rigid body makes in a step.
#pragma once

#include "nscd/base/vec3.hpp"

namespace nscd
{

/// exp(turn/2) as a quaternion: a rotation by |turn| about it. The series are exact to round-off where they are used.
inline Quaternion rotationBy(const Vec3& turn)
{
    const double h = 0.25*turn.squaredNorm();  // square of half the angle
    if (h > 2.5e-3) return Quaternion(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    const double cosine = 1.0 - h/2.0*(1.0 - h/12.0*(1.0 - h/30.0*(1.0 - h/56.0)));
    const double sine = 0.5*(1.0 - h/6.0*(1.0 - h/20.0*(1.0 - h/42.0*(1.0 - h/72.0))));
    return Quaternion(cosine, sine*turn[0], sine*turn[1], sine*turn[2]);
}

/// Angular velocity w [rad/s], world frame, with which a body of angular momentum L [kg m2/s] turns in a step: q <- exp(w dt) q.
/// It holds the gyroscopic force -w x J w (Henry 2025, eq. 2.7) as the implicit midpoint rule does: in the body's axes, with
///     P = q^-1 L,  P' = exp(-w dt) P:   J w = (P + P')/2.
/// Then P' = q'^-1 L, so that L stays as it is; and P'.J^-1 P' - P.J^-1 P = 2 w.(P' - P) = 0, since w is the axis of the turn: energy
/// stays too. Both to round-off at any dt, orientation to second order (Simo & Wong 1991, Int. J. Numer. Meth. Eng. 31, 19; Lewis & Simo 1994).
/// Solved to 1e-15 |w|, or as far as 50 iterations come where a body turns by a radian a step and more: |L| stays in any case.
/// `inertia`: J in the body's axes [kg m2]
Vec3 midpointSpin(const Quaternion& orientation, const Eigen::Matrix3d& inertia, const Vec3& angularMomentum, double deltaT);

} // namespace nscd
