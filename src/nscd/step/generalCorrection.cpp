// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlaps of general bodies are removed as others are, by displacements that give no velocity, and by turns.
#include "nscd/step/generalCorrection.hpp"

#include "nscd/base/freeRotation.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/contacts/generalCandidates.hpp"
#include "nscd/step/generalMotion.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr int maxCorrectionSweeps = 50;

/// What moves one side of a contact: a general body, or one of the list, and its turn per impulse along n.
struct Side
{
    int owner;     ///< general body, or -1
    int body;      ///< of the list
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

/// Where bodies have been moved.
struct Displacements
{
    GeneralHalo::Motions general;   ///< shift [m] and turn [rad] of each general body
    std::vector<Vec3> shift;        ///< of each body of the list, members apart [m]

    explicit Displacements(const ContactList& list)
    :
        general(GeneralHalo::width*list.general.bodies.size(), 0.0),
        shift(list.bodies.size(), Vec3::Zero())
    {}

    Eigen::Map<Vec3> shiftOf(int owner) { return Eigen::Map<Vec3>(&general[GeneralHalo::width*owner]); }
    Eigen::Map<Vec3> turnOf(int owner) { return Eigen::Map<Vec3>(&general[GeneralHalo::width*owner + 3]); }
};

/// Mobility of a body of the list that is moved alone, n/m where n ranks push it.
double singleMobility(const ContactList& list, int body)
{
    if (body >= list.firstWallBody()) return 0.0;
    return list.inverseMass[body]*(body < list.owned() ? 1.0 : list.halo.parts(body));
}

/// Between ranks the copy of a general body moves, where it has one.
Side makeSide(const ContactList& list, int body, const Vec3& n, bool isBetweenRanks)
{
    const int number = list.general.member(body);
    if (number < 0) return {-1, body, singleMobility(list, body), Vec3::Zero(), Vec3::Zero()};
    const GeneralMember& member = list.general.members[number];
    const int owner = isBetweenRanks ? list.general.halo.inInterface(member.owner) : member.owner;
    const GeneralBody& general = list.general.bodies[owner];
    const Vec3 moment = member.arm.cross(n);
    return {owner, body, general.invMass, moment, general.invInertia*moment};
}

Push makePush(const ContactList& list, std::size_t slot, double target)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    const Vec3 n = normal(list, slot);
    const bool isBetween = isBetweenRanks(list, slot);
    return {makeSide(list, block.a[lane], n, isBetween), makeSide(list, block.b[lane], n, isBetween), n, target - list.gap[slot]};
}

/// The arms are those of the step's start: what a step turns changes little in them, and the next pass sees the true gaps.
std::vector<Push> collectPushes(const ContactList& list, double deepest, double target, bool areBetweenRanks)
{
    std::vector<Push> pushes;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || list.gap[slot] > 2.0*deepest || isBetweenRanks(list, slot) != areBetweenRanks) continue;
        pushes.push_back(makePush(list, slot, target));
    }
    return pushes;
}

/// At walls that the list lacks.
void addPushes(const ContactList& list, const std::vector<WallGap>& missed, double target, std::vector<Push>& pushes)
{
    for (const WallGap& wall : missed)
    {
        const Vec3& n = wall.normal;
        pushes.push_back({makeSide(list, wall.body, n, false), makeSide(list, list.staticBody(), n, false), n, target - wall.gap});
    }
}

double along(const Side& side, const Vec3& n, Displacements& moved)
{
    if (side.owner < 0) return n.dot(moved.shift[side.body]);
    return n.dot(moved.shiftOf(side.owner)) + side.moment.dot(moved.turnOf(side.owner));
}

void move(const Side& side, const Vec3& n, double push, Displacements& moved)
{
    if (side.owner < 0) moved.shift[side.body] += side.invMass*push*n;
    else
    {
        moved.shiftOf(side.owner) += side.invMass*push*n;
        moved.turnOf(side.owner) += push*side.turn;
    }
}

/// Largest change of a push in one sweep [m].
double sweepPushes(std::vector<Push>& pushes, Displacements& moved)
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

/// One sweep over pushes between two ranks. Returns the largest change [m].
double sweepInterface(const ContactList& list, std::vector<Push>& pushes, Displacements& moved)
{
    list.halo.give(moved.shift);
    list.general.halo.give(moved.general);
    const std::vector<Vec3> given(moved.shift.begin() + list.owned(), moved.shift.begin() + list.firstWallBody());
    const GeneralHalo::Motions generalGiven = moved.general;
    const double largest = sweepPushes(pushes, moved);
    list.halo.takeChanges(moved.shift, given);
    list.general.halo.take(moved.general, generalGiven);
    return largest;
}

void displaceAll(ContactList& list, Grains& grains, const PeriodicBox& box, Displacements& moved)
{
    for (std::size_t k = 0; k < list.general.own(); ++k)
    {
        const int general = static_cast<int>(k);
        displace(grains, list.general.clumpOf[k], moved.shiftOf(general), moved.turnOf(general), box);
    }
    for (int body = 0; body < list.owned(); ++body) list.position[body] += moved.shift[body];
    putMembers(list, grains, box);
    list.halo.give(list.position);
}

} // namespace

int correctGeneralOverlaps
(
    ContactList& list, Grains& grains, const Scene& scene, const std::vector<WallGap>& missed, double deepest, double tolerance, double deadBand
)
{
    Displacements moved(list);
    std::vector<Push> inner = collectPushes(list, deepest, -0.5*deadBand, false), between = collectPushes(list, deepest, -0.5*deadBand, true);
    addPushes(list, missed, -0.5*deadBand, inner);
    int sweeps = 0;
    double change = 0.0;
    do
    {
        change = sweepPushes(inner, moved);
        if (list.halo.isParallel()) change = list.halo.max(std::max(change, sweepInterface(list, between, moved)));
    }
    while (++sweeps < maxCorrectionSweeps && change > 0.1*tolerance);

    displaceAll(list, grains, scene.box, moved);
    updateGeometry(list, scene);
    return sweeps;
}

} // namespace nscd
