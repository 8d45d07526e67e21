// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that place clumps instead of single grains.
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// `clump` of a source: its balls, or discs, and how they are turned; without the keyword no members.
ClumpSource readClump(const CheckedEntries& source, const SceneSettings& scene);

/// Replaces the grains from `first` on, as their source placed them, by clumps with their mass center there, of the same material.
void replaceByClumps(const SceneSettings& scene, const GrainSource& source, std::size_t first, nscd::Grains& grains);

} // namespace nscdGrains
