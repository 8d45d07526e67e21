// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that place clumps instead of single grains.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `clump` of a source: its balls, or discs, and how they are turned; without the keyword no members.
/// Errors: InputError
ClumpSource readClump(const CheckedEntries& given, const GrainSource& source, const Surroundings& around);

} // namespace input
