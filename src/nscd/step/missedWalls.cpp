// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looked at where grains are, one by one: few of them fly so fast and so near a wall.
#include "nscd/step/missedWalls.hpp"

#include "nscd/search/wallHit.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

bool seesOnlyNear(const ContactList& list, const WallsOfStep& walls, int body)
{
    return !walls.reachToMany.empty() && std::isfinite(walls.reachToMany[list.grainOf[body]]);
}

/// How far a grain that is `way` from where it is may have got, in a step, towards walls since these were looked for.
double wayFromBuild(const ContactList& list, const std::vector<GroupMotion>& motions, int body, const Vec3& way)
{
    double ofWalls = 0.0;
    for (const GroupMotion& motion : motions) ofWalls = std::max(ofWalls, motion.wayFromBuild);
    return (list.position[body] + way - list.positionAtBuild[body]).norm() + ofWalls;
}

/// Outlined regions of a group whose bounds are within a distance of a place in its frame, each once.
std::vector<int> regionsAbout(const WallsOfStep& walls, int group, const Vec3& center, double distance)
{
    std::vector<int> regions;
    const Vec3 margin = Vec3::Constant(distance);
    walls.search.findInBox(group, {Vec3(center - margin), Vec3(center + margin)}, regions);
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    return regions;
}

bool isAnyNear(const WallsOfStep& walls, const std::vector<GroupMotion>& motions, const Vec3& x, double distance)
{
    return std::any_of(motions.begin(), motions.end(), [&](const GroupMotion& motion)
    {
        return walls.search.hasMany(motion.group) && !regionsAbout(walls, motion.group, motion.after(x), distance).empty();
    });
}

struct NearWall
{
    WallGap gap;
    bool isByFace;   ///< not by an edge or a vertex, which belongs to its neighbors too
};

/// Walls about a body at x, the nearest first.
std::vector<NearWall> wallsAbout(const WallsOfStep& walls, const std::vector<GroupMotion>& motions, int body, const Vec3& x, double radius)
{
    std::vector<NearWall> found;
    for (const GroupMotion& motion : motions)
    {
        const Vec3 center = motion.after(x);
        for (int number : regionsAbout(walls, motion.group, center, (1.0 + deepestInWalls)*radius))
        {
            const WallRegion& region = walls.scene.walls.regions[number];
            if (liesAlong(region, walls.scene.grains.shape.emptyAxis)) continue;
            const WallProximity near = nearestPoint(region, center);
            if (near.isInside && near.distance < backSide*radius) continue;
            if (near.distance < (1.0 + deepestInWalls)*radius) found.push_back({{body, motion.turned(near.normal), near.distance - radius}, near.isInside});
        }
    }
    std::sort(found.begin(), found.end(), [](const NearWall& a, const NearWall& b) { return a.gap.gap < b.gap.gap; });
    return found;
}

} // namespace

bool mayMissWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<GroupMotion>& motions, int body, const Vec3& way)
{
    return seesOnlyNear(list, walls, body) && wayFromBuild(list, motions, body, way) > deepestInWalls*list.radius[body];
}

std::vector<int> bodiesAtMissedWalls(const ContactList& list, const WallsOfStep& walls)
{
    std::vector<int> bodies;
    if (walls.reachToMany.empty()) return bodies;
    const std::vector<GroupMotion> motions = motionsOf(list, walls);
    for (int body = 0; body < list.owned(); ++body)
    {
        if (!mayMissWalls(list, walls, motions, body, Vec3::Zero())) continue;
        if (isAnyNear(walls, motions, walls.scene.box.wrap(list.position[body]), list.radius[body] + walls.reachAtRest)) bodies.push_back(body);
    }
    return bodies;
}

std::vector<WallGap> gapsToMissedWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies)
{
    std::vector<WallGap> gaps;
    if (bodies.empty()) return gaps;
    const std::vector<GroupMotion> motions = motionsOf(list, walls);
    const int emptyAxis = walls.scene.grains.shape.emptyAxis;
    for (int body : bodies)
    {
        const std::vector<NearWall> near = wallsAbout(walls, motions, body, walls.scene.box.wrap(list.position[body]), list.radius[body]);
        for (std::size_t k = 0; k < near.size(); ++k)
        {
            if (k > 0 && !near[k].isByFace) continue;
            gaps.push_back(near[k].gap);
            Vec3& n = gaps.back().normal;
            if (emptyAxis >= 0) n = (n - n[emptyAxis]*Vec3::Unit(emptyAxis)).normalized();
        }
    }
    return gaps;
}

double deepestOf(const std::vector<WallGap>& gaps)
{
    double deepest = 0.0;
    for (const WallGap& wall : gaps) deepest = std::max(deepest, -wall.gap);
    return deepest;
}

} // namespace nscd
