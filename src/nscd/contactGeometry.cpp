// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of all candidates at the present positions.
#include "contactList.hpp"

#include "invalidValue.hpp"

#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

/// A wall whose plane lies further behind the center than this share of the radius is seen from its back: no contact.
constexpr double backSide = -0.5;
/// Two wall points nearer than this share of the radius are one point.
constexpr double samePoint = 1e-6;

void refuseCoincident(const ContactList& list, int a, int b)
{
    throw invalidValue
    (
        "distance between the centers of grains " + std::to_string(list.id[a]) + " and "
      + std::to_string(list.id[b]), 0, "> 0 m (coincident centers have no contact normal)"
    );
}

void setSlot(ContactList& list, std::size_t slot, const Vec3& n, double gap)
{
    ContactBlock& block = list.blocks[slot/blockLanes];
    for (int k = 0; k < 3; ++k) block.n[k][slot % blockLanes] = n[k];
    list.gap[slot] = gap;
}

void updatePair(ContactList& list, const Scene& scene, std::size_t slot, int a, int b)
{
    Vec3 dx = list.position[a] - list.position[b];
    for (int k = 0; k < 3; ++k) dx[k] -= list.image[slot][k]*scene.box.length[k];
    const double sum = list.radius[a] + list.radius[b];
    const double distance = dx.norm();
    if (!(distance > 1e-12*sum)) refuseCoincident(list, a, b);
    setSlot(list, slot, dx/distance, distance - sum);
}

void updateWall(ContactList& list, const Scene& scene, std::size_t slot, int a)
{
    const WallProximity near = nearestPoint(scene.walls.regions[list.wall[slot]], list.position[a]);
    const bool isBehind = near.isInside && near.distance < backSide*list.radius[a];
    setSlot(list, slot, near.normal, isBehind ? std::numeric_limits<double>::max() : near.distance - list.radius[a]);
}

/// Where two regions meet, a grain must feel their common edge once, and not at all while it touches a face that holds it.
void suppressSharedEdges(ContactList& list, const Scene& scene, const int* first, const int* last)
{
    for (const int* k = first; k != last; ++k)
    {
        const int body = list.blocks[*k/blockLanes].a[*k % blockLanes];
        const Vec3& center = list.position[body];
        const WallProximity edge = nearestPoint(scene.walls.regions[list.wall[*k]], center);
        if (edge.isInside) continue;
        for (const int* other = first; other != last; ++other)
        {
            if (other == k) continue;
            const WallRegion& region = scene.walls.regions[list.wall[*other]];
            const WallProximity fromEdge = nearestPoint(region, edge.point);
            if (std::abs(fromEdge.distance) > samePoint*list.radius[body]) continue;
            const WallProximity face = nearestPoint(region, center);
            if (face.isInside || other < k)
            {
                list.gap[*k] = std::numeric_limits<double>::max();
                break;
            }
        }
    }
}

} // namespace

void updateGeometry(ContactList& list, const Scene& scene)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes];
        if (a == list.staticBody()) continue;
        if (list.wall[slot] >= 0) updateWall(list, scene, slot, a);
        else updatePair(list, scene, slot, a, block.b[slot % blockLanes]);
    }
    for (std::size_t group = 0; group + 1 < list.wallSlotStart.size(); ++group)
    {
        const int* slots = list.wallSlots.data();
        suppressSharedEdges(list, scene, slots + list.wallSlotStart[group], slots + list.wallSlotStart[group + 1]);
    }
}

} // namespace nscd
