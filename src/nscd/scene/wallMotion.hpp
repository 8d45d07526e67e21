// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Motions of walls as functions of time.
#pragma once

#include "nscd/base/vec3.hpp"

#include <functional>

namespace nscd
{

/// A rigid displacement x = R X + t: of a wall, from where its geometry was given.
using WallPose = Eigen::Isometry3d;

/// Pose at a time [s], any function. The library takes velocities from the difference of poses over a step, so that a step may
/// turn a wall by a large angle; what it needs is a pose that depends on time alone, and so nothing of it is stored for restarts.
using WallMotion = std::function<WallPose(double time)>;

/// Velocity of a rigid body: v(x) = velocity + omega x (x - point).
struct Twist
{
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Vec3 omega = Vec3::Zero();     ///< [rad/s]
    Vec3 point = Vec3::Zero();     ///< [m]

    Vec3 at(const Vec3& x) const { return velocity + omega.cross(x - point); }
};

/// Velocity of a surface whose geometry stays, at a time [s].
using SurfaceMotion = std::function<Twist(double time)>;

/// Displacement [m] or angle [rad] as a function of time [s].
using VectorOfTime = std::function<Vec3(double time)>;
using ScalarOfTime = std::function<double(double time)>;

/// x = X + velocity t, or any displacement [m].
WallMotion translation(const Vec3& velocity);
WallMotion translationBy(VectorOfTime displacement);

/// Turns about the axis through a point, by omega t [rad/s] or by any angle [rad].
/// Errors: std::invalid_argument for an axis without length
WallMotion rotation(const Vec3& point, const Vec3& axis, double omega);
WallMotion rotationBy(const Vec3& point, const Vec3& axis, ScalarOfTime angle);

/// Integral from 0 to t of a speed: for walls whose speed is what is known, as rotationBy(point, axis, integralOf(omega)).
/// By adaptive Simpson quadrature, to about 1e-12 of the time and the speed, kinks and jumps included; what lies behind is kept, and the
/// result depends on t alone.
ScalarOfTime integralOf(ScalarOfTime speed);
VectorOfTime integralOf(VectorOfTime velocity);

/// x = X + amplitude sin(2 pi frequency t + phase), amplitude [m] with direction, frequency [Hz], phase [rad].
WallMotion oscillation(const Vec3& amplitude, double frequency, double phase = 0.0);

/// A belt of constant velocity, and a surface that turns in place.
SurfaceMotion belt(const Vec3& velocity);
SurfaceMotion turningSurface(const Vec3& point, const Vec3& omega);

/// Displacement over a step of the material point that is at `x` now [m].
Vec3 displacement(const WallPose& now, const WallPose& next, const Vec3& x);

/// Largest displacement of any material point within `box`, which is where it is at the identity pose [m].
/// The norm of an affine function is convex: the largest is at a corner.
double largestDisplacement(const WallPose& now, const WallPose& next, const Eigen::AlignedBox3d& box);

} // namespace nscd
