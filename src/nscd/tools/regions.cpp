// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The regions.
#include "nscd/tools/regions.hpp"

#include "nscd/base/invalidValue.hpp"

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

} // namespace

Region boxRegion(const Vec3& lower, const Vec3& upper)
{
    const Eigen::AlignedBox3d box(lower, upper);
    return {box, [box](const Vec3& x) { return box.contains(x); }};
}

Region sphereRegion(const Vec3& center, double radius)
{
    const Vec3 reach = Vec3::Constant(radius);
    return {{center - reach, center + reach}, [=](const Vec3& x) { return (x - center).norm() <= radius; }};
}

Region cylinderRegion(const Vec3& start, const Vec3& end, double radius)
{
    const double length = (end - start).norm();
    const Vec3 axis = (end - start)/length;
    const Vec3 reach = radius*(1.0 - axis.array().square()).max(0.0).sqrt();
    const Eigen::AlignedBox3d bounds(start.cwiseMin(end) - reach, start.cwiseMax(end) + reach);
    return {bounds, [=](const Vec3& x)
    {
        const double along = axis.dot(x - start);
        return along >= 0.0 && along <= length && (x - start - along*axis).norm() <= radius;
    }};
}

Region surfaceRegion(std::vector<Triangle> triangles)
{
    if (!isClosed(triangles)) throw invalidValue("surface around a region", "open", "a closed one, all triangles turned the same way");
    Eigen::AlignedBox3d bounds;
    for (const Triangle& triangle : triangles)
    {
        for (const Vec3& vertex : triangle) bounds.extend(vertex);
    }
    return {bounds, [triangles = std::move(triangles)](const Vec3& x)
    {
        double half = 0.0;
        for (const Triangle& triangle : triangles) half += halfSolidAngle(triangle, x);
        return std::abs(half) > M_PI;
    }};
}

Region inPlane(Region region, int axis, double value)
{
    region.bounds.min()[axis] = region.bounds.max()[axis] = value;
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
