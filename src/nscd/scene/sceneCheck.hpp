// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a scene and its settings must be before they run.
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/grains.hpp"
#include "nscd/scene/materials.hpp"
#include "nscd/scene/walls.hpp"

namespace nscd
{

/// Errors: std::invalid_argument for arrays that differ in length, values that are not finite, radii and masses that are not
/// positive, and materials of grains and walls that are not there or lack the coefficients of a pair that can meet
void checkGrains(const Grains& grains, const Materials& materials, const Walls& walls);

/// Errors: std::invalid_argument for regions of no patch and geometry that is not finite
void checkWalls(const Walls& walls);

/// Errors: std::invalid_argument for periods that are negative or not finite
void checkBox(const PeriodicBox& box);

/// Errors: std::invalid_argument for numbers out of range; names are looked up elsewhere
void checkSettings(const ContactSettings& settings);

} // namespace nscd
