// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of all candidates at the present positions.
#include "contactList.hpp"

#include "invalidValue.hpp"
#include "wallContacts.hpp"

#include <limits>

namespace nscd
{

namespace
{

/// A wall whose plane lies further behind the center than this share of the radius is seen from its back: no contact.
constexpr double backSide = -0.5;

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

/// Takes a normal's component along an axis out. Returns whether something is left: the walls at both ends of a 2D scene have none.
bool flatten(Vec3& n, int axis)
{
    n[axis] = 0.0;
    const double size = n.norm();
    if (size < 1e-3)
    {
        n = Vec3::Unit((axis + 1) % 3);
        return false;
    }
    n /= size;
    return true;
}

void updateWall(ContactList& list, const Scene& scene, std::size_t slot, int a)
{
    const WallProximity near = nearestPoint(scene.walls, list.wall[slot], list.position[a]);
    const bool isBehind = near.isInside && near.distance < backSide*list.radius[a];
    Vec3 n = near.normal;
    const bool isFacing = scene.grains.shape.emptyAxis < 0 || flatten(n, scene.grains.shape.emptyAxis);
    setSlot(list, slot, n, isBehind || !isFacing ? std::numeric_limits<double>::max() : near.distance - list.radius[a]);
}

} // namespace

void updateGeometry(ContactList& list, const Scene& scene)
{
    for (std::size_t k = 0; k < list.blocks.size(); ++k) updatePairs(list, scene, k);
    for (std::size_t slot : list.slotsOfWalls) updateWall(list, scene, slot, list.blocks[slot/blockLanes].a[slot % blockLanes]);
    suppressGhosts(list, scene);
}

} // namespace nscd
