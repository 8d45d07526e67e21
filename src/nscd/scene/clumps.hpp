// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps: rigid assemblies of spheres or discs.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/scene/clumpShape.hpp"

#include <cstdint>
#include <vector>

namespace nscd
{

struct Grains;
struct PeriodicBox;

/// The clumps of a scene. Their members are grains like others for the contact search and in all that is written, in a row each,
/// in the order of the shape; they move with their clump. Orientation turns the shape's axes to those of the world.
struct Clumps
{
    /// On several ranks the same list on all of them, whatever clumps each has.
    std::vector<ClumpShape> shapes;

    // Per clump.
    std::vector<int> shape;
    std::vector<int> firstMember;         ///< index of a grain
    std::vector<Vec3> position;           ///< of the mass center [m]
    std::vector<Quaternion> orientation;
    std::vector<Vec3> velocity;           ///< [m/s]
    std::vector<Vec3> angularMomentum;    ///< about the mass center, world frame [kg m2/s]

    std::size_t size() const { return shape.size(); }
    bool empty() const { return shape.empty(); }
    const ClumpShape& shapeOf(std::size_t clump) const { return shapes[shape[clump]]; }
};

/// Where a clump starts, and how.
struct ClumpPlacement
{
    int shape = 0;                                       ///< index into Clumps::shapes
    Vec3 position = Vec3::Zero();                        ///< of the mass center [m]
    Quaternion orientation = Quaternion::Identity();     ///< any length but zero
    Vec3 velocity = Vec3::Zero();                        ///< [m/s]
    Vec3 omega = Vec3::Zero();                           ///< world frame [rad/s]
    int material = 0;
    std::int64_t firstId = 0;                            ///< of the first member; the others follow
};

/// Appends a clump and its members. Returns its index.
/// Errors: std::invalid_argument for a shape that is not there, values that are not finite
std::size_t addClump(Grains& grains, const ClumpPlacement& placement, const PeriodicBox& box);

/// Puts the members of a clump where it is, with its velocities: for whoever changes a clump between steps.
void placeMembers(Grains& grains, std::size_t clump, const PeriodicBox& box);

/// Angular velocity J^-1 L [rad/s] and inertia R J R^T [kg m2] in the world frame, at the present orientation.
Vec3 angularVelocity(const Clumps& clumps, std::size_t clump);
Eigen::Matrix3d worldInertia(const Clumps& clumps, std::size_t clump);

/// m v^2/2 + omega.L/2 of a clump [J].
double kineticEnergy(const Clumps& clumps, std::size_t clump);

/// Clump of each grain, -1 of single ones; empty where there are no clumps.
std::vector<int> clumpOfGrains(const Grains& grains);

/// Errors: std::invalid_argument for clumps whose members are not there, are not where they should be, are held or belong to two clumps; for values
///         that are not finite; and for a period that is not longer than twice the extent of a clump, which could meet its own image
void checkClumps(const Grains& grains, const PeriodicBox& box);

} // namespace nscd
