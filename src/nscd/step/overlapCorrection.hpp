// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlap is removed by displacements, never through velocities.
#pragma once

#include "nscd/step/missedWalls.hpp"

namespace nscd
{

/// Pushes grains apart, the `deepest` of whose overlaps exceeds `tolerance`, by displacements that give no velocity: Gauss-Seidel on
/// n.(dx_a - dx_b) >= target - g for all near contacts, also with walls that the list lacks, mobilities 1/m. Positions and geometry of the list are updated.
/// Returns the sweeps made. Units: m
int correctOverlaps
(
    ContactList& list, const Scene& scene, const std::vector<WallGap>& missed, double deepest, double tolerance, double deadBand
);

} // namespace nscd
