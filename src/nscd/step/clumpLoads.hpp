// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What acts on clumps as wholes, and whether it matters: for clumps that sleep.
// Tested by tests/unit/nscd/step/clumpSleepTest.cpp
#pragma once

#include "nscd/scene/grains.hpp"

#include <vector>

namespace nscd
{

/// Force and torque about the mass center, or a change of both.
struct ClumpLoad
{
    Vec3 force = Vec3::Zero();    ///< [N]
    Vec3 torque = Vec3::Zero();   ///< [N m]

    /// Adds a force that acts at `arm` from the mass center, and a torque.
    void add(const Vec3& f, const Vec3& t, const Vec3& arm)
    {
        force += f;
        torque += t + arm.cross(f);
    }
};

/// Whether a load gives a free clump, in a step, less than `speed`, and no point of its surface more than that by its spin; of the latter 1/kappa of it, as
/// R times the spin of a single grain may: R dt T/(kappa m R^2) for T = m R speed/dt. False for what is not a number.
/// Units: speed [m/s], deltaT [s]
bool isSmall(const Grains& grains, int clump, const ClumpLoad& load, double speed, double deltaT);

} // namespace nscd
