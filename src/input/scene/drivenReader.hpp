// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that move as functions of time say, whatever touches them.
#pragma once

#include "input/scene/scene.hpp"

#include "nscd/scene/exchange.hpp"

namespace input
{

/// `driven`: groups by names of the user's choice, with `ids`, `velocity` and, if they turn, `omega`.
/// Errors: InputError for what is missing or unknown, and for grains in two groups
std::vector<DrivenGroup> readDriven(const CheckedEntries& top, int emptyAxis);

/// Makes the grains of all groups held ones. Collective.
/// Errors: InputError for ids that no grain has, on any rank, unless some may have left (`mayHaveLeft`)
void holdDriven(const std::vector<DrivenGroup>& groups, nscd::Grains& grains, const nscd::Exchange& exchange = {}, bool mayHaveLeft = false);

/// Drives all groups through the time from .. to [s] (nscd::drive).
/// Errors: InputError for values that are not finite and motion out of the plane of the grains
void driveGrains(const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, double from, double to);

/// Makes all held grains free that no group drives. Returns whether there were any.
bool letGo(const std::vector<DrivenGroup>& groups, nscd::Grains& grains);

/// Lets all held grains of a run go that no group drives, with the velocity that they have: once, in the first step that begins at the time given or later.
class HeldUntil
{
public:
    explicit HeldUntil(double time) : time_(time) {}

    /// In a step of length deltaT that begins at `now` [s]. Collective. Returns whether any were let go.
    bool letGo(double now, double deltaT, const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, const nscd::Exchange& exchange = {});

private:
    double time_;   ///< [s]; infinite where they are held for ever, or free already
};

} // namespace input
