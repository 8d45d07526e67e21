// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls of a scene: every kind there is, by name.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `planes` and `walls` into scene.walls, and what the log should say of them into scene.notes; materials and wallMaterial have been read.
/// Errors: InputError for what is wrong in the dictionary or in files of surfaces
void readWalls(const CheckedEntries& top, const Surroundings& around, Scene& scene);

} // namespace input
