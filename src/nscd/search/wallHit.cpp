// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A sphere against faces, edges and vertices on its way.
#include "nscd/search/wallHit.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// When the sphere touches a plane that is `height` away and approached by `sinking`.
double timeAtPlane(double height, double sinking, double radius) { return height <= radius ? 0.0 : sinking > 0.0 ? (height - radius)/sinking : 2.0; }

void note(WallHit& first, const Way& way, double time, int region, const Vec3& normal, double distance)
{
    const double sinking = -(1.0 - time)*normal.dot(way.displacement);
    if (!(time < first.time) || time > 1.0 || !(sinking > 0.0)) return;
    if (way.radius - distance + sinking > way.allowance) first = {time, region, normal, distance};
}

/// A capsule around an edge, outside of which the way starts; its end is the start of another one.
void meetEdge(const WallEdge& edge, int number, const Way& way, WallHit& first)
{
    const Vec3 along = edge.end - edge.start, x = way.start - edge.start;
    const double length2 = along.squaredNorm();
    const double atVertex = timeToOrigin(x, way.displacement, way.radius);
    if (atVertex <= 1.0) note(first, way, atVertex, number, (x + atVertex*way.displacement).normalized(), way.radius);
    const auto across = [&](const Vec3& v) -> Vec3 { return v - v.dot(along)/length2*along; };
    const double atSide = timeToOrigin(across(x), across(way.displacement), way.radius);
    if (atSide > 1.0) return;
    const Vec3 there = x + atSide*way.displacement;
    const double share = there.dot(along)/length2;
    if (share >= 0.0 && share <= 1.0) note(first, way, atSide, number, across(there).normalized(), way.radius);
}

Eigen::AlignedBox3d around(const Way& way, double from, double to)
{
    Eigen::AlignedBox3d box(Vec3(way.start + from*way.displacement));
    box.extend(Vec3(way.start + to*way.displacement));
    const Vec3 margin = Vec3::Constant(way.radius);
    return {Vec3(box.min() - margin), Vec3(box.max() + margin)};
}

/// The part of a way on which its sphere may touch a box: from > to where there is none.
struct Part
{
    double from = 0.0;
    double to = 1.0;
};

Part partAt(const Eigen::AlignedBox3d& box, const Way& way)
{
    Part part;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double d = way.displacement[axis], low = box.min()[axis] - way.radius - way.start[axis], high = box.max()[axis] + way.radius - way.start[axis];
        if (d == 0.0)
        {
            if (low > 0.0 || high < 0.0) return {1.0, 0.0};
            continue;
        }
        part.from = std::max(part.from, std::min(low/d, high/d));
        part.to = std::min(part.to, std::max(low/d, high/d));
    }
    return part;
}

} // namespace

bool liesAlong(const WallRegion& region, int axis)
{
    constexpr double facing = 1e-3;   // as in contactGeometry: less than that is left of the normal
    return axis >= 0 && (region.normal - region.normal[axis]*Vec3::Unit(axis)).squaredNorm() < facing*facing;
}

double timeToOrigin(const Vec3& x, const Vec3& d, double radius)
{
    const double c = x.squaredNorm() - radius*radius, b = x.dot(d), a = d.squaredNorm(), discriminant = b*b - a*c;
    if (c <= 0.0 || b >= 0.0 || discriminant < 0.0) return 2.0;
    return c/(-b + std::sqrt(discriminant));
}

void meet(const WallRegion& region, int number, const Way& way, WallHit& first)
{
    const double signedHeight = region.normal.dot(way.start - region.point);
    if (!region.isTwoSided && signedHeight < backSide*way.radius) return;
    const double side = region.isTwoSided && signedHeight < 0.0 ? -1.0 : 1.0, height = side*signedHeight;
    const double sinking = -side*region.normal.dot(way.displacement), time = timeAtPlane(height, sinking, way.radius);
    if (!(time < first.time) || time > 1.0) return;
    if (height <= way.radius)
    {
        const WallProximity near = nearestPoint(region, way.start);
        if (near.distance <= way.radius)
        {
            note(first, way, 0.0, number, near.normal, near.distance);
            return;
        }
    }
    if (holdsFoot(region, way.start + time*way.displacement - side*(height - time*sinking)*region.normal))
    {
        note(first, way, time, number, side*region.normal, way.radius);
        return;
    }
    for (const WallEdge& edge : region.edges) meetEdge(edge, number, way, first);
}

WallHit firstHit(const Walls& walls, const WallSearch& search, int group, const Way& way, int emptyAxis)
{
    WallHit first;
    const Eigen::AlignedBox3d& bounds = search.outlined(group);
    const Part part = bounds.isEmpty() ? Part{1.0, 0.0} : partAt(bounds, way);
    if (part.from > part.to) return first;
    const double cells = (part.to - part.from)*way.displacement.norm()/search.cellWidth(group);
    const int stretches = std::max(1, static_cast<int>(std::ceil(cells)));
    std::vector<int> regions;
    const auto timeOf = [&](int k) { return part.from + (part.to - part.from)*k/stretches; };
    for (int k = 0; k < stretches && first.time > timeOf(k); ++k)
    {
        regions.clear();
        search.findInBox(group, around(way, timeOf(k), timeOf(k + 1)), regions);
        for (int region : regions)
        {
            if (!liesAlong(walls.regions[region], emptyAxis)) meet(walls.regions[region], region, way, first);
        }
    }
    return first;
}

} // namespace nscd
