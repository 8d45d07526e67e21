// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which contacts attract, and what that adds to velocities and forces.
#include "nscd/contacts/laws/cohesion.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/general/generalSweep.hpp"
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

void push(ContactList& list, std::size_t slot, const Vec3& onA)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    if (!list.general.empty() && slot >= list.general.firstBlock*blockLanes)
    {
        pushGeneral(list.bodies.data(), list.blocks.data(), list.general, slot, onA);
        return;
    }
    applyImpulse(list.bodies[block.a[lane]], list.bodies[block.b[lane]], normal(list, slot).data(), onA.data());
}

} // namespace

void Cohesion::set(std::size_t slot, const ContactPair& pair, double, double)
{
    slots_[slot] = {pair.cohesion, pair.cohesionRange, Vec3::Zero(), false};
}

void Cohesion::beginStep(const ContactList& list)
{
    for (std::size_t slot = 0; slot < slots_.size(); ++slot)
    {
        CohesiveSlot& cohesive = slots_[slot];
        cohesive.isBond = cohesive.force > 0.0 && nscd::impulse(list, slot).dot(normal(list, slot)) > 0.0 && isThere(list, slot);
    }
}

void Cohesion::giveKnown(ContactList& list, double deltaT, double deadBand)
{
    for (std::size_t slot = 0; slot < slots_.size(); ++slot)
    {
        CohesiveSlot& cohesive = slots_[slot];
        const double gap = list.gap[slot];
        cohesive.attraction.setZero();
        if (!(cohesive.force > 0.0) || !(cohesive.isBond || gap <= std::max(deadBand, cohesive.range))) continue;
        ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const Vec3 n = normal(list, slot);
        for (int k = 0; k < 3; ++k) cohesive.attraction[k] = -deltaT*cohesive.force*n[k];
        push(list, slot, cohesive.attraction);
        if (cohesive.isBond && gap > deadBand) block.bias[lane] = (gap - deadBand)/deltaT;
    }
}

} // namespace nscd
