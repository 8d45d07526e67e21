// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What nscdGrains and nscdDEMFoam both read, in one go.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `materials`, `contacts`, `wallMaterial`, `planes`, `walls`, `motion`, `fixedUntil`, `maxInitialOverlap`, `grains`, `driven` and `solver`.
/// Errors: InputError for all that is wrong with these and the surfaces they name; other keywords are the program's to read and to refuse
void readScene(const CheckedEntries& top, const Surroundings& around, Scene& scene);

} // namespace input
