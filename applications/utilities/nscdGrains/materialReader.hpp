// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Materials and the coefficients of their pairs.
#pragma once

#include "sceneSettings.hpp"

namespace nscdGrains
{

/// `materials` and `contacts`.
MaterialTable readMaterials(const CheckedEntries& top);

/// The material that `keyword` names.
int readMaterial(const CheckedEntries& dict, const std::string& keyword, const MaterialTable& materials);

/// The material of grains, `material`: the only one with a density where it is missing.
int readGrainMaterial(const CheckedEntries& dict, const MaterialTable& materials);

/// Refuses pairs of materials that can meet and have no coefficients.
void checkPairs(const SceneSettings& scene, const std::vector<int>& materialsOfGrains);

} // namespace nscdGrains
