// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Newton's second law over a step, from the contacts that a scene reports.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <algorithm>

namespace scenes
{

/// Sum of the impulses of contacts on each grain [N s]; grains by their identities, which are 0, 1, ...
inline std::vector<Vec3> sumOfImpulses(const std::vector<nscd::LoadedContact>& contacts, std::size_t grains)
{
    std::vector<Vec3> sum(grains, Vec3::Zero());
    for (const nscd::LoadedContact& c : contacts)
    {
        sum[static_cast<std::size_t>(c.idA)] += c.impulse;
        if (c.idB >= 0) sum[static_cast<std::size_t>(c.idB)] -= c.impulse;
    }
    return sum;
}

/// The largest |sum of impulses - (m dv - m g dt)| of the grains that `counts` names, in the largest m |dv| or m |g| dt among them.
template<class Counts>
double worstImbalance
(
    const nscd::Grains& before, const nscd::Grains& after, const std::vector<Vec3>& impulses, const Vec3& g, double deltaT, const Counts& counts
)
{
    double worst = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        if (!counts(i)) continue;
        const Vec3 gained = before.mass[i]*(after.velocity[i] - before.velocity[i] - deltaT*g);
        worst = std::max(worst, (impulses[i] - gained).norm());
        scale = std::max({scale, gained.norm(), before.mass[i]*deltaT*g.norm()});
    }
    return scale > 0.0 ? worst/scale : 0.0;
}

} // namespace scenes
