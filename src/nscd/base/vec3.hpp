// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Small vectors and quaternions of the grain library: Eigen's, under the names used here.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace nscd
{

using Vec3 = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

/// The matrix X of X y = x cross y.
inline Eigen::Matrix3d crossMatrix(const Vec3& x)
{
    Eigen::Matrix3d m;
    m << 0.0, -x[2], x[1], x[2], 0.0, -x[0], -x[1], x[0], 0.0;
    return m;
}

} // namespace nscd
