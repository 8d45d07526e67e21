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

using Lanes = Eigen::Array<double, blockLanes, 1>;

/// Distances of the centers in the lanes of a block and sums of their radii; in lanes that are no pair of grains any that are harmless.
struct PairLanes
{
    Lanes x[3];
    Lanes radii;
    bool isPair[blockLanes];
};

PairLanes gatherPairs(const ContactList& list, const Scene& scene, std::size_t k)
{
    const ContactBlock& block = list.blocks[k];
    PairLanes pairs;
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const std::size_t slot = k*blockLanes + lane;
        const int a = block.a[lane], b = block.b[lane];
        pairs.isPair[lane] = list.wall[slot] < 0 && a != list.staticBody();
        Vec3 dx = Vec3::UnitX();
        pairs.radii[lane] = 0.0;
        if (pairs.isPair[lane])
        {
            dx = list.position[a] - list.position[b];
            for (int axis = 0; axis < 3; ++axis) dx[axis] -= list.image[slot][axis]*scene.box.length[axis];
            pairs.radii[lane] = list.radius[a] + list.radius[b];
        }
        for (int axis = 0; axis < 3; ++axis) pairs.x[axis][lane] = dx[axis];
    }
    return pairs;
}

/// Normals and gaps of the pairs of a block, all lanes at once.
void updatePairs(ContactList& list, const Scene& scene, std::size_t k)
{
    const PairLanes pairs = gatherPairs(list, scene, k);
    const Lanes distance = (pairs.x[0]*pairs.x[0] + pairs.x[1]*pairs.x[1] + pairs.x[2]*pairs.x[2]).sqrt();
    const Lanes inverse = 1.0/distance.max(std::numeric_limits<double>::min()), gap = distance - pairs.radii;
    ContactBlock& block = list.blocks[k];
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        if (!pairs.isPair[lane]) continue;
        if (!(distance[lane] > 1e-12*pairs.radii[lane])) refuseCoincident(list, block.a[lane], block.b[lane]);
        for (int axis = 0; axis < 3; ++axis) block.n[axis][lane] = pairs.x[axis][lane]*inverse[lane];
        list.gap[k*blockLanes + lane] = gap[lane];
    }
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
    for (std::size_t k = 0; k < list.blocks.size(); ++k) updatePairs(list, scene, k);
    for (std::size_t slot : list.slotsOfWalls) updateWall(list, scene, slot, list.blocks[slot/blockLanes].a[slot % blockLanes]);
    for (std::size_t group = 0; group + 1 < list.wallSlotStart.size(); ++group)
    {
        const int* slots = list.wallSlots.data();
        suppressSharedEdges(list, scene, slots + list.wallSlotStart[group], slots + list.wallSlotStart[group + 1]);
    }
}

} // namespace nscd
