// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Parts of space that points are drawn from: boxes, spheres, cylinders, the inside of closed surfaces.
#pragma once

#include "nscd/scene/walls.hpp"
#include "nscd/tools/sceneParts.hpp"

namespace nscd
{

/// Where a point is to a side of a region, or to a wall.
struct SideProximity
{
    double distance;   ///< [m], negative beyond the side
    Vec3 inward;       ///< unit, from the side to the inside
};

struct RegionSide
{
    std::function<SideProximity(const Vec3&)> to;
    Vec3 flatNormal = Vec3::Zero();           ///< inward, unit; zero of a curved side
};

struct Region
{
    Eigen::AlignedBox3d bounds;               ///< around it [m]
    std::function<bool(const Vec3&)> holds;   ///< whether a point within the bounds is in the region
    double volume = 0.0;                      ///< [m3], in a plane its area [m2]
    std::vector<RegionSide> sides;            ///< all of them, but for those of a surface
    std::vector<Triangle> surface;            ///< around the inside of a closed surface
};

/// Between two opposite corners, the lower one first [m].
Region boxRegion(const Vec3& lower, const Vec3& upper);

Region sphereRegion(const Vec3& center, double radius);

/// Between two end points, up to a distance from the line through them [m].
Region cylinderRegion(const Vec3& start, const Vec3& end, double radius);

/// Inside a closed surface whose triangles all turn the same way.
/// Equation: a point is inside where the solid angles of the triangles add up to 4 pi, outside where to 0; triangle a, b, c seen from
///           the origin: tan(angle/2) = a.(b x c)/(|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|) (van Oosterom and Strackee 1983,
///           doi 10.1109/TBME.1983.325207)
/// Errors:   std::invalid_argument for a surface with an edge that no other triangle continues
Region surfaceRegion(std::vector<Triangle> triangles);

/// The part of a region in the plane where coordinate `axis` has a value [m]: for discs. Sides across the axis are left out; its area is that of a
/// box to round-off, of others to 1e-3.
Region inPlane(Region region, int axis, double value);

/// Of points drawn in the bounds, the share that lies in the region, from ten thousand of them.
double shareOfBounds(const Region& region);

/// Uniform over a region that is not empty, by rejection.
Vec3 randomPoint(const Region& region, const RandomNumbers& random);

} // namespace nscd
