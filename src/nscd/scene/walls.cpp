// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nearest points on flat walls.
#include "nscd/scene/walls.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <limits>

namespace nscd
{

namespace
{

/// Whether a point of the region's plane lies inside its outline: its winding number is not zero.
bool isInsideOutline(const WallRegion& region, const Vec3& point)
{
    // Crossing test along a ray in the plane; the ray's side vector is perpendicular to it within the plane.
    int axis;
    region.normal.cwiseAbs().minCoeff(&axis);
    const Vec3 ray = region.normal.cross(Vec3::Unit(axis)).normalized();
    const Vec3 side = region.normal.cross(ray);

    int winding = 0;
    for (const WallEdge& edge : region.edges)
    {
        const double h0 = side.dot(edge.start - point);
        const double h1 = side.dot(edge.end - point);
        if ((h0 <= 0.0) == (h1 <= 0.0)) continue;
        const double t = h0/(h0 - h1);
        const double along = ray.dot(edge.start + t*(edge.end - edge.start) - point);
        if (along > 0.0) winding += h0 <= 0.0 ? 1 : -1;
    }
    return winding != 0;
}

Vec3 nearestOnEdge(const WallEdge& edge, const Vec3& point)
{
    const Vec3 direction = edge.end - edge.start;
    const double t = direction.dot(point - edge.start)/direction.squaredNorm();
    return edge.start + std::min(1.0, std::max(0.0, t))*direction;
}

/// A triangle whose normal is round-off.
bool isSliver(const Triangle& t)
{
    const double longest2 = std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
    return !((t[1] - t[0]).cross(t[2] - t[0]).norm() > 1e-12*longest2);
}

void checkPatch(const Walls& walls, int patch)
{
    if (patch < 0 || patch >= static_cast<int>(walls.patches.size())) throw invalidValue("wall patch", patch, "an index of addPatch()");
}

} // namespace

int Walls::addPatch(const std::string& name, int material)
{
    patches.emplace_back(name, material);
    return static_cast<int>(patches.size()) - 1;
}

void Walls::addPlane(int patch, const Vec3& point, const Vec3& normal, WallSides sides)
{
    checkPatch(*this, patch);
    if (!point.allFinite()) throw invalidValue("point of a wall", point.transpose(), "finite coordinates [m]");
    if (!(normal.norm() > 0.0) || !normal.allFinite()) throw invalidValue("wall normal", normal.transpose(), "a finite vector that is not zero");
    regions.push_back({point, normal.normalized(), {}, patch, sides == WallSides::both});
}

void Walls::addPolygon(int patch, const std::vector<Vec3>& vertices)
{
    checkPatch(*this, patch);
    if (vertices.size() < 3) throw invalidValue("wall polygon's number of vertices", vertices.size(), ">= 3");
    Vec3 areaVector = Vec3::Zero();
    std::vector<WallEdge> edges;
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
        const Vec3& next = vertices[(k + 1) % vertices.size()];
        areaVector += 0.5*(vertices[k] - vertices[0]).cross(next - vertices[0]);
        edges.push_back({vertices[k], next});
    }
    if (!(areaVector.norm() > 0.0) || !areaVector.allFinite()) throw invalidValue("wall polygon's area", areaVector.norm(), "> 0 m2");
    regions.push_back({vertices[0], areaVector.normalized(), edges, patch, false});
}

std::size_t Walls::addTriangles(int patch, const std::vector<Triangle>& triangles, WallSides sides)
{
    checkPatch(*this, patch);
    std::size_t leftOut = 0;
    regions.reserve(regions.size() + triangles.size());
    for (const Triangle& t : triangles)
    {
        if (!t[0].allFinite() || !t[1].allFinite() || !t[2].allFinite())
        {
            throw invalidValue("vertex of a triangle of wall " + patches[patch].name, "not finite", "finite coordinates");
        }
        if (isSliver(t))
        {
            ++leftOut;
            continue;
        }
        const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
        regions.push_back({t[0], normal, {{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}, patch, sides == WallSides::both});
    }
    if (leftOut == triangles.size())
    {
        throw invalidValue("number of triangles with an area of wall " + patches[patch].name, 0, "> 0");
    }
    return leftOut;
}

bool Walls::anyMotion() const
{
    return std::any_of(patches.begin(), patches.end(), [](const WallPatch& patch) { return patch.hasVelocity(); });
}

bool holdsFoot(const WallRegion& region, const Vec3& point) { return region.edges.empty() || isInsideOutline(region, point); }

WallProximity nearestPoint(const WallRegion& region, const Vec3& center)
{
    const double height = region.normal.dot(center - region.point);
    const Vec3 foot = center - height*region.normal;
    if (holdsFoot(region, foot))
    {
        if (region.isTwoSided && height < 0.0) return {foot, -region.normal, -height, true};
        return {foot, region.normal, height, true};
    }

    Vec3 nearest = foot;
    double nearest2 = std::numeric_limits<double>::max();
    for (const WallEdge& edge : region.edges)
    {
        const Vec3 candidate = nearestOnEdge(edge, center);
        const double distance2 = (center - candidate).squaredNorm();
        if (distance2 < nearest2)
        {
            nearest2 = distance2;
            nearest = candidate;
        }
    }
    const double distance = std::sqrt(nearest2);
    const Vec3 normal = distance > 0.0 ? Vec3((center - nearest)/distance) : region.normal;
    return {nearest, normal, distance, false};
}

WallProximity nearestPoint(const Walls& walls, int region, const Vec3& center)
{
    const WallPatch& patch = walls.patches[walls.regions[region].patch];
    if (!patch.motion) return nearestPoint(walls.regions[region], center);
    const WallPose& pose = patch.pose;
    const WallProximity near = nearestPoint(walls.regions[region], pose.linear().transpose()*(center - pose.translation()));
    return {pose*near.point, pose.linear()*near.normal, near.distance, near.isInside};
}

WallPose poseAt(const WallPatch& patch, double time)
{
    if (!patch.motion) return patch.pose;
    const WallPose pose = patch.motion(time);
    const double distortion = (pose.linear()*pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm();
    if (!pose.translation().allFinite() || !(distortion < 1e-9) || pose.linear().determinant() < 0.0)
    {
        throw invalidValue
        (
            "motion of wall " + patch.name + " at time " + std::to_string(time), "no finite rigid displacement",
            "a finite translation and a rotation"
        );
    }
    return pose;
}

void moveWalls(Walls& walls, double time)
{
    for (WallPatch& patch : walls.patches) patch.pose = poseAt(patch, time);
}

Eigen::AlignedBox3d bounds(const WallRegion& region)
{
    if (region.edges.empty()) throw invalidValue("wall region", "an infinite plane", "a region with edges");
    Eigen::AlignedBox3d box;
    for (const WallEdge& edge : region.edges)
    {
        box.extend(edge.start);
        box.extend(edge.end);
    }
    return box;
}

Eigen::AlignedBox3d moved(const Eigen::AlignedBox3d& box, const WallPose& pose)
{
    Eigen::AlignedBox3d result;
    if (box.isEmpty()) return result;
    for (int corner = 0; corner < 8; ++corner) result.extend(pose*box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    return result;
}

} // namespace nscd
