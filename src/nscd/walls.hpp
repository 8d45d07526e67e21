// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls: infinite planes and planar regions bounded by straight edges, seen from the side of the grains.
#pragma once

#include "vec3.hpp"

#include <string>
#include <vector>

namespace nscd
{

/// One straight piece of the outline of a planar region; the region lies to its left seen from the tip of the normal.
struct WallEdge
{
    Vec3 start;
    Vec3 end;
};

/// A flat wall. Without edges it is an infinite plane.
struct WallRegion
{
    Vec3 point;                   ///< any point of the plane [m]
    Vec3 normal;                  ///< unit, pointing into the domain, towards the grains
    std::vector<WallEdge> edges;  ///< outline, any shape, holes allowed; empty: infinite plane
    int patch = 0;                ///< index into Walls::patches
};

/// A named group of regions that share a material; forces are reported per patch.
struct WallPatch
{
    std::string name;
    int material = 0;
};

struct Walls
{
    std::vector<WallPatch> patches;
    std::vector<WallRegion> regions;

    /// Adds a patch and returns its index.
    int addPatch(const std::string& name, int material);
    /// Adds an infinite plane through `point`; `normal` points to the grains and need not be of unit length.
    void addPlane(int patch, const Vec3& point, const Vec3& normal);
    /// Adds a planar polygon with vertices counter-clockwise seen from the side of the grains.
    void addPolygon(int patch, const std::vector<Vec3>& vertices);
};

/// The point of a region nearest to a sphere's center.
struct WallProximity
{
    Vec3 point;        ///< nearest point of the region
    Vec3 normal;       ///< unit, from that point to the center
    double distance;   ///< signed for a point inside the outline (negative: center behind the wall), else positive
    bool isInside;     ///< the projection of the center lies inside the outline
};

WallProximity nearestPoint(const WallRegion& region, const Vec3& center);

/// Axis-aligned bounds of a finite region.
/// Errors: std::invalid_argument for an infinite plane
Eigen::AlignedBox3d bounds(const WallRegion& region);

} // namespace nscd
