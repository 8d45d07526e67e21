// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where grains come from, and putting them there.
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// `grains`, `motion` and `maxInitialOverlap` into scene.sources; materials must have been read.
void readSources(const CheckedEntries& top, SceneSettings& scene);

/// The grains of all sources, numbered one after the other, inside the periodic box; discs at z = 0.
/// Errors: SceneError for files that are missing or wrong, with their line
nscd::Grains placeGrains(const SceneSettings& scene);

/// Refuses periods that are shorter than a grain.
void checkPeriods(const SceneSettings& scene, const nscd::Grains& grains);

/// Refuses what no run can start from: pairs of materials without coefficients, periods that are too short, overlaps.
void checkGrains(const SceneSettings& scene, const nscd::Grains& grains);

} // namespace nscdGrains
