// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways of fast grains, and the walls on them.
#include "nscd/step/stopsOnWay.hpp"

#include "nscd/search/wallHit.hpp"
#include "nscd/step/missedWalls.hpp"
#include "nscd/step/stopQueue.hpp"
#include "nscd/step/stopsBetweenRanks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

double largestReach(const std::vector<WallReach>& wallReach)
{
    double largest = 0.0;
    for (const WallReach& wall : wallReach) largest = std::max(largest, wall.distance);
    return largest;
}

/// Of a grain that may go so far relative to walls [m].
bool isFast(double reach, double radius) { return reach > deepestInWalls*radius; }

/// Of a grain [m]: more than small ones have would let them come through holes.
double toleranceOf(const WallsOfStep& walls, double radius) { return std::min(walls.tolerance, 0.1*radius); }

/// The share of a way at which a point leaves the box through a periodic side, not before `from`; the axis, or -1.
double timeOfExit(const PeriodicBox& box, const Vec3& x, const Vec3& way, double from, int& axis)
{
    double first = 1.0;
    axis = -1;
    for (int k = 0; k < 3; ++k)
    {
        if (!box.isPeriodic(k) || way[k] == 0.0) continue;
        const double side = way[k] > 0.0 ? box.lower[k] + box.length[k] : box.lower[k];
        const double time = std::max(from, (side - x[k])/way[k]);
        if (time < first)
        {
            first = time;
            axis = k;
        }
    }
    return first;
}

/// The first wall on a way, and the way to where it is touched and with the wall on from there.
struct WallOnWay
{
    double time = never;
    int group = -1;
    Vec3 held = Vec3::Zero();
};

/// Of each group.
std::vector<StepFrame> framesOf(const WallSearch& search, const std::vector<GroupMotion>& motions)
{
    std::vector<StepFrame> frames(search.groups());
    for (const GroupMotion& motion : motions)
    {
        if (motion.way > 0.0) frames[motion.group] = {true, motion.next*motion.now.inverse(), motion.now*motion.next.inverse()};
    }
    return frames;
}

/// Looks along the ways of grains. They are a little smaller there: what touches a wall, to within the tolerance of contacts, may glide along it.
class Lookout
{
public:
    Lookout(const WallsOfStep& walls, const std::vector<GroupMotion>& motions) : walls_(walls), motions_(motions) {}

    /// Of a sphere whose center moves from `x` by `way` in the step, cut where it goes through periodic sides. Walls move as chords.
    WallOnWay firstOnWay(const Vec3& x, const Vec3& way, double radius) const
    {
        const PeriodicBox& box = walls_.scene.box;
        Vec3 start = box.wrap(x);
        for (double from = 0.0;;)
        {
            int axis;
            const double to = timeOfExit(box, start, way, from, axis);
            const WallOnWay first = firstOnPiece(start, way, radius, from, to);
            if (first.time <= 1.0 || axis < 0) return first;
            start[axis] -= std::copysign(box.length[axis], way[axis]);
            from = to;
        }
    }

    /// Where walls move, one that takes a grain along may take it into others, and others may come to where it stopped.
    void takeAlong(const ContactList& list, Stop& stop) const
    {
        constexpr int mostWalls = 4;
        const bool isAnyMoving = std::any_of(motions_.begin(), motions_.end(), [](const GroupMotion& motion) { return motion.way > 0.0; });
        for (int k = 0; k < mostWalls && isAnyMoving; ++k)
        {
            const WallOnWay next = firstOnWay(list.position[stop.body], stop.way, list.radius[stop.body]);
            if (next.time > 1.0) return;
            stop.way = next.held;
            stop.wall = next.group;
        }
    }

private:
    /// On the part between two times, which lies in the box.
    WallOnWay firstOnPiece(const Vec3& x, const Vec3& way, double radius, double from, double to) const
    {
        const double margin = toleranceOf(walls_, radius);
        const int emptyAxis = walls_.scene.grains.shape.emptyAxis;
        WallOnWay first;
        for (const GroupMotion& motion : motions_)
        {
            const Vec3 start = motion.before(x), d = motion.after(x + way) - start;
            const Way piece{start + from*d, (to - from)*d, radius - margin, deepestInWalls*radius};
            const WallHit hit = firstHit(walls_.scene.walls, walls_.search, motion.group, piece, emptyAxis);
            if (!hit.isAny()) continue;
            // Back to where the whole grain is no nearer than touching: the distance is convex along the way.
            const double time = from + (to - from)*hit.time;
            const double touching = hit.distance < piece.radius ? time : std::max(0.0, time + margin/hit.normal.dot(d));
            if (!(touching < first.time)) continue;
            first = {touching, motion.group, motion.isMoving ? Vec3(motion.next*(start + touching*d) - x) : Vec3(touching*way)};
        }
        return first;
    }

    const WallsOfStep& walls_;
    const std::vector<GroupMotion>& motions_;
};

} // namespace

bool areAnyFast(const Grains& grains, const std::vector<double>& reach, const std::vector<WallReach>& wallReach)
{
    const double ofWalls = largestReach(wallReach);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (isFast(reach[i] + ofWalls, grains.radius[i])) return true;
    }
    return false;
}

bool areAnyFast(const ContactList& list, const std::vector<int>& bodies)
{
    const double ofWalls = largestReach(list.wallReach);
    return std::any_of(bodies.begin(), bodies.end(), [&](int body) { return isFast(list.reach[body] + ofWalls, list.radius[body]); });
}

std::vector<double> reachesToMany(const Grains& grains, const WallSearch& search, const std::vector<double>& speed, double deltaT, double reachAtRest)
{
    const std::vector<int> clumpOf = clumpOfGrains(grains);
    std::vector<double> found;
    bool areWallsMany = false;
    for (int group = 0; group < search.groups(); ++group) areWallsMany = areWallsMany || search.hasMany(group);
    for (std::size_t i = 0; areWallsMany && i < grains.size(); ++i)
    {
        const double deepest = deepestInWalls*grains.radius[i];
        const bool isInClump = !clumpOf.empty() && clumpOf[i] >= 0;
        if (isInClump || grains.isFixed[i] || deltaT*speed[i] <= deepest) continue;
        found.resize(grains.size(), std::numeric_limits<double>::infinity());
        found[i] = deepest + reachAtRest;
    }
    return found;
}

std::vector<Stop> findStops(const ContactList& list, const WallsOfStep& walls, double deltaT)
{
    const std::vector<GroupMotion> motions = motionsOf(list, walls);
    double wayOfWalls = 0.0;
    for (const GroupMotion& motion : motions) wayOfWalls = std::max(wayOfWalls, motion.way);
    const Lookout lookout(walls, motions);
    std::vector<Stop> stops;
    for (int body = 0; body < list.owned(); ++body)
    {
        const Vec3 way = deltaT*Vec3(list.bodies[body].v);
        const double deepest = deepestInWalls*list.radius[body], left = deepest - wayOfWalls;
        const bool isFast = left < 0.0 || way.squaredNorm() > left*left;
        const bool isBlind = mayMissWalls(list, walls, motions, body, way);
        if (!(isFast || isBlind) || !fliesAlone(list, body)) continue;
        const WallOnWay first = lookout.firstOnWay(list.position[body], way, list.radius[body]);
        if (first.time <= 1.0) stops.push_back({body, first.time, first.held, first.group});
    }
    if (!list.halo.any(!stops.empty())) return stops;
    for (Stop& stop : stops) lookout.takeAlong(list, stop);
    const std::vector<StepFrame> frames = framesOf(walls.search, motions);
    const WaysOfStep ways{list, walls.scene.box, frames, deltaT, walls.tolerance};
    constexpr int mostRounds = 16;
    addQueue(ways, stops);
    for (int k = 0; k < mostRounds && stopBehindOtherRanks(ways, stops); ++k) addQueue(ways, stops);
    const int emptyAxis = walls.scene.grains.shape.emptyAxis;
    for (Stop& stop : stops)
    {
        lookout.takeAlong(list, stop);
        if (emptyAxis >= 0) stop.way[emptyAxis] = 0.0;
    }
    return stops;
}

} // namespace nscd
