// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The implicit midpoint rule of Euler's equations.
#include "nscd/base/freeRotation.hpp"

namespace nscd
{

namespace
{

constexpr int maxIterations = 50;
constexpr double precision = 1e-15;

} // namespace

Vec3 midpointSpin(const Quaternion& orientation, const Eigen::Matrix3d& inertia, const Vec3& angularMomentum, double deltaT)
{
    const Vec3 before = orientation.conjugate()*angularMomentum;
    const Eigen::Matrix3d inverse = inertia.inverse();
    Vec3 omega = inverse*before;
    for (int k = 0; k < maxIterations; ++k)
    {
        const Vec3 after = rotationBy(-deltaT*omega)*before;
        const Vec3 defect = inverse*(0.5*(before + after)) - omega;
        if (defect.norm() <= precision*omega.norm()) break;
        // exp(-dt (w + x)) P = P' + dt P' x (to first order in dt w), where a radian a step leaves that nothing to say: plain iteration.
        const bool isSlow = deltaT*omega.norm() < 1.0;
        const Eigen::Matrix3d slope = Eigen::Matrix3d::Identity() - 0.5*deltaT*inverse*crossMatrix(after);
        omega += isSlow ? Vec3(slope.partialPivLu().solve(defect)) : defect;
    }
    return orientation*omega;
}

} // namespace nscd
