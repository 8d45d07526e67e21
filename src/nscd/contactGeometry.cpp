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

void updatePair(ContactList& list, const Scene& scene, std::size_t slot, int a, int b)
{
    Vec3 dx = list.position[a] - list.position[b];
    for (int k = 0; k < 3; ++k) dx[k] -= list.image[slot][k]*scene.box.length[k];
    const double sum = list.radius[a] + list.radius[b];
    const double distance = dx.norm();
    if (!(distance > 1e-12*sum)) refuseCoincident(list, a, b);
    setSlot(list, slot, dx/distance, distance - sum);
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
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes];
        if (a == list.staticBody()) continue;
        if (list.wall[slot] >= 0) updateWall(list, scene, slot, a);
        else updatePair(list, scene, slot, a, block.b[slot % blockLanes]);
    }
    suppressGhosts(list, scene);
}

} // namespace nscd
