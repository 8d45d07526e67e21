// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Materials and the coefficients of their pairs.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `materials` and `contacts`.
MaterialTable readMaterials(const CheckedEntries& top, bool hasFluid);

/// `wallMaterial`: the only material where it is missing, -1 where there are several.
int readWallMaterial(const CheckedEntries& top, const MaterialTable& materials);

/// The material of a wall, `material`: that of all walls where it is missing.
int readMaterialOfWall(const CheckedEntries& wall, const Scene& scene);

/// The material of grains, `material`: the only one with a density where it is missing.
int readMaterialOfGrains(const CheckedEntries& source, const MaterialTable& materials);

/// Refuses pairs of materials that can meet and have no coefficients.
void checkPairs(const MaterialTable& materials, const std::vector<int>& ofGrains, const nscd::Walls& walls);

} // namespace input
