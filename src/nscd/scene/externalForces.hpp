// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What acts on the grains from outside during one step.
// Tested by tests/unit/nscd/step/contactStepTest.cpp
#pragma once

#include "nscd/base/vec3.hpp"

#include <vector>

namespace nscd
{

/// Everything that acts on the grains from outside during one step. Empty arrays mean zero.
struct ExternalForces
{
    /// f_e [N]: gravity and buoyancy, pressure, explicit drag, and implicitDrag times the fluid velocity.
    std::vector<Vec3> force;
    /// Torque [N m].
    std::vector<Vec3> torque;
    /// Coefficient gamma [kg/s] of a drag -gamma v that is implicit in the grain's own new velocity.
    std::vector<double> implicitDrag;
    /// Coefficient C [N m s] of a torque -C omega that is implicit in the grain's own new spin.
    std::vector<double> implicitSpinDrag;
    /// Largest rms over the grains of dt f/(m + gamma dt) among the forces taken one by one [m/s]; scales the stop rule.
    double speedScale = 0.0;
};

} // namespace nscd
