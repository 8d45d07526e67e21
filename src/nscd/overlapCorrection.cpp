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

/// Largest change of a push in one sweep [m].
double sweepPushes(std::vector<Push>& pushes, const std::vector<double>& mobility, std::vector<Vec3>& shift)
{
    double largest = 0.0;
    for (Push& push : pushes)
    {
        const double w = mobility[push.a] + mobility[push.b];
        const double missing = push.required - push.n.dot(shift[push.a] - shift[push.b]);
        const double size = std::max(0.0, push.size + missing/w);
        const double change = size - push.size;
        push.size = size;
        shift[push.a] += mobility[push.a]*change*push.n;
        shift[push.b] -= mobility[push.b]*change*push.n;
        largest = std::max(largest, w*std::abs(change));
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

/// One sweep over pushes between two ranks. Returns the largest change [m].
double sweepInterface(const ContactList& list, std::vector<Push>& pushes, const std::vector<double>& mobility, std::vector<Vec3>& shift)
{
    list.halo.give(shift);
    const std::vector<Vec3> given(shift.begin() + list.owned(), shift.begin() + list.firstWallBody());
    const double largest = sweepPushes(pushes, mobility, shift);
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
    const std::vector<double> mobility = pushMobility(list);
    std::vector<Vec3> shift(list.bodies.size(), Vec3::Zero());
    const std::size_t interface = list.interfaceBlock*blockLanes;
    std::vector<Push> inner = collectPushes(list, 0, interface, deepest, -0.5*deadBand);
    std::vector<Push> between = collectPushes(list, interface, list.slots(), deepest, -0.5*deadBand);
    int sweeps = 0;
    double change = 0.0;
    do
    {
        change = sweepPushes(inner, mobility, shift);
        if (list.halo.isParallel()) change = list.halo.max(std::max(change, sweepInterface(list, between, mobility, shift)));
    }
    while (++sweeps < maxCorrectionSweeps && change > 0.1*tolerance);

    list.halo.give(shift);
    for (int body = 0; body < list.firstWallBody(); ++body) list.position[body] += shift[body];
    updateGeometry(list, scene);
    return sweeps;
}

} // namespace nscd
