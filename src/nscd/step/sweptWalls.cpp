// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways of fast grains, and the walls on them.
#include "nscd/step/sweptWalls.hpp"

#include "nscd/contacts/listBlocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

/// Share of the radius that a step must lead through for a grain to be swept.
constexpr double fastShare = 0.5;
/// In radii: spheres on their way are smaller by that, more than dead band and tolerance leave of overlap.
constexpr double shrink = 2e-3;
/// In radii: walls nearer than that are contacts whether the way leads to them or not, since others may push the grain.
constexpr double nearShare = 0.1;
/// As in wallContacts: nearest points closer than that are one, in radii.
constexpr double samePoint = 1e-4;
/// As in contactGeometry: seen from its back.
constexpr double backSide = -0.5;

/// Poses of a group now and at the end of the step.
struct GroupMotion
{
    bool isMoving;
    WallPose now, next;

    GroupMotion(const WallsOfStep& walls, int group)
    :
        isMoving(walls.search.patchOf(group) >= 0),
        now(isMoving ? walls.scene.walls.patches[walls.search.patchOf(group)].pose : WallPose::Identity()),
        next(isMoving ? walls.moving.next(walls.search.patchOf(group)) : WallPose::Identity())
    {}

    Vec3 before(const Vec3& x) const { return isMoving ? Vec3(now.linear().transpose()*(x - now.translation())) : x; }
    Vec3 after(const Vec3& x) const { return isMoving ? Vec3(next.linear().transpose()*(x - next.translation())) : x; }
};

/// Takes the part along the axis out that a scene in the plane does not have.
Vec3 inPlane(Vec3 n, int axis)
{
    if (axis < 0) return n;
    n[axis] = 0.0;
    return n.normalized();
}

/// The share of the way at which a point leaves the box through a periodic side, after `from`; the axis, or -1.
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

/// The first on the part of a way between two times that lies in the box.
WallOnWay firstOnPiece(const WallsOfStep& walls, const Vec3& x, const Vec3& way, double radius, double from, double to)
{
    WallOnWay first;
    const int emptyAxis = walls.scene.grains.shape.emptyAxis;
    for (int group = 0; group < walls.search.groups(); ++group)
    {
        const GroupMotion motion(walls, group);
        const Vec3 start = motion.before(x), d = motion.after(x + way) - start;
        const WallHit hit = firstHit(walls.scene.walls, walls.search, group, {start + from*d, (to - from)*d, radius}, emptyAxis);
        const double time = from + (to - from)*hit.time;
        if (!hit.isAny() || !(time < first.hit.time)) continue;
        first.hit = {time, hit.region, inPlane(motion.now.linear()*hit.normal, emptyAxis), hit.distance};
        const double sinking = -hit.normal.dot(d);
        first.gap = hit.distance + time*sinking;
        // The sphere is a little smaller than the grain.
        const double touching = std::max(0.0, time - shrink/(1.0 - shrink)*radius/sinking);
        first.held = motion.isMoving ? Vec3(motion.next*(start + touching*d) - x) : Vec3(touching*way);
    }
    return first;
}

/// Whether a group's outlined walls come within a distance of a place during a list.
bool isWithin(const WallsOfStep& walls, int group, const Vec3& x, double distance)
{
    const GroupMotion motion(walls, group);
    return walls.search.outlined(group).squaredExteriorDistance(motion.before(x)) <= distance*distance;
}

bool crossesSides(const PeriodicBox& box, const Vec3& x, double distance)
{
    for (int k = 0; k < 3; ++k)
    {
        if (box.isPeriodic(k) && (x[k] - distance < box.lower[k] || x[k] + distance > box.lower[k] + box.length[k])) return true;
    }
    return false;
}

/// A wall region that a grain touches, or nearly so.
struct NearWall
{
    int region;
    int group;
    WallProximity at;   ///< in the group's frame
};

bool holds(const Walls& walls, const NearWall& wall, const Vec3& point, double tolerance)
{
    return std::abs(nearestPoint(walls.regions[wall.region], point).distance) <= tolerance;
}

/// Local minima of the distance among walls near a place, nearest first, as suppressGhosts() has them.
std::vector<NearWall> wallsAt(const WallsOfStep& walls, int group, const Vec3& x, double radius)
{
    const double within = (1.0 + nearShare)*radius, tolerance = samePoint*radius;
    const Eigen::AlignedBox3d around(Vec3(x - Vec3::Constant(within)), Vec3(x + Vec3::Constant(within)));
    std::vector<int> regions;
    walls.search.findInBox(group, around, regions);
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    std::vector<NearWall> near;
    for (int region : regions)
    {
        if (liesAlong(walls.scene.walls.regions[region], walls.scene.grains.shape.emptyAxis)) continue;
        const WallProximity at = nearestPoint(walls.scene.walls.regions[region], x);
        if (at.distance < within && !(at.isInside && at.distance < backSide*radius)) near.push_back({region, group, at});
    }
    std::stable_sort(near.begin(), near.end(), [](const NearWall& a, const NearWall& b)
    {
        return a.at.isInside != b.at.isInside && a.at.distance == b.at.distance ? a.at.isInside : a.at.distance < b.at.distance;
    });
    std::vector<NearWall> found;
    for (auto place = near.begin(); place != near.end(); ++place)
    {
        const NearWall& wall = *place;
        const bool isGhost = std::any_of(near.begin(), place, [&](const NearWall& other)
        {
            const bool isSame = (other.at.point - wall.at.point).squaredNorm() <= tolerance*tolerance;
            return isSame || (!wall.at.isInside && holds(walls.scene.walls, other, wall.at.point, tolerance));
        });
        if (!isGhost) found.push_back(wall);
    }
    return found;
}

void fill(ContactList& list, const WallsOfStep& walls, SweptBody& swept, int region, const Vec3& n, double gap)
{
    const std::size_t slot = swept.slots[swept.used++];
    setRegion(list, walls.scene, slot, region);
    for (int k = 0; k < 3; ++k) list.blocks[slot/blockLanes].n[k][slot % blockLanes] = n[k];
    list.gap[slot] = gap;
}

void switchOff(ContactList& list, SweptBody& swept)
{
    swept.used = 0;
    for (std::uint32_t slot : swept.slots)
    {
        setImpulse(list, slot, Vec3::Zero());
        list.laws.setImpulses(slot, noLawImpulses());
        list.gap[slot] = std::numeric_limits<double>::max();
    }
}

bool isFilled(const ContactList& list, const SweptBody& swept, int region, const Vec3& n)
{
    constexpr double sameNormal = 1.0 - 1e-9;
    for (std::size_t k = 0; k < swept.used; ++k)
    {
        const std::size_t slot = swept.slots[k];
        if (list.wall[slot] == region && normal(list, slot).dot(n) > sameNormal) return true;
    }
    return false;
}

void fillNear(ContactList& list, const WallsOfStep& walls, SweptBody& swept)
{
    const double radius = list.radius[swept.body];
    for (int group = 0; group < walls.search.groups(); ++group)
    {
        const GroupMotion motion(walls, group);
        for (const NearWall& wall : wallsAt(walls, group, motion.before(walls.scene.box.wrap(list.position[swept.body])), radius))
        {
            // One place stays free for what is met on the way.
            if (swept.used + 1 == swept.slots.size()) return;
            const Vec3 n = inPlane(motion.now.linear()*wall.at.normal, walls.scene.grains.shape.emptyAxis);
            fill(list, walls, swept, wall.region, n, wall.at.distance - radius);
        }
    }
}

Vec3 wayOf(const ContactList& list, int body, double deltaT) { return deltaT*Vec3(list.bodies[body].v); }

double smaller(double radius) { return (1.0 - shrink)*radius; }

/// To where it touches what is first on its way; where walls move, once more for what is on the way with them.
HeldBody held(const ContactList& list, const WallsOfStep& walls, int body, double deltaT, const WallOnWay& first)
{
    constexpr int mostWalls = 3;
    HeldBody held{body, first.hit.time, first.held};
    for (int k = 0; k < mostWalls && walls.scene.walls.anyMotion(); ++k)
    {
        const WallOnWay next = firstOnWay(walls, list.position[body], held.way, smaller(list.radius[body]));
        if (!next.hit.isAny()) break;
        held.way = next.held;
    }
    const double length = wayOf(list, body, deltaT).norm();
    if (length > 0.0) held.time = std::min(1.0, held.way.norm()/length);
    return held;
}

/// Ends of ways, for those that run into others which stopped before.
class Queue
{
public:
    Queue(const ContactList& list, const PeriodicBox& box, double deltaT, std::vector<HeldBody>& held) : list_(list), box_(box), deltaT_(deltaT), held_(held)
    {
        number_.assign(list.owned(), -1);
        for (std::size_t k = 0; k < held.size(); ++k) number_[held[k].body] = static_cast<int>(k);
    }

    /// Returns whether any pair had to be.
    bool hold()
    {
        bool isAny = false;
        for (std::size_t slot : list_.fastPairs)
        {
            const ContactBlock& block = list_.blocks[slot/blockLanes];
            const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
            if (a >= list_.owned() || b >= list_.owned()) continue;
            Vec3 x = list_.position[a] - list_.position[b];
            for (int axis = 0; axis < 3; ++axis) x[axis] -= list_.image[slot][axis]*box_.length[axis];
            isAny = stopBehind(a, b, x) || isAny;
            isAny = stopBehind(b, a, -x) || isAny;
        }
        return isAny;
    }

private:
    double timeOf(int body) const { return number_[body] < 0 ? 1.0 : held_[number_[body]].time; }

    /// `x`: from the body that stands at the end of its way to the other one, at the start.
    bool stopBehind(int body, int stopped, const Vec3& x)
    {
        if (number_[stopped] < 0) return false;
        const double from = timeOf(stopped), to = timeOf(body), radii = smaller(list_.radius[body] + list_.radius[stopped]);
        if (to <= from || list_.inverseMass[body] == 0.0) return false;
        const Vec3 way = wayOf(list_, body, deltaT_), start = x + from*way - held_[number_[stopped]].way, rest = (to - from)*way;
        const bool overlaps = start.squaredNorm() <= radii*radii && start.dot(rest) < 0.0;
        const double time = overlaps ? 0.0 : timeToOrigin(start, rest, radii);
        if (time > 1.0) return false;
        if (number_[body] < 0)
        {
            number_[body] = static_cast<int>(held_.size());
            held_.push_back({body, 1.0, Vec3::Zero()});
        }
        const double stop = from + time*(to - from);
        held_[number_[body]].time = stop;
        held_[number_[body]].way = stop*way;
        return true;
    }

    const ContactList& list_;
    const PeriodicBox& box_;
    double deltaT_;
    std::vector<HeldBody>& held_;
    std::vector<int> number_;   ///< of each own body in held_, -1: goes all its way
};

bool fillFirst(ContactList& list, const WallsOfStep& walls, SweptBody& swept, double deltaT)
{
    if (swept.used == swept.slots.size()) return false;
    const double radius = list.radius[swept.body];
    const WallOnWay first = firstOnWay(walls, list.position[swept.body], wayOf(list, swept.body, deltaT), smaller(radius));
    if (!first.hit.isAny() || isFilled(list, swept, first.hit.region, first.hit.normal)) return false;
    fill(list, walls, swept, first.hit.region, first.hit.normal, first.gap - radius);
    return true;
}

} // namespace

std::vector<Haste> findHaste
(
    const WallsOfStep& walls, const std::vector<double>& speed, const std::vector<double>& reach, const std::vector<WallReach>& wallReach, double deltaT
)
{
    const Grains& grains = walls.scene.grains;
    const std::vector<int> clumpOf = clumpOfGrains(grains);
    std::vector<Haste> found;
    for (int group = 0; group < walls.search.groups(); ++group)
    {
        if (walls.search.outlined(group).isEmpty()) continue;
        const int patch = walls.search.patchOf(group);
        const double moved = patch >= 0 ? wallReach[patch].inStep : 0.0, room = patch >= 0 ? wallReach[patch].distance : 0.0;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            const double radius = grains.radius[i];
            if (deltaT*speed[i] + moved <= fastShare*radius || grains.isFixed[i] || (!clumpOf.empty() && clumpOf[i] >= 0)) continue;
            found.resize(grains.size(), Haste::none);
            const double distance = radius + reach[i] + room;
            const bool isNear = crossesSides(walls.scene.box, grains.position[i], distance) || isWithin(walls, group, grains.position[i], distance);
            found[i] = isNear || found[i] == Haste::swept ? Haste::swept : Haste::far;
        }
    }
    return found;
}

bool isAnyHasty(const ContactList& list, double deltaT)
{
    for (int body = 0; body < list.owned(); ++body)
    {
        const double way = fastShare*list.radius[body]/deltaT;
        if (Vec3(list.bodies[body].v).squaredNorm() <= way*way || list.inverseMass[body] == 0.0) continue;
        const bool isMember = !list.general.empty() && list.general.memberOf[body] >= 0;
        if (!isMember && (list.haste.empty() || list.haste[body] == Haste::none)) return true;
    }
    return false;
}

WallOnWay firstOnWay(const WallsOfStep& walls, const Vec3& x, const Vec3& way, double radius)
{
    const PeriodicBox& box = walls.scene.box;
    Vec3 start = box.wrap(x);
    for (double from = 0.0;;)
    {
        int axis;
        const double to = timeOfExit(box, start, way, from, axis);
        const WallOnWay first = firstOnPiece(walls, start, way, radius, from, to);
        if (first.hit.isAny() || axis < 0) return first;
        start[axis] -= std::copysign(box.length[axis], way[axis]);
        from = to;
    }
}

void aimSwept(ContactList& list, const WallsOfStep& walls, double deltaT)
{
    for (SweptBody& swept : list.swept)
    {
        switchOff(list, swept);
        fillNear(list, walls, swept);
        fillFirst(list, walls, swept, deltaT);
    }
}

bool aimFurther(ContactList& list, const WallsOfStep& walls, double deltaT)
{
    bool isAny = false;
    for (SweptBody& swept : list.swept) isAny = fillFirst(list, walls, swept, deltaT) || isAny;
    return isAny;
}

std::vector<HeldBody> findHeld(const ContactList& list, const WallsOfStep& walls, double deltaT)
{
    constexpr int mostRounds = 16;
    std::vector<HeldBody> found;
    for (const SweptBody& swept : list.swept)
    {
        const WallOnWay first = firstOnWay(walls, list.position[swept.body], wayOf(list, swept.body, deltaT), smaller(list.radius[swept.body]));
        if (first.hit.isAny()) found.push_back(held(list, walls, swept.body, deltaT, first));
    }
    if (found.empty()) return found;
    Queue queue(list, walls.scene.box, deltaT, found);
    for (int round = 0; round < mostRounds && queue.hold(); ++round) {}
    return found;
}

} // namespace nscd
