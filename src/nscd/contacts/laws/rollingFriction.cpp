// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moments of rolling contacts, from step to step; kernels/momentKernel.hpp solves them.
#include "nscd/contacts/laws/rollingFriction.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/general/generalMoments.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

Vec3 inDisc(const Vec3& x, double radius)
{
    const double size = x.norm();
    return size > radius ? Vec3(x*(radius/size)) : x;
}

double within(double x, double limit) { return std::max(-limit, std::min(limit, x)); }

Vec3 vec3(const double (&of)[3][blockLanes], int lane) { return Vec3(of[0][lane], of[1][lane], of[2][lane]); }

void set(double (&of)[3][blockLanes], int lane, const Vec3& x)
{
    for (int k = 0; k < 3; ++k) of[k][lane] = x[k];
}

void add(double (&to)[3], const Vec3& change)
{
    for (int k = 0; k < 3; ++k) to[k] += change[k];
}

/// Cut to what the contact's normal impulse allows.
Vec3 admissible(const Vec3& q, const ContactBlock& block, const LawBlock& moments, int lane)
{
    const Vec3 n = vec3(block.n, lane);
    const double rn = std::max(0.0, n.dot(vec3(block.r, lane))), qn = n.dot(q);
    return inDisc(q - qn*n, moments.of[momentLaw::across][lane]*rn) + within(qn, moments.of[momentLaw::along][lane]*rn)*n;
}

} // namespace

void RollingFriction::set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB)
{
    LawBlock& block = blocks_[slot/blockLanes];
    const int lane = slot % blockLanes;
    nscd::set(block.q, lane, Vec3::Zero());
    block.of[momentLaw::across][lane] = pair.rollingFriction;
    block.of[momentLaw::along][lane] = pair.spinningFriction;
    block.of[momentLaw::shareB][lane] = radiusB > 0.0 ? radiusA/(radiusA + radiusB) : 1.0;
    block.of[momentLaw::shareA][lane] = radiusB > 0.0 ? 1.0 - block.of[momentLaw::shareB][lane] : 1.0;
}

void RollingFriction::copy(const ContactLaw& from, std::size_t source, std::size_t target)
{
    copyLane(static_cast<const RollingFriction&>(from).blocks_[source/blockLanes], source % blockLanes, blocks_[target/blockLanes], target % blockLanes);
}

void RollingFriction::startWarm(ContactList& list, double scale)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (impulse(slot) == Vec3::Zero()) continue;
        const int lane = slot % blockLanes;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        LawBlock& moments = blocks_[slot/blockLanes];
        const Vec3 q = admissible(scale*impulse(slot), block, moments, lane);
        nscd::set(moments.q, lane, q);
        if (!list.general.empty() && slot >= list.general.firstBlock*blockLanes)
        {
            giveGeneralMoment(list.bodies.data(), list.blocks.data(), blocks_.data(), list.general, slot, q);
            continue;
        }
        Body& a = list.bodies[block.a[lane]];
        Body& b = list.bodies[block.b[lane]];
        add(a.s, a.invSpin*moments.of[momentLaw::shareA][lane]*q);
        add(b.s, -b.invSpin*moments.of[momentLaw::shareB][lane]*q);
    }
}

Vec3 RollingFriction::impulse(std::size_t slot) const { return vec3(blocks_[slot/blockLanes].q, slot % blockLanes); }

void RollingFriction::setImpulse(std::size_t slot, const Vec3& q) { nscd::set(blocks_[slot/blockLanes].q, slot % blockLanes, q); }

Vec3 RollingFriction::moment(const ContactList& list, std::size_t slot) const
{
    return list.radius[list.blocks[slot/blockLanes].a[slot % blockLanes]]*blocks_[slot/blockLanes].of[momentLaw::shareA][slot % blockLanes]*impulse(slot);
}

void RollingFriction::addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (impulse(slot) == Vec3::Zero()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const Vec3 onA = moment(list, slot)/deltaT;
        sums.torque[block.a[slot % blockLanes]] += onA;
        sums.torque[block.b[slot % blockLanes]] -= onA;
        if (list.wall[slot] >= 0) sums.wall[scene.walls.patches.size() + scene.walls.regions[list.wall[slot]].patch] -= onA;
    }
}

} // namespace nscd
