// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Volume and its moments of a union of balls or discs, however they overlap.
#pragma once

#include "nscd/base/vec3.hpp"

#include <vector>

namespace nscd
{

struct Ball
{
    Vec3 center;      ///< [m]
    double radius;    ///< [m]
};

/// Integrals over a body: of 1, x and x x^T.
struct VolumeMoments
{
    double volume = 0.0;                                  ///< [m3]; of discs the area [m2]
    Vec3 first = Vec3::Zero();                            ///< [m4]; [m3]
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();     ///< [m5]; [m4]
};

/// Union of balls. Planes of constant z cut discs, whose union is integrated exactly, along its boundary; over z by Gauss-Legendre rules
/// of 10 points between the ends of balls, each piece bisected until two halves and the whole agree to 1e-12 of the union's moments, at
/// most 30 times. With x = a + (b - a)(3 s^2 - 2 s^3) on a piece [a, b], so that roots at its ends do no harm.
/// Errors: none; a ball inside another adds nothing
VolumeMoments unionOfBalls(const std::vector<Ball>& balls);

/// Union of discs in the plane z = 0 (z of their centers is not looked at): by Green's theorem along the arcs of its boundary, to round-off.
VolumeMoments unionOfDiscs(const std::vector<Ball>& discs);

} // namespace nscd
