// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Shape, mass and inertia of clumps of one kind.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/scene/unionMoments.hpp"

#include <vector>

namespace nscd
{

struct GrainShape;

/// What clumps of one kind have in common. Axes are those the members were given in, the origin is the mass center.
struct ClumpShape
{
    std::vector<Ball> members;
    double mass = 0.0;                                    ///< [kg]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();    ///< about the mass center [kg m2]; of discs J times the identity
    Vec3 massCenter = Vec3::Zero();                       ///< in the coordinates the members were given in [m]
};

/// A clump of the same material everywhere, whose mass, mass center and inertia are those of the union of its members: members that overlap
/// count once. In closed form where none do, else see unionMoments.hpp: J = rho int (|x|^2 I - x x^T) dV.
/// 2D: discs in a plane normal to a coordinate axis, J of the turn about that axis.
/// Units:  members [m], any origin; density [kg/m3]
/// Errors: std::invalid_argument for no members, values that are not finite or positive, discs that are not in one plane
ClumpShape makeClumpShape(std::vector<Ball> members, double density, const GrainShape& shape);

/// The same with mass [kg], mass center (in the coordinates of the members) [m] and inertia about it [kg m2] as given.
/// Errors: std::invalid_argument, as above, and for an inertia that is not symmetric and positive definite, or that no body has (a principal
///         moment larger than the sum of the others); in 2D one that is not a number times the identity
ClumpShape makeClumpShape
(
    std::vector<Ball> members, double mass, const Vec3& massCenter, const Eigen::Matrix3d& inertia, const GrainShape& shape
);

} // namespace nscd
