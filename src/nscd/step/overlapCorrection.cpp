// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlap is removed by displacements, never through velocities: that would pump energy into deep beds.
#include "nscd/step/overlapCorrection.hpp"

#include "nscd/contacts/contactGeometry.hpp"

#include <algorithm>
#include <cstdint>

namespace nscd
{

namespace
{

constexpr int maxCorrectionSweeps = 50;
/// Between two sweeps over all pushes those are swept over whose bodies moved in the first: one in seven in a collapse.
constexpr int sweepsOfWorking = 4;
/// Of the overlap allowed.
constexpr double exactness = 0.1;

/// One near contact of the correction: n.(dx_a - dx_b) >= target - gap, with its accumulated push.
struct Push
{
    int a;
    int b;
    Vec3 n;
    double required;
    double size = 0.0;
};

/// Contacts of the slots first..last that overlap, or that a push of the deepest overlap could close.
std::vector<Push> collectPushes(const ContactList& list, std::size_t first, std::size_t last, double deepest, double target)
{
    std::vector<Push> pushes;
    for (std::size_t slot = first; slot < last; ++slot)
    {
        if (!list.isUsed(slot) || list.gap[slot] > 2.0*deepest) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        pushes.push_back({block.a[lane], block.b[lane], normal(list, slot), target - list.gap[slot]});
    }
    return pushes;
}

/// At walls that the list lacks.
void addPushes(const ContactList& list, const std::vector<WallGap>& missed, double target, std::vector<Push>& pushes)
{
    for (const WallGap& wall : missed) pushes.push_back({wall.body, list.staticBody(), wall.normal, target - wall.gap});
}

/// What moves bodies, and where it has moved them.
struct Shifts
{
    std::vector<double> mobility;
    std::vector<Vec3> shift;       ///< [m]
    std::vector<int> lastMoved;    ///< sweep in which a body moved by more than is negligible
    double negligible;             ///< [m]
    int sweep = 0;

    bool hasMoved(const Push& push, int since) const { return lastMoved[push.a] >= since || lastMoved[push.b] >= since; }

    void move(int body, const Vec3& by)
    {
        shift[body] += by;
        if (mobility[body] > 0.0) lastMoved[body] = sweep;
    }
};

/// Returns the change of a push [m].
double sweepPush(Push& push, Shifts& shifts)
{
    const std::vector<double>& mobility = shifts.mobility;
    const double w = mobility[push.a] + mobility[push.b];
    const double missing = push.required - push.n.dot(shifts.shift[push.a] - shifts.shift[push.b]);
    const double size = std::max(0.0, push.size + missing/w);
    const double change = size - push.size;
    const double way = w*std::abs(change);
    if (way <= shifts.negligible) return 0.0;
    push.size = size;
    shifts.move(push.a, mobility[push.a]*change*push.n);
    shifts.move(push.b, -mobility[push.b]*change*push.n);
    return way;
}

/// Largest change of a push in one sweep [m]. Pushes between bodies that have not moved since they were looked at are what they were.
double sweepPushes(std::vector<Push>& pushes, Shifts& shifts, int since)
{
    double largest = 0.0;
    for (Push& push : pushes)
    {
        if (shifts.hasMoved(push, since)) largest = std::max(largest, sweepPush(push, shifts));
    }
    return largest;
}

/// Pushes between bodies of this rank, and those of them whose bodies moved when all were last looked at.
struct InnerPushes
{
    std::vector<Push> all;
    std::vector<std::uint32_t> working;
    int lastWhole = 0;   ///< sweep
};

double sweepWhole(InnerPushes& pushes, Shifts& shifts)
{
    const double largest = sweepPushes(pushes.all, shifts, pushes.lastWhole);
    pushes.lastWhole = shifts.sweep;
    pushes.working.clear();
    for (std::uint32_t k = 0; k < pushes.all.size(); ++k)
    {
        if (shifts.hasMoved(pushes.all[k], shifts.sweep)) pushes.working.push_back(k);
    }
    return largest;
}

double sweepWorking(InnerPushes& pushes, Shifts& shifts)
{
    double largest = 0.0;
    for (std::uint32_t k : pushes.working)
    {
        if (shifts.hasMoved(pushes.all[k], shifts.sweep - 1)) largest = std::max(largest, sweepPush(pushes.all[k], shifts));
    }
    return largest;
}

/// 1/m, and n/m of the bodies that n ranks push.
std::vector<double> pushMobility(const ContactList& list)
{
    std::vector<double> mobility = list.inverseMass;
    for (std::size_t body = list.owned(); body < mobility.size(); ++body) mobility[body] *= list.halo.parts(static_cast<int>(body));
    mobility.resize(list.bodies.size(), 0.0);
    return mobility;
}

/// One sweep over pushes between two ranks, after which any body may have moved. Returns the largest change [m].
double sweepInterface(const ContactList& list, std::vector<Push>& pushes, Shifts& shifts)
{
    std::vector<Vec3>& shift = shifts.shift;
    list.halo.give(shift);
    const std::vector<Vec3> given(shift.begin() + list.owned(), shift.begin() + list.firstWallBody());
    std::fill(shifts.lastMoved.begin(), shifts.lastMoved.end(), shifts.sweep);
    const double largest = sweepPushes(pushes, shifts, shifts.sweep);
    list.halo.takeChanges(shift, given);
    return largest;
}

} // namespace

int correctOverlaps
(
    ContactList& list, const Scene& scene, const std::vector<WallGap>& missed, double deepest, double tolerance, double deadBand
)
{
    Shifts shifts{pushMobility(list), std::vector<Vec3>(list.bodies.size(), Vec3::Zero()), std::vector<int>(list.bodies.size(), 0), 0.01*exactness*tolerance};
    const std::size_t interface = list.interfaceBlock*blockLanes;
    // No finer than the sweeps below stop at.
    const double target = -std::max(0.5*deadBand, exactness*tolerance);
    InnerPushes inner{collectPushes(list, 0, interface, deepest, target), {}};
    addPushes(list, missed, target, inner.all);
    std::vector<Push> between = collectPushes(list, interface, list.slots(), deepest, target);
    const double negligibleChange = exactness*tolerance;
    double change = 0.0;
    bool isWhole = false;
    do
    {
        ++shifts.sweep;
        isWhole = change <= negligibleChange || shifts.sweep - inner.lastWhole > sweepsOfWorking;
        change = isWhole ? sweepWhole(inner, shifts) : sweepWorking(inner, shifts);
        if (list.halo.isParallel()) change = list.halo.max(std::max(change, sweepInterface(list, between, shifts)));
    }
    while (shifts.sweep < maxCorrectionSweeps && !(isWhole && change <= negligibleChange));

    list.halo.give(shifts.shift);
    for (int body = 0; body < list.firstWallBody(); ++body) list.position[body] += shifts.shift[body];
    updateGeometry(list, scene);
    return shifts.sweep;
}

} // namespace nscd
