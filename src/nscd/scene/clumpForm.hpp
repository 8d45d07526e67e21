// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a fluid feels of a clump of spheres: volume, surface, and the area that it turns to a flow.
#pragma once

#include "nscd/scene/clumpShape.hpp"

namespace nscd
{

/// Of the union of the members: what they share counts once, what is inside another does not count.
struct ClumpForm
{
    double volume = 0.0;    ///< [m3]
    double surface = 0.0;   ///< [m2]; 0 of discs, which have none that a drag law knows

    /// d = (6 V/pi)^(1/3), of the sphere of the same volume [m].
    double equivalentDiameter() const;
    /// Surface of the sphere of the same volume over the clump's own (Wadell 1935, J. Geol. 43, 250); at most 1 [-].
    double sphericity() const;
};

/// The volume is that of makeClumpShape(), in 2D as there times the thickness.
ClumpForm formOf(const ClumpShape& clump, const GrainShape& shape);

/// Surface of a union of balls [m2].
/// Equation: sum_i R_i^2 int phi_i(c) dc, c from -1 to 1 the cosine of the angle to the z axis, phi_i the part of the circle of latitude on
///           ball i that is in no other ball [rad]
/// Ensures:  1e-10 of the surface, by Gauss-Legendre rules between the latitudes where caps begin and end, bisected until they agree
double surfaceOfBalls(const std::vector<Ball>& balls);

/// Area of the shadow that the members cast along a direction in the clump's own axes, however they hide each other [m2].
/// Errors: none; the direction may have any length but zero
double projectedArea(const std::vector<Ball>& members, const Vec3& direction);

} // namespace nscd
