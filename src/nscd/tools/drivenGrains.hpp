// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Groups of grains that move as functions of time say, whatever touches them.
#pragma once

#include "nscd/step/grainDynamics.hpp"

namespace nscd
{

struct DrivenGrains
{
    std::vector<std::int64_t> ids;   ///< ascending
    VectorOfTime velocity;           ///< [m/s]
    VectorOfTime omega;              ///< [rad/s]; empty: none
};

/// Makes the grains of a group held ones, as GrainDynamics::drive wants them. Returns how many of them are there.
std::size_t hold(const DrivenGrains& group, Grains& grains);

/// Gives a group's grains the mean velocity and spin of the time from .. to [s], by two Gauss points: positions then follow the
/// integral of the velocity, exactly where it is a cubic polynomial within a step. Before beginStep(), every step.
/// Errors: std::invalid_argument for values that are not finite, and for motion along or about other axes than discs have
void drive(const DrivenGrains& group, GrainDynamics& dynamics, double from, double to);

} // namespace nscd
