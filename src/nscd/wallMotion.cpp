// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The usual motions of walls.
#include "wallMotion.hpp"

#include "invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

WallMotion translation(const Vec3& velocity)
{
    return translationBy([velocity](double time) { return Vec3(time*velocity); });
}

WallMotion translationBy(VectorOfTime displacement)
{
    return [displacement](double time)
    {
        WallPose pose = WallPose::Identity();
        pose.translation() = displacement(time);
        return pose;
    };
}

WallMotion rotation(const Vec3& point, const Vec3& axis, double omega)
{
    return rotationBy(point, axis, [omega](double time) { return omega*time; });
}

WallMotion rotationBy(const Vec3& point, const Vec3& axis, ScalarOfTime angle)
{
    if (!(axis.norm() > 0.0)) throw invalidValue("axis of a wall's rotation", axis.transpose(), "a vector that is not zero");
    return [point, unit = Vec3(axis.normalized()), angle](double time)
    {
        WallPose pose = WallPose::Identity();
        pose.linear() = Eigen::AngleAxisd(angle(time), unit).toRotationMatrix();
        pose.translation() = point - pose.linear()*point;
        return pose;
    };
}

WallMotion oscillation(const Vec3& amplitude, double frequency, double phase)
{
    if (!(frequency >= 0.0)) throw invalidValue("frequency of a wall's oscillation", frequency, ">= 0 Hz");
    return translationBy([=](double time) { return Vec3(std::sin(2.0*M_PI*frequency*time + phase)*amplitude); });
}

SurfaceMotion belt(const Vec3& velocity)
{
    return [velocity](double) { return Twist{velocity, Vec3::Zero(), Vec3::Zero()}; };
}

SurfaceMotion turningSurface(const Vec3& point, const Vec3& omega)
{
    return [point, omega](double) { return Twist{Vec3::Zero(), omega, point}; };
}

Vec3 displacement(const WallPose& now, const WallPose& next, const Vec3& x)
{
    const Vec3 material = now.linear().transpose()*(x - now.translation());
    return next*material - x;
}

double largestDisplacement(const WallPose& now, const WallPose& next, const Eigen::AlignedBox3d& box)
{
    if (box.isEmpty()) return 0.0;
    double largest2 = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
        const Vec3 x = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        largest2 = std::max(largest2, (next*x - now*x).squaredNorm());
    }
    return std::sqrt(largest2);
}

} // namespace nscd
