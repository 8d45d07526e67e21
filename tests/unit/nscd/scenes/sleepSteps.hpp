// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Steps of scenes whose grains fall asleep.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

namespace scenes
{

constexpr double sleepDeltaT = 1e-3;   ///< [s]

/// Where something moves nothing is polished, and the noise of coarse solves keeps grains awake: so the tolerance is a fine one.
inline nscd::ContactSettings fineEnoughToSleep()
{
    nscd::ContactSettings settings;
    settings.tolerance = 1e-6;
    return settings;
}

/// Steps under the weight alone.
inline nscd::StepReport run(nscd::GrainDynamics& dynamics, int steps)
{
    nscd::StepReport report;
    for (int k = 0; k < steps; ++k) report = step(dynamics, Vec3(0, 0, -gravity), sleepDeltaT);
    return report;
}

inline nscd::StepReport stepWith(nscd::GrainDynamics& dynamics, const nscd::ExternalForces& forces)
{
    dynamics.beginStep(sleepDeltaT);
    return dynamics.advance(forces);
}

/// Weight, and on the grain of one identity, if it is here, a force besides, in units of its weight.
inline nscd::ExternalForces pushedOne(const nscd::Grains& own, std::int64_t id, const Vec3& part)
{
    nscd::ExternalForces forces = weight(own, Vec3(0, 0, -gravity), sleepDeltaT);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        if (own.id[i] == id) forces.force[i] += gravity*own.mass[i]*part;
    }
    return forces;
}

inline nscd::StepReport stepPushed(nscd::GrainDynamics& dynamics, std::int64_t id, const Vec3& part)
{
    return stepWith(dynamics, pushedOne(dynamics.grains(), id, part));
}

} // namespace scenes
