// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What moves by itself: walls, belts, driven grains.
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// `motion`, `surfaceVelocity` or `surfaceRotation`, and `torquePoint` of a wall whose regions have been added.
void readWallMotion(const CheckedEntries& wall, SceneSettings& scene, int patch);

/// `driven` into scene.driven.
void readDriven(const CheckedEntries& top, SceneSettings& scene);

/// Makes the grains of all groups held ones.
/// Errors: SceneError for ids that no grain has
void holdDriven(const SceneSettings& scene, nscd::Grains& grains);

} // namespace nscdGrains
