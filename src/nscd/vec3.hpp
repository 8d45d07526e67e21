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

} // namespace nscd
