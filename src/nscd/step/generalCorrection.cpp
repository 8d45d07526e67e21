// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlaps of general bodies are removed as others are, by displacements that give no velocity, and by turns.
#include "nscd/step/generalCorrection.hpp"

#include "nscd/base/freeRotation.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/step/generalMotion.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr int maxCorrectionSweeps = 50;

/// What moves one side of a contact: number of a body, general ones before single ones, and its turn per impulse along n.
struct Side
{
    std::size_t body;
    double invMass;
    Vec3 moment;   ///< arm x n of a general body [m]
    Vec3 turn;     ///< J^-1 of that [1/(kg m)]

    double mobility() const { return invMass + moment.dot(turn); }
};

/// n.(dx_a - dx_b) >= required at the contact, with its accumulated push.
struct Push
{
    Side a;
    Side b;
    Vec3 n;
    double required;
    double size = 0.0;
};

struct Displacement
{
    Vec3 shift = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
};

Side makeSide(const ContactList& list, int body, const Vec3& n)
{
    const std::size_t general = list.general.bodies.size();
    const int number = body < list.owned() ? list.general.memberOf[body] : -1;
    if (number < 0)
    {
        const double invMass = body < list.owned() ? list.inverseMass[body] : 0.0;
        return {general + body, invMass, Vec3::Zero(), Vec3::Zero()};
    }
    const GeneralMember& member = list.general.members[number];
    const GeneralBody& owner = list.general.bodies[member.owner];
    const Vec3 moment = member.arm.cross(n);
    return {static_cast<std::size_t>(member.owner), owner.invMass, moment, owner.invInertia*moment};
}

/// The arms are those of the step's start: what a step turns changes little in them, and the next pass sees the true gaps.
std::vector<Push> collectPushes(const ContactList& list, double deepest, double target)
{
    std::vector<Push> pushes;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || list.gap[slot] > 2.0*deepest) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        const Vec3 n = normal(list, slot);
        pushes.push_back({makeSide(list, block.a[lane], n), makeSide(list, block.b[lane], n), n, target - list.gap[slot]});
    }
    return pushes;
}

double along(const Side& side, const Vec3& n, const std::vector<Displacement>& moved)
{
    return n.dot(moved[side.body].shift) + side.moment.dot(moved[side.body].turn);
}

void move(const Side& side, const Vec3& n, double push, std::vector<Displacement>& moved)
{
    moved[side.body].shift += side.invMass*push*n;
    moved[side.body].turn += push*side.turn;
}

/// Largest change of a push in one sweep [m].
double sweepPushes(std::vector<Push>& pushes, std::vector<Displacement>& moved)
{
    double largest = 0.0;
    for (Push& push : pushes)
    {
        const double w = push.a.mobility() + push.b.mobility();
        const double missing = push.required - along(push.a, push.n, moved) + along(push.b, push.n, moved);
        const double size = std::max(0.0, push.size + missing/w), change = size - push.size;
        push.size = size;
        move(push.a, push.n, change, moved);
        move(push.b, push.n, -change, moved);
        largest = std::max(largest, w*std::abs(change));
    }
    return largest;
}

} // namespace

int correctGeneralOverlaps(ContactList& list, Grains& grains, const Scene& scene, double deepest, double tolerance, double deadBand)
{
    const std::size_t general = list.general.bodies.size();
    std::vector<Displacement> moved(general + list.bodies.size());
    std::vector<Push> pushes = collectPushes(list, deepest, -0.5*deadBand);
    int sweeps = 0;
    double change = 0.0;
    do
    {
        change = sweepPushes(pushes, moved);
    }
    while (++sweeps < maxCorrectionSweeps && change > 0.1*tolerance);

    for (std::size_t k = 0; k < general; ++k) displace(grains, k, moved[k].shift, moved[k].turn, scene.box);
    for (int body = 0; body < list.owned(); ++body) list.position[body] += moved[general + body].shift;
    putMembers(list, grains, scene.box);
    updateGeometry(list, scene);
    return sweeps;
}

} // namespace nscd
