// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The first grains of a scene as a file that sources of type `table` read.
// Tested by tests/unit/nscdGrains/fillingSceneTest.cpp
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// Rows of x y z d [m] and material, in as many digits as give back the numbers to the bit.
/// Errors: input::InputError for a scene with clumps, which tables do not have; std::runtime_error where the file cannot be written
void writeGrainTable(const std::string& path, const SceneSettings& scene, const nscd::Grains& grains);

} // namespace nscdGrains
