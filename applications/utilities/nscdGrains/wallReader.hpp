// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls of a scene: every kind there is, by name.
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// `wallMaterial`, `planes` and `walls` into scene.walls; shape, materials and periods must have been read.
void readWalls(const CheckedEntries& top, SceneSettings& scene);

} // namespace nscdGrains
