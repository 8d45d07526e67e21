// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that let grains in during a run.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// Adds a source of type `entering` to a scene whose materials have been read.
/// Errors: InputError for what is missing or wrong
void readEntry(const Dictionary& dict, const std::string& name, const Surroundings& around, Scene& scene);

} // namespace input
