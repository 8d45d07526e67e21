// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The regions.
#include "nscd/tools/regions.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace nscd
{

namespace
{

/// Times every directed edge occurs, less the times the reverse one does; all zero for a closed surface.
bool isClosed(const std::vector<Triangle>& triangles)
{
    using Point = std::array<double, 3>;
    std::map<std::pair<Point, Point>, int> surplus;
    const auto pointOf = [](const Vec3& x) { return Point{x[0], x[1], x[2]}; };
    for (const Triangle& triangle : triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            const Point a = pointOf(triangle[k]), b = pointOf(triangle[(k + 1) % 3]);
            if (a < b) ++surplus[{a, b}];
            if (b < a) --surplus[{b, a}];
        }
    }
    for (const auto& edge : surplus)
    {
        if (edge.second != 0) return false;
    }
    return true;
}

double halfSolidAngle(const Triangle& triangle, const Vec3& x)
{
    const Vec3 a = triangle[0] - x, b = triangle[1] - x, c = triangle[2] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return std::atan2(a.dot(b.cross(c)), la*lb*lc + a.dot(b)*lc + b.dot(c)*la + c.dot(a)*lb);
}

Vec3 pointIn(const Eigen::AlignedBox3d& box, const RandomNumbers& random)
{
    const double x = random(), y = random(), z = random();
    return box.min() + Vec3(x, y, z).cwiseProduct(box.sizes());
}

RegionSide flatSide(const Vec3& point, const Vec3& inward)
{
    return {[=](const Vec3& x) { return SideProximity{inward.dot(x - point), inward}; }, inward};
}

/// Of a point on the axis or in the center the direction does not matter.
Vec3 towards(const Vec3& x) { return x.norm() > 0.0 ? Vec3(-x.normalized()) : Vec3::UnitX(); }

/// A sixth of the sum of a.(b x c) over the triangles.
double volumeWithin(const std::vector<Triangle>& triangles, const Vec3& origin)
{
    double sixfold = 0.0;
    for (const Triangle& t : triangles) sixfold += (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin));
    return std::abs(sixfold)/6.0;
}

/// Area of a region in a plane, from the middles of a million equal parts of its bounds.
double areaOf(const Region& region, int axis)
{
    constexpr int parts = 1000;
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const Vec3 part = region.bounds.sizes()/parts;
    std::int64_t inside = 0;
    for (int i = 0; i < parts; ++i)
    {
        for (int j = 0; j < parts; ++j)
        {
            Vec3 x = region.bounds.min();
            x[a] += (i + 0.5)*part[a];
            x[b] += (j + 0.5)*part[b];
            inside += region.holds(x);
        }
    }
    return double(inside)*part[a]*part[b];
}

} // namespace

Region boxRegion(const Vec3& lower, const Vec3& upper)
{
    const Eigen::AlignedBox3d box(lower, upper);
    Region region{box, [box](const Vec3& x) { return box.contains(x); }, box.volume(), {}, {}};
    for (int k = 0; k < 3; ++k)
    {
        region.sides.push_back(flatSide(lower, Vec3::Unit(k)));
        region.sides.push_back(flatSide(upper, -Vec3::Unit(k)));
    }
    return region;
}

Region sphereRegion(const Vec3& center, double radius)
{
    const Vec3 reach = Vec3::Constant(radius);
    const RegionSide side{[=](const Vec3& x) { return SideProximity{radius - (x - center).norm(), towards(x - center)}; }};
    return {{center - reach, center + reach}, [=](const Vec3& x) { return (x - center).norm() <= radius; }, 4.0/3.0*M_PI*radius*radius*radius, {side}, {}};
}

Region cylinderRegion(const Vec3& start, const Vec3& end, double radius)
{
    const double length = (end - start).norm();
    const Vec3 axis = (end - start)/length;
    const Vec3 reach = radius*(1.0 - axis.array().square()).max(0.0).sqrt();
    const Eigen::AlignedBox3d bounds(start.cwiseMin(end) - reach, start.cwiseMax(end) + reach);
    const auto fromAxis = [=](const Vec3& x) { return Vec3(x - start - axis.dot(x - start)*axis); };
    const RegionSide mantle{[=](const Vec3& x) { return SideProximity{radius - fromAxis(x).norm(), towards(fromAxis(x))}; }};
    const auto holds = [=](const Vec3& x)
    {
        const double along = axis.dot(x - start);
        return along >= 0.0 && along <= length && fromAxis(x).norm() <= radius;
    };
    return {bounds, holds, M_PI*radius*radius*length, {mantle, flatSide(start, axis), flatSide(end, -axis)}, {}};
}

Region surfaceRegion(std::vector<Triangle> triangles)
{
    if (!isClosed(triangles)) throw invalidValue("surface around a region", "open", "a closed one, all triangles turned the same way");
    Eigen::AlignedBox3d bounds;
    for (const Triangle& triangle : triangles)
    {
        for (const Vec3& vertex : triangle) bounds.extend(vertex);
    }
    const auto holds = [triangles](const Vec3& x)
    {
        double half = 0.0;
        for (const Triangle& triangle : triangles) half += halfSolidAngle(triangle, x);
        return std::abs(half) > M_PI;
    };
    const double volume = volumeWithin(triangles, bounds.min());
    return {bounds, holds, volume, {}, std::move(triangles)};
}

Region inPlane(Region region, int axis, double value)
{
    region.bounds.min()[axis] = region.bounds.max()[axis] = value;
    const auto isAcross = [axis](const RegionSide& side) { return std::abs(side.flatNormal[axis]) > 1.0 - 1e-9; };
    region.sides.erase(std::remove_if(region.sides.begin(), region.sides.end(), isAcross), region.sides.end());
    region.volume = areaOf(region, axis);
    return region;
}

double shareOfBounds(const Region& region)
{
    constexpr int points = 10000;
    const RandomNumbers random = randomNumbers(1);
    int inside = 0;
    for (int k = 0; k < points; ++k) inside += region.holds(pointIn(region.bounds, random));
    return inside/double(points);
}

Vec3 randomPoint(const Region& region, const RandomNumbers& random)
{
    Vec3 x = pointIn(region.bounds, random);
    while (!region.holds(x)) x = pointIn(region.bounds, random);
    return x;
}

} // namespace nscd
