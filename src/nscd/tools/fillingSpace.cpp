// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking up sides and walls.
#include "nscd/tools/fillingSpace.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

Walls withSurface(Walls walls, const Region& region)
{
    if (!region.surface.empty()) walls.addTriangles(walls.addPatch("the region's surface", 0), region.surface);
    return walls;
}

PeriodicBox around(PeriodicBox box, const Eigen::AlignedBox3d& bounds)
{
    for (int k = 0; k < 3; ++k)
    {
        if (box.isPeriodic(k)) box.lower[k] = bounds.center()[k] - 0.5*box.length[k];
    }
    return box;
}

} // namespace

FillingSpace::FillingSpace(const Region& region, const FillingPlace& place, double largestDiameter)
:
    region_(region),
    walls_(withSurface(place.walls, region)),
    sceneBox_(place.box),
    box_(around(place.box, region.bounds)),
    emptyAxis_(place.shape.emptyAxis),
    midPlane_(place.midPlane),
    search_(walls_, largestDiameter)
{
    for (int k = 0; k < 3; ++k)
    {
        if (!box_.isPeriodic(k) || region.bounds.sizes()[k] < box_.length[k]*(1.0 - 1e-9)) continue;
        auto& sides = region_.sides;
        sides.erase(std::remove_if(sides.begin(), sides.end(), [&](const RegionSide& side) { return isAcross(side.flatNormal, k); }), sides.end());
    }
    for (std::size_t k = 0; k < walls_.regions.size(); ++k)
    {
        if (walls_.regions[k].edges.empty()) planes_.push_back(static_cast<int>(k));
    }
}

Vec3 FillingSpace::inScene(const Vec3& x) const
{
    Vec3 here = sceneBox_.wrap(x);
    if (emptyAxis_ >= 0) here[emptyAxis_] = midPlane_;
    return here;
}

void FillingSpace::findNear(const Vec3& x, double distance, std::vector<int>& obstacles) const
{
    const int nSides = static_cast<int>(region_.sides.size());
    for (int side = 0; side < nSides; ++side)
    {
        if (region_.sides[side].to(x).distance < distance) obstacles.push_back(side);
    }
    const Vec3 here = inScene(x);
    near_.clear();
    search_.find(here, distance, near_);
    for (const int plane : planes_)
    {
        if (nearestPoint(walls_, plane, here).distance < distance) near_.push_back(plane);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    for (const int wall : near_)
    {
        if (!isAcross(walls_.regions[wall].normal, emptyAxis_)) obstacles.push_back(nSides + wall);
    }
}

/// A bounded wall has two sides to grains that are put somewhere.
SideProximity FillingSpace::to(int obstacle, const Vec3& x) const
{
    const int nSides = static_cast<int>(region_.sides.size());
    if (obstacle < nSides) return region_.sides[obstacle].to(x);
    const int wall = obstacle - nSides;
    const WallProximity near = nearestPoint(walls_, wall, inScene(x));
    if (near.distance >= 0.0 || walls_.regions[wall].edges.empty()) return {near.distance, near.normal};
    return {-near.distance, -near.normal};
}

bool FillingSpace::isClear(const Vec3& x, double distance) const
{
    std::vector<int> obstacles;
    findNear(x, distance, obstacles);
    return std::none_of(obstacles.begin(), obstacles.end(), [&](int obstacle) { return to(obstacle, x).distance < distance; });
}

} // namespace nscd
