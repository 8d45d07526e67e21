// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that let grains in during a run.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// A source of type `entering`; materials have been read.
/// Errors: InputError for what is missing or wrong
nscd::EntrySource readEntry(const Dictionary& dict, const std::string& name, const MaterialTable& materials, const Surroundings& around);

} // namespace input
