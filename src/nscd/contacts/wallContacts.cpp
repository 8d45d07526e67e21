// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Local minima of the distance to a surface among the nearest points of its parts.
#include "nscd/contacts/wallContacts.hpp"

#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

/// Wall points nearer than this share of the radius are one point: half of the default dead band of 1e-4 diameters.
constexpr double samePoint = 1e-4;
/// A normal that differs less from the plane's is that of the face: round-off.
constexpr double sameNormal = 1e-13;

constexpr double noContact = std::numeric_limits<double>::max();

/// The nearest point of one region.
struct Foot
{
    int slot;
    int region;
    Vec3 point;
    Vec3 faceNormal;
    double distance;
    double size2;     ///< squared distance to the farthest vertex of the region
    bool isFace;
};

double farthestVertex2(const WallRegion& region, const Vec3& point)
{
    double farthest2 = 0.0;
    for (const WallEdge& edge : region.edges) farthest2 = std::max(farthest2, (edge.start - point).squaredNorm());
    return farthest2;
}

Foot footOf(const ContactList& list, const Scene& scene, int slot, int body)
{
    const Walls& walls = scene.walls;
    const WallRegion& region = walls.regions[list.wall[slot]];
    const WallPatch& patch = walls.patches[region.patch];
    const Vec3 n = normal(list, slot);
    Foot foot{slot, list.wall[slot], Vec3::Zero(), region.normal, list.gap[slot] + list.radius[body], 0.0, false};
    foot.point = scene.box.wrap(list.position[body]) - foot.distance*n;
    if (patch.motion)
    {
        foot.faceNormal = patch.pose.linear()*region.normal;
        foot.size2 = farthestVertex2(region, patch.pose.linear().transpose()*(foot.point - patch.pose.translation()));
    }
    else foot.size2 = farthestVertex2(region, foot.point);
    foot.isFace = n.cross(foot.faceNormal).squaredNorm() < sameNormal*sameNormal;
    return foot;
}

bool holds(const Walls& walls, const Foot& foot, const Vec3& point, double tolerance)
{
    const Vec3 between = point - foot.point;
    if (std::abs(foot.faceNormal.dot(between)) > tolerance) return false;
    const double reach = std::sqrt(foot.size2) + tolerance;
    if (between.squaredNorm() > reach*reach) return false;
    return std::abs(nearestPoint(walls, foot.region, point).distance) <= tolerance;
}

bool comesFirst(const Foot& a, const Foot& b) { return a.isFace != b.isFace ? a.isFace : a.region < b.region; }

bool isGhost(const Walls& walls, const std::vector<Foot>& feet, const Foot& foot, double tolerance)
{
    for (const Foot& other : feet)
    {
        if (other.slot == foot.slot) continue;
        const bool isSame = (other.point - foot.point).squaredNorm() <= tolerance*tolerance;
        if (isSame ? comesFirst(other, foot) : !foot.isFace && other.distance < foot.distance && holds(walls, other, foot.point, tolerance))
        {
            return true;
        }
    }
    return false;
}

} // namespace

void suppressGhosts(ContactList& list, const Scene& scene)
{
    std::vector<Foot> feet;
    for (std::size_t group = 0; group + 1 < list.wallSlotStart.size(); ++group)
    {
        const int first = list.wallSlotStart[group], last = list.wallSlotStart[group + 1];
        const int body = list.blocks[list.wallSlots[first]/blockLanes].a[list.wallSlots[first] % blockLanes];
        feet.clear();
        for (int k = first; k < last; ++k)
        {
            if (list.gap[list.wallSlots[k]] < noContact) feet.push_back(footOf(list, scene, list.wallSlots[k], body));
        }
        for (const Foot& foot : feet)
        {
            if (isGhost(scene.walls, feet, foot, samePoint*list.radius[body])) list.gap[foot.slot] = noContact;
        }
    }
}

} // namespace nscd
