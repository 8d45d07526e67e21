// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Pairs that move by much of their size in a step, and meet, or pass one another, within it.
#include "nscd/step/sweptPairs.hpp"

#include "nscd/contacts/contactGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

/// Share of the radii's sum that a pair must move in a step to be aimed: slower ones turn by little before they meet.
constexpr double fastShare = 0.25;

/// Sets normal and gap to those at the place that a pair of grains comes to in `time`, along that normal; x = from b to a, u = its velocity.
void aim(ContactList& list, std::size_t slot, const Vec3& x, const Vec3& u, double radii, double time)
{
    const Vec3 n = (x + time*u).normalized();
    for (int k = 0; k < 3; ++k) list.blocks[slot/blockLanes].n[k][slot % blockLanes] = n[k];
    list.gap[slot] = n.dot(x) - radii;
}

} // namespace

void findFastPairs(ContactList& list)
{
    list.fastPairs.clear();
    list.aimedPairs.clear();
    // A member of a general body does not fly straight.
    const std::size_t ofSingleGrains = list.general.empty() ? list.slots() : list.general.firstBlock*blockLanes;
    for (std::size_t slot = 0; slot < ofSingleGrains; ++slot)
    {
        if (!list.isUsed(slot) || list.wall[slot] >= 0) continue;
        const int a = list.blocks[slot/blockLanes].a[slot % blockLanes], b = list.blocks[slot/blockLanes].b[slot % blockLanes];
        const double fast = fastShare*(list.radius[a] + list.radius[b]);
        const double left = fast - list.slackOf(a) - list.slackOf(b);
        const bool isFast = left < 0.0 || (list.pathOf(a) - list.pathOf(b)).squaredNorm() > left*left || list.gap[slot] > fast;
        if (isFast) list.fastPairs.push_back(slot);
    }
}

void aimFastPairs(ContactList& list, const PeriodicBox& box, double deltaT)
{
    constexpr double nearest = 1e-3;  // in radii: what is nearer than that touches, and is left alone
    const auto bodiesOf = [&list](std::size_t slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        return std::pair<int, int>(block.a[slot % blockLanes], block.b[slot % blockLanes]);
    };
    for (std::size_t slot : list.aimedPairs)
    {
        const auto [a, b] = bodiesOf(slot);
        aim(list, slot, distanceOfPair(list, box, slot), Vec3::Zero(), list.radius[a] + list.radius[b], 0.0);
    }
    list.aimedPairs.clear();
    for (std::size_t slot : list.fastPairs)
    {
        const auto [a, b] = bodiesOf(slot);
        const Vec3 u = Vec3(list.bodies[a].v) - Vec3(list.bodies[b].v);
        const double radii = list.radius[a] + list.radius[b], speed2 = u.squaredNorm(), fast = fastShare*radii;
        if (!(deltaT*deltaT*speed2 > fast*fast)) continue;
        const Vec3 x = distanceOfPair(list, box, slot);
        const double distance2 = x.squaredNorm(), approach = -x.dot(u), touching = (1.0 + nearest)*radii;
        if (!(distance2 > touching*touching && approach > 0.0)) continue;
        // |x + u t| = radii at the smaller root, or nearest at -x.u/u.u where there is none.
        const double discriminant = std::max(0.0, approach*approach - speed2*(distance2 - radii*radii));
        aim(list, slot, x, u, radii, std::min(deltaT, (approach - std::sqrt(discriminant))/speed2));
        list.aimedPairs.push_back(slot);
    }
}

} // namespace nscd
