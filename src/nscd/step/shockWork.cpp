// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The energy account of a shock.
#include "nscd/step/shockWork.hpp"

#include "nscd/kernels/applyImpulse.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// target + share (list - target), for velocities and impulses.
void moveBetween(ContactList& list, const Shock& target, double share)
{
    const auto blend = [share](double& value, double end) { value = end + share*(value - end); };
    for (std::size_t i = 0; i < list.bodies.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            blend(list.bodies[i].v[k], target.bodies[i].v[k]);
            blend(list.bodies[i].s[k], target.bodies[i].s[k]);
        }
    }
    for (std::size_t c = 0; c < list.general.bodies.size(); ++c)
    {
        for (int k = 0; k < 3; ++k)
        {
            blend(list.general.bodies[c].v[k], target.general[c].v[k]);
            blend(list.general.bodies[c].omega[k], target.general[c].omega[k]);
        }
    }
    constexpr std::size_t values = 3*blockLanes;
    for (std::size_t k = 0; k < values*target.blocks.size(); ++k)
    {
        auto& r = (&list.blocks[target.blocks[k/values]].r[0][0])[k % values];
        r = target.impulses[k] + share*(r - target.impulses[k]);
    }
    for (std::size_t slot = 0; slot < target.ofLaws.size(); ++slot)
    {
        LawImpulses impulses = list.laws.impulses(slot);
        for (std::size_t m = 0; m < lawImpulses; ++m)
        for (int axis = 0; axis < 3; ++axis) blend(impulses[m][axis], target.ofLaws[slot][m][axis]);
        list.laws.setImpulses(slot, impulses);
    }
}

/// Velocities without contacts, and no impulses.
void setFree(ContactList& list, const std::vector<Body>& freeBodies)
{
    list.bodies = freeBodies;
    for (GeneralBody& body : list.general.bodies)
    {
        body.v = body.freeV;
        body.omega = body.freeOmega;
    }
    for (std::uint32_t k : list.awake) std::fill_n(&list.blocks[k].r[0][0], 3*blockLanes, 0.0);
    for (std::size_t slot = 0; slot < list.slots() && list.laws.haveImpulses(); ++slot) list.laws.setImpulses(slot, noLawImpulses());
}

/// Of the contacts that rebound, weighted by what presses on them in the list [-].
double meanRestitution(const ContactList& list)
{
    double sums[2] = {0.0, 0.0};
    forEachAwakeSlot(list, [&](std::size_t slot)
    {
        const bool isRebounding = list.blocks[slot/blockLanes].bias[slot % blockLanes] < 0.0;
        const double pressure = isRebounding ? std::max(0.0, impulse(list, slot).dot(normal(list, slot))) : 0.0;
        sums[0] += pressure*list.restitution[slot];
        sums[1] += pressure;
    });
    list.halo.sum(sums, 2);
    return sums[1] > 0.0 ? sums[0]/sums[1] : 0.0;
}

} // namespace

ShockWork shockWork(const ContactList& list, const std::vector<Body>& freeBodies, double residual)
{
    constexpr double roundOff = 1e-13;
    double sums[3] = {0.0, 0.0, 0.0};  // work, its size, squared impulses
    forEachAwakeSlot(list, [&](std::size_t slot)
    {
        const Vec3 r = impulse(list, slot);
        if (r == Vec3::Zero()) return;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        const Vec3 n = normal(list, slot);
        const Vec3 before = relativeVelocity(freeBodies[a], freeBodies[b], n), after = relativeVelocity(list.bodies[a], list.bodies[b], n);
        sums[0] += 0.5*r.dot(before + after);
        sums[1] += 0.5*r.norm()*(before.norm() + after.norm());
        sums[2] += r.squaredNorm();
    });
    list.halo.sum(sums, 3);
    return {sums[0], residual*std::sqrt(sums[2]) + roundOff*sums[1]};
}

double impactsOfAGrain(const ContactList& list)
{
    const auto moves = [&](int body) { return list.bodies[body].invMass > 0.0 ? 1.0 : 0.0; };
    double sums[2] = {0.0, 0.0};  // impacts, grains
    forEachAwakeSlot(list, [&](std::size_t slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const bool isImpact = block.bias[lane] < 0.0 && impulse(list, slot).dot(normal(list, slot)) > 0.0;
        if (isImpact) sums[0] += moves(block.a[lane]) + moves(block.b[lane]);
    });
    for (int body = 0; body < list.owned(); ++body) sums[1] += moves(body);
    list.halo.sum(sums, 2);
    return sums[0]/std::max(sums[1], 1.0);
}

double limitRebound(ContactList& list, const std::vector<Body>& freeBodies, const Shock& inelastic)
{
    // The work is a parabola of the share: three points of it on the way back, then its root.
    const double atOne = shockWork(list, freeBodies, 0.0).work;
    moveBetween(list, inelastic, 0.5);
    const double atHalf = shockWork(list, freeBodies, 0.0).work;
    moveBetween(list, inelastic, 0.5);
    const double atQuarter = shockWork(list, freeBodies, 0.0).work;
    const double a = 8.0/3.0*(atOne - 3.0*atHalf + 2.0*atQuarter), b = 2.0*(atOne - atHalf) - 1.5*a, c = atOne - a - b;
    const double share = c < 0.0 ? std::min(1.0, -2.0*c/(b + std::sqrt(std::max(0.0, b*b - 4.0*a*c)))) : 0.0;
    moveBetween(list, inelastic, share/0.25);
    return share;
}

void reboundOfMotion(ContactList& list, const std::vector<Body>& freeBodies, const Shock& inelastic)
{
    setFree(list, freeBodies);
    moveBetween(list, inelastic, 0.0);
    const double e = meanRestitution(list);
    setFree(list, freeBodies);
    moveBetween(list, inelastic, -e);
}

} // namespace nscd
