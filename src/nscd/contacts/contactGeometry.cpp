// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of all candidates at the present positions.
#include "nscd/contacts/contactGeometry.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/contacts/wallContacts.hpp"
#include "nscd/kernels/applyImpulse.hpp"

#include <cstring>
#include <limits>

namespace nscd
{

namespace
{

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

/// What a pair needs of a body, within one cache line; zeros of what is no grain.
struct alignas(32) BodySphere
{
    double center[3];
    double radius;
};

std::vector<BodySphere> gatherSpheres(const ContactList& list)
{
    std::vector<BodySphere> spheres(list.bodies.size());
    for (std::size_t body = 0; body < list.position.size(); ++body)
    {
        const Vec3& x = list.position[body];
        spheres[body] = {{x[0], x[1], x[2]}, list.radius[body]};
    }
    return spheres;
}

bool isAnyShifted(const std::array<signed char, 3>* image)
{
    std::uint64_t shifts[3];
    static_assert(sizeof(shifts) == blockLanes*sizeof(*image));
    std::memcpy(shifts, image, sizeof(shifts));
    return (shifts[0] | shifts[1] | shifts[2]) != 0;
}

/// Whether all lanes of a block are used, by pairs of grains.
bool isOfPairs(const ContactList& list, std::size_t k)
{
    using Indices = Eigen::Array<int, blockLanes, 1>;
    return Eigen::Map<const Indices>(&list.wall[k*blockLanes]).maxCoeff() < 0
        && Eigen::Map<const Indices>(list.blocks[k].a).maxCoeff() < list.staticBody();
}

/// Normals and gaps of the pairs of a block, all lanes at once.
void updateBlock(ContactList& list, const Scene& scene, const std::vector<BodySphere>& spheres, std::size_t k)
{
    ContactBlock& block = list.blocks[k];
    Lanes x[3], radii;
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const BodySphere& a = spheres[block.a[lane]];
        const BodySphere& b = spheres[block.b[lane]];
        for (int axis = 0; axis < 3; ++axis) x[axis][lane] = a.center[axis] - b.center[axis];
        radii[lane] = a.radius + b.radius;
    }
    const std::array<signed char, 3>* image = &list.image[k*blockLanes];
    if (isAnyShifted(image))
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            if (!scene.box.isPeriodic(axis)) continue;
            for (int lane = 0; lane < blockLanes; ++lane) x[axis][lane] -= image[lane][axis]*scene.box.length[axis];
        }
    }
    const Lanes distance = (x[0]*x[0] + x[1]*x[1] + x[2]*x[2]).sqrt();
    const Lanes inverse = 1.0/distance.max(std::numeric_limits<double>::min()), gap = distance - radii;
    const bool isCoincident = !(distance > 1e-12*radii).all();
    if (isOfPairs(list, k) && !isCoincident)
    {
        for (int axis = 0; axis < 3; ++axis) Eigen::Map<Lanes>(block.n[axis]) = x[axis]*inverse;
        Eigen::Map<Lanes>(&list.gap[k*blockLanes]) = gap;
        return;
    }
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const std::size_t slot = k*blockLanes + lane;
        if (list.wall[slot] >= 0 || block.a[lane] == list.staticBody()) continue;
        if (!(distance[lane] > 1e-12*radii[lane])) refuseCoincident(list, block.a[lane], block.b[lane]);
        for (int axis = 0; axis < 3; ++axis) block.n[axis][lane] = x[axis][lane]*inverse[lane];
        list.gap[slot] = gap[lane];
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
    const WallProximity near = nearestPoint(scene.walls, list.wall[slot], scene.box.wrap(list.position[a]));
    const bool isBehind = near.isInside && near.distance < backSide*list.radius[a];
    Vec3 n = near.normal;
    const bool isFacing = scene.grains.shape.emptyAxis < 0 || flatten(n, scene.grains.shape.emptyAxis);
    setSlot(list, slot, n, isBehind || !isFacing ? std::numeric_limits<double>::max() : near.distance - list.radius[a]);
}

/// Turns the normal of a pair to the present places; its impulse acts there now.
void turnNormal(ContactList& list, const PeriodicBox& box, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
    const Vec3 before = normal(list, slot), now = distanceOfPair(list, box, slot).normalized(), back = -impulse(list, slot);
    const Vec3 r = admissible(-back, now, block.friction[slot % blockLanes]);
    applyImpulse(list.bodies[a], list.bodies[b], before.data(), back.data());
    applyImpulse(list.bodies[a], list.bodies[b], now.data(), r.data());
    setSlot(list, slot, now, list.gap[slot]);
    setImpulse(list, slot, r);
}

} // namespace

void updatePairs(ContactList& list, const Scene& scene, std::size_t first, std::size_t end)
{
    const std::vector<BodySphere> spheres = gatherSpheres(list);
    for (std::size_t k = first; k < end; ++k) updateBlock(list, scene, spheres, k);
}

void updateGeometry(ContactList& list, const Scene& scene)
{
    updatePairs(list, scene, 0, list.blocks.size());
    for (std::size_t slot : list.slotsOfWalls) updateWall(list, scene, slot, list.blocks[slot/blockLanes].a[slot % blockLanes]);
    suppressGhosts(list, scene);
}

Vec3 distanceOfPair(const ContactList& list, const PeriodicBox& box, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    Vec3 x = list.position[block.a[slot % blockLanes]] - list.position[block.b[slot % blockLanes]];
    for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*box.length[axis];
    return x;
}

std::vector<KeptNormal> turnClosedNormals(ContactList& list, const PeriodicBox& box, double deadBand)
{
    std::vector<KeptNormal> before;
    std::vector<std::uint8_t> isKept(list.slots(), 0);
    for (std::size_t slot : list.aimedPairs) isKept[slot] = 1;
    const std::size_t ofSingleGrains = list.general.empty() ? list.slots() : list.general.firstBlock*blockLanes;
    list.halo.giveVelocities(list.bodies);
    forEachAwakeSlot(list, [&](std::size_t slot)
    {
        if (slot >= ofSingleGrains || !list.isUsed(slot) || list.wall[slot] >= 0 || isKept[slot] || !isClosed(list, slot, deadBand)) return;
        before.push_back({slot, normal(list, slot)});
        turnNormal(list, box, slot);
    });
    list.halo.takeVelocities(list.bodies);
    list.halo.giveVelocities(list.bodies);
    return before;
}

void setNormals(ContactList& list, const std::vector<KeptNormal>& normals)
{
    for (const KeptNormal& kept : normals) setSlot(list, kept.slot, kept.n, list.gap[kept.slot]);
}

} // namespace nscd
