// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs that move by much of their size in a step, and meet, or pass one another, within it.
#include "contactStep.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Share of the radii's sum that a pair must move in a step to be aimed: slower ones turn by little before they meet.
constexpr double fastShare = 0.25;

/// Vector from b to a, through the periodic side that the slot is about.
Vec3 distanceOf(const ContactList& list, const PeriodicBox& box, std::size_t slot, int a, int b)
{
    Vec3 x = list.position[a] - list.position[b];
    for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*box.length[axis];
    return x;
}

} // namespace

void findFastPairs(ContactList& list)
{
    list.fastPairs.clear();
    const auto reach = [&list](int body) { return body < list.owned() ? list.reach[body] : 0.0; };
    // A member of a clump does not fly straight.
    const std::size_t ofSingleGrains = list.clumps.empty() ? list.slots() : list.clumps.firstBlock*blockLanes;
    for (std::size_t slot = 0; slot < ofSingleGrains; ++slot)
    {
        if (!list.isUsed(slot) || list.wall[slot] >= 0) continue;
        const int a = list.blocks[slot/blockLanes].a[slot % blockLanes], b = list.blocks[slot/blockLanes].b[slot % blockLanes];
        const double fast = fastShare*(list.radius[a] + list.radius[b]);
        if (reach(a) + reach(b) > fast || list.gap[slot] > fast) list.fastPairs.push_back(slot);
    }
}

void aimFastPairs(ContactList& list, const PeriodicBox& box, double deltaT)
{
    constexpr double nearest = 1e-3;  // in radii: what is nearer than that touches, and is left alone
    for (std::size_t slot : list.fastPairs)
    {
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes, a = block.a[lane], b = block.b[lane];
        const double radii = list.radius[a] + list.radius[b];
        const Vec3 x = distanceOf(list, box, slot, a, b), u = Vec3(list.bodies[a].v) - Vec3(list.bodies[b].v);
        const double distance2 = x.squaredNorm(), speed2 = u.squaredNorm(), touching = (1.0 + nearest)*radii, fast = fastShare*radii;
        if (!(distance2 > touching*touching)) continue;
        // |x + u t| = radii at the smaller root, or nearest at -x.u/u.u where there is none.
        const double approach = -x.dot(u), discriminant = std::max(0.0, approach*approach - speed2*(distance2 - radii*radii));
        const bool isAimed = approach > 0.0 && deltaT*deltaT*speed2 > fast*fast;
        const double time = isAimed ? std::min(deltaT, (approach - std::sqrt(discriminant))/speed2) : 0.0;
        const Vec3 n = (x + time*u).normalized();
        for (int k = 0; k < 3; ++k) block.n[k][lane] = n[k];
        list.gap[slot] = n.dot(x) - radii;
    }
}

} // namespace nscd
