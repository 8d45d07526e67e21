// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where grains come from.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `grains { type ...; }`, or `grains { bed { type ...; } intruder { type ...; } }`, with `motion`, `fixedUntil` and `maxInitialOverlap`, into scene.sources,
/// which may be none; materials have been read. Files of grains are not opened here.
/// Errors: InputError, for more grains than the memory of this machine holds too
void readSources(const CheckedEntries& top, const Surroundings& around, Scene& scene);

} // namespace input
