// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls: infinite planes, planar regions bounded by straight edges, and triangulated surfaces; at rest, moving, or belts.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/scene/wallMotion.hpp"

#include <array>
#include <string>
#include <vector>

namespace nscd
{

using Triangle = std::array<Vec3, 3>;

/// Whether grains meet a wall on the side its normal points to, or on both.
enum class WallSides { one, both };

/// One straight piece of the outline of a planar region; the region lies to its left seen from the tip of the normal.
struct WallEdge
{
    Vec3 start;
    Vec3 end;
};

/// A flat wall. Without edges it is an infinite plane. Where its patch moves, this is where it is at the patch's reference pose.
struct WallRegion
{
    Vec3 point;                   ///< any point of the plane [m]
    Vec3 normal;                  ///< unit, pointing into the domain, towards the grains
    std::vector<WallEdge> edges;  ///< outline, any shape, holes allowed; empty: infinite plane
    int patch = 0;                ///< index into Walls::patches
    bool isTwoSided = false;      ///< normal and distance are those of the side that the center is on
};

/// A named group of regions that share a material and a motion; forces and torques are reported per patch.
struct WallPatch
{
    WallPatch() = default;
    WallPatch(const std::string& nameOfPatch, int materialOfPatch) : name(nameOfPatch), material(materialOfPatch) {}

    std::string name;
    int material = 0;
    WallMotion motion;                    ///< empty: the patch stays where it is
    SurfaceMotion surfaceMotion;          ///< empty: the surface moves as the patch does
    Vec3 torquePoint = Vec3::Zero();      ///< that the reported torque is about, fixed in space [m]
    WallPose pose = WallPose::Identity(); ///< at the present time; see moveWalls()

    bool hasVelocity() const { return motion || surfaceMotion; }
};

struct Walls
{
    std::vector<WallPatch> patches;
    std::vector<WallRegion> regions;

    /// Adds a patch and returns its index, for what follows; other ones are refused with std::invalid_argument.
    int addPatch(const std::string& name, int material);
    /// Adds an infinite plane through `point`; `normal` points to the grains and need not be of unit length.
    void addPlane(int patch, const Vec3& point, const Vec3& normal, WallSides sides = WallSides::one);
    /// Adds a planar polygon with vertices counter-clockwise seen from the side of the grains.
    void addPolygon(int patch, const std::vector<Vec3>& vertices);
    /// Adds a triangulated surface, one region a triangle. Triangles that are slivers to round-off (height below 1e-12 of their
    /// longest side) are left out: their sides belong to their neighbors. Returns how many were.
    /// Errors: std::invalid_argument where no triangle is left, or a vertex is not finite
    std::size_t addTriangles(int patch, const std::vector<Triangle>& triangles, WallSides sides = WallSides::both);

    /// Lets a patch move as a rigid body, from the places of its regions at the identity pose.
    void setMotion(int patch, WallMotion motion) { patches[patch].motion = std::move(motion); }
    /// Lets the surface of a patch move in its own plane while its geometry stays, as a belt: the part of the velocity along
    /// the normal is left out.
    void setSurfaceMotion(int patch, SurfaceMotion motion) { patches[patch].surfaceMotion = std::move(motion); }

    bool anyMotion() const;
};

/// A wall of one side whose plane lies further behind the center than this share of the radius is seen from its back: no contact.
constexpr double backSide = -0.5;

/// The point of a region nearest to a sphere's center.
struct WallProximity
{
    Vec3 point;        ///< nearest point of the region
    Vec3 normal;       ///< unit, from that point to the center
    double distance;   ///< signed for a point inside the outline (negative: center behind a wall of one side), else positive
    bool isInside;     ///< the projection of the center lies inside the outline
};

/// Whether a point of a region's plane lies within its outline.
bool holdsFoot(const WallRegion& region, const Vec3& point);

/// At the reference pose.
WallProximity nearestPoint(const WallRegion& region, const Vec3& center);

/// At the present pose of the region's patch.
WallProximity nearestPoint(const Walls& walls, int region, const Vec3& center);

/// Pose of a patch at a time [s]; where it is now if it does not move.
/// Errors: std::invalid_argument for a motion that gives what is not a finite rigid displacement, naming the patch
WallPose poseAt(const WallPatch& patch, double time);

/// Sets all patches' poses to those at a time [s].
/// Errors: as poseAt()
void moveWalls(Walls& walls, double time);

/// Axis-aligned bounds of a finite region at its reference pose.
/// Errors: std::invalid_argument for an infinite plane
Eigen::AlignedBox3d bounds(const WallRegion& region);

/// The box around a box that has moved by a pose.
Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const WallPose& pose);

} // namespace nscd
