// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What moves as functions of time say: walls, and belts.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `motion`, `surfaceVelocity` or `surfaceRotation`, and `torquePoint` of a wall whose regions have been added.
void readWallMotion(const CheckedEntries& wall, const Surroundings& around, nscd::Walls& walls, int patch);

/// `surfaceVelocity`, a function of time [m/s], or `surfaceRotation { origin; axis; omega; }` with omega a function of time [rad/s];
/// empty if neither is given.
nscd::SurfaceMotion readSurfaceMotion(const CheckedEntries& wall, int emptyAxis);

} // namespace input
