// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which contacts attract, and what that adds to velocities and forces.
#include "nscd/contacts/laws/cohesion.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/wallForce.hpp"
#include "nscd/kernels/applyImpulse.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Walls that a grain must not feel have an endless gap: a bond with them is over.
bool isThere(const ContactList& list, std::size_t slot)
{
    return list.gap[slot] < list.radius[list.blocks[slot/blockLanes].a[slot % blockLanes]];
}

} // namespace

void markBonds(ContactList& list)
{
    for (std::size_t slot = 0; slot < list.cohesion.size(); ++slot)
    {
        CohesiveSlot& cohesive = list.cohesion[slot];
        cohesive.isBond = cohesive.force > 0.0 && impulse(list, slot).dot(normal(list, slot)) > 0.0 && isThere(list, slot);
    }
}

void applyCohesion(ContactList& list, double deltaT, double deadBand)
{
    for (std::size_t slot = 0; slot < list.cohesion.size(); ++slot)
    {
        CohesiveSlot& cohesive = list.cohesion[slot];
        const double gap = list.gap[slot];
        std::fill_n(cohesive.attraction, 3, 0.0);
        if (!(cohesive.force > 0.0) || !(cohesive.isBond || gap <= std::max(deadBand, cohesive.range))) continue;
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const Vec3 n = normal(list, slot);
        for (int k = 0; k < 3; ++k) cohesive.attraction[k] = -deltaT*cohesive.force*n[k];
        applyImpulse(list.bodies[block.a[lane]], list.bodies[block.b[lane]], n.data(), cohesive.attraction);
        if (cohesive.isBond && gap > deadBand) block.bias[lane] = (gap - deadBand)/deltaT;
    }
}

void addCohesionForces
(
    const ContactList& list, const Scene& scene, double deltaT, std::vector<Vec3>& force, std::vector<Vec3>& wall
)
{
    for (std::size_t slot = 0; slot < list.cohesion.size(); ++slot)
    {
        if (!list.cohesion[slot].isActing()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const Vec3 onA = Vec3(list.cohesion[slot].attraction)/deltaT;
        force[block.a[slot % blockLanes]] += onA;
        if (list.wall[slot] >= 0) addWallForce(list, scene, slot, onA, wall);
        else force[block.b[slot % blockLanes]] -= onA;
    }
}

} // namespace nscd
