// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlap is removed by displacements, never through velocities: that would pump energy into deep beds.
#include "contactStep.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int maxCorrectionSweeps = 50;
/// Of the overlap allowed.
constexpr double exactness = 0.1;

/// One near contact of the correction: n.(dx_a - dx_b) >= target - gap, with its accumulated push.
struct Push
{
    std::size_t slot;
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
        pushes.push_back({slot, block.a[lane], block.b[lane], normal(list, slot), target - list.gap[slot]});
    }
    return pushes;
}

/// What moves bodies, and where it has moved them.
struct Shifts
{
    std::vector<double> mobility;
    std::vector<Vec3> shift;       ///< [m]
    std::vector<int> lastMoved;    ///< sweep in which a body moved by more than is negligible
    double negligible;             ///< [m]
    int sweep = 0;

    bool isMoving(int body) const { return lastMoved[body] >= sweep - 1; }

    void move(int body, const Vec3& by)
    {
        shift[body] += by;
        if (mobility[body] > 0.0) lastMoved[body] = sweep;
    }
};

/// Largest change of a push in one sweep [m]. Pushes between bodies that have not moved since they were looked at are what they were.
double sweepPushes(std::vector<Push>& pushes, Shifts& shifts)
{
    const std::vector<double>& mobility = shifts.mobility;
    std::vector<Vec3>& shift = shifts.shift;
    double largest = 0.0;
    for (Push& push : pushes)
    {
        if (!shifts.isMoving(push.a) && !shifts.isMoving(push.b)) continue;
        const double w = mobility[push.a] + mobility[push.b];
        const double missing = push.required - push.n.dot(shift[push.a] - shift[push.b]);
        const double size = std::max(0.0, push.size + missing/w);
        const double change = size - push.size;
        const double way = w*std::abs(change);
        if (way <= shifts.negligible) continue;
        push.size = size;
        shifts.move(push.a, mobility[push.a]*change*push.n);
        shifts.move(push.b, -mobility[push.b]*change*push.n);
        largest = std::max(largest, way);
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
    const double largest = sweepPushes(pushes, shifts);
    for (std::size_t k = 0; k < given.size(); ++k)
    {
        Vec3& x = shift[list.owned() + k];
        x = (x - given[k])/list.halo.parts(list.owned() + static_cast<int>(k));
    }
    list.halo.take(shift);
    return largest;
}

} // namespace

int correctOverlaps(ContactList& list, const Scene& scene, double deepest, double tolerance, double deadBand)
{
    Shifts shifts{pushMobility(list), std::vector<Vec3>(list.bodies.size(), Vec3::Zero()), std::vector<int>(list.bodies.size(), 0), 0.01*exactness*tolerance};
    const std::size_t interface = list.interfaceBlock*blockLanes;
    // No finer than the sweeps below stop at.
    const double target = -std::max(0.5*deadBand, exactness*tolerance);
    std::vector<Push> inner = collectPushes(list, 0, interface, deepest, target);
    std::vector<Push> between = collectPushes(list, interface, list.slots(), deepest, target);
    double change = 0.0;
    do
    {
        ++shifts.sweep;
        change = sweepPushes(inner, shifts);
        if (list.halo.isParallel()) change = list.halo.max(std::max(change, sweepInterface(list, between, shifts)));
    }
    while (shifts.sweep < maxCorrectionSweeps && change > exactness*tolerance);

    list.halo.give(shifts.shift);
    for (int body = 0; body < list.firstWallBody(); ++body) list.position[body] += shifts.shift[body];
    updateGeometry(list, scene);
    return shifts.sweep;
}

} // namespace nscd
