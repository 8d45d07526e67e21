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

/// Outlined regions of a group whose bounds are within a distance of a place in its frame.
std::vector<int> regionsAbout(const WallsOfStep& walls, int group, const Vec3& center, double distance)
{
    std::vector<int> regions;
    const Vec3 margin = Vec3::Constant(distance);
    walls.search.findInBox(group, {Vec3(center - margin), Vec3(center + margin)}, regions);
    return regions;
}

bool isAnyNear(const WallsOfStep& walls, const std::vector<GroupMotion>& motions, const Vec3& x, double distance)
{
    return std::any_of(motions.begin(), motions.end(), [&](const GroupMotion& motion)
    {
        return walls.search.hasMany(motion.group) && !regionsAbout(walls, motion.group, motion.after(x), distance).empty();
    });
}

/// A wall that a sphere is in.
struct Penetration
{
    double depth = 0.0;             ///< [m]
    Vec3 normal = Vec3::Zero();     ///< from the wall to the center, where things are at the end of the step
};

/// The deepest one of a sphere at x.
Penetration deepestAt(const WallsOfStep& walls, const std::vector<GroupMotion>& motions, const Vec3& x, double radius)
{
    Penetration deepest;
    for (const GroupMotion& motion : motions)
    {
        const Vec3 center = motion.after(x);
        for (int number : regionsAbout(walls, motion.group, center, radius))
        {
            const WallRegion& region = walls.scene.walls.regions[number];
            if (liesAlong(region, walls.scene.grains.shape.emptyAxis)) continue;
            const WallProximity near = nearestPoint(region, center);
            if (near.isInside && near.distance < backSide*radius) continue;
            if (radius - near.distance > deepest.depth) deepest = {radius - near.distance, motion.turned(near.normal)};
        }
    }
    return deepest;
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

double deepestInMissedWalls(const ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies)
{
    double deepest = 0.0;
    if (bodies.empty()) return deepest;
    const std::vector<GroupMotion> motions = motionsOf(list, walls);
    for (int body : bodies) deepest = std::max(deepest, deepestAt(walls, motions, walls.scene.box.wrap(list.position[body]), list.radius[body]).depth);
    return deepest;
}

void pushOutOfMissedWalls(ContactList& list, const WallsOfStep& walls, const std::vector<int>& bodies, double allowed)
{
    constexpr int mostPushes = 50;
    if (bodies.empty()) return;
    const std::vector<GroupMotion> motions = motionsOf(list, walls);
    const int emptyAxis = walls.scene.grains.shape.emptyAxis;
    for (int body : bodies)
    {
        for (int k = 0; k < mostPushes; ++k)
        {
            const Penetration in = deepestAt(walls, motions, walls.scene.box.wrap(list.position[body]), list.radius[body]);
            if (in.depth <= allowed) break;
            Vec3 push = in.depth*in.normal;
            if (emptyAxis >= 0) push[emptyAxis] = 0.0;
            list.position[body] += push;
        }
    }
}

} // namespace nscd
