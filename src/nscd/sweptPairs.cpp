// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs that are far apart and meet, or pass one another, within one step.
#include "contactStep.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Share of the radii's sum beyond which a gap is far: nearer ones turn by little within a step that closes them.
constexpr double farGap = 0.25;

/// Vector from b to a, through the periodic side that the slot is about.
Vec3 distanceOf(const ContactList& list, const PeriodicBox& box, std::size_t slot, int a, int b)
{
    Vec3 x = list.position[a] - list.position[b];
    for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*box.length[axis];
    return x;
}

} // namespace

void findFarPairs(ContactList& list)
{
    list.farPairs.clear();
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || list.wall[slot] >= 0) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const double radii = list.radius[block.a[slot % blockLanes]] + list.radius[block.b[slot % blockLanes]];
        if (list.gap[slot] > farGap*radii) list.farPairs.push_back(slot);
    }
}

void aimFarPairs(ContactList& list, const PeriodicBox& box, double deltaT)
{
    for (std::size_t slot : list.farPairs)
    {
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes, a = block.a[lane], b = block.b[lane];
        const double radii = list.radius[a] + list.radius[b];
        const Vec3 x = distanceOf(list, box, slot, a, b), u = Vec3(list.bodies[a].v) - Vec3(list.bodies[b].v);
        const double approach = -x.dot(u), speed2 = u.squaredNorm();
        if (!(x.norm() > (1.0 + farGap)*radii)) continue;
        // |x + u t| = radii at the smaller root, or nearest at -x.u/u.u where there is none.
        const double discriminant = std::max(0.0, approach*approach - speed2*(x.squaredNorm() - radii*radii));
        const double time = approach > 0.0 ? std::min(deltaT, (approach - std::sqrt(discriminant))/speed2) : 0.0;
        const Vec3 n = (x + time*u).normalized();
        for (int k = 0; k < 3; ++k) block.n[k][lane] = n[k];
        list.gap[slot] = n.dot(x) - radii;
    }
}

} // namespace nscd
