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

double deepestOverlap(const ContactList& list)
{
    double deepest = 0.0;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (list.isUsed(slot)) deepest = std::max(deepest, -list.gap[slot]);
    }
    return deepest;
}

/// Contacts that overlap, or that a push of the deepest overlap could close.
std::vector<Push> collectPushes(const ContactList& list, double deepest, double target)
{
    std::vector<Push> pushes;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
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

} // namespace

int correctOverlaps(ContactList& list, const Scene& scene, double tolerance, double deadBand)
{
    const double deepest = deepestOverlap(list);
    if (!(deepest > tolerance)) return 0;

    std::vector<double> mobility(list.bodies.size(), 0.0);
    for (int body = 0; body < list.staticBody(); ++body)
    {
        const int i = list.grainOf[body];
        if (!scene.grains.isFixed[i]) mobility[body] = 1.0/scene.grains.mass[i];
    }
    std::vector<Vec3> shift(list.bodies.size(), Vec3::Zero());
    std::vector<Push> pushes = collectPushes(list, deepest, -0.5*deadBand);
    int sweeps = 0;
    double change = 0.0;
    do
    {
        change = sweepPushes(pushes, mobility, shift);
    }
    while (++sweeps < maxCorrectionSweeps && change > 0.1*tolerance);

    for (int body = 0; body < list.staticBody(); ++body) list.position[body] += shift[body];
    updateGeometry(list, scene);
    return sweeps;
}

} // namespace nscd
