// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sizes of grains: `diameter 0.01;`, or `sizes { type normal; ... }`.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// Errors: InputError for what is missing or wrong, and for distributions with next to nothing between `min` and `max`
nscd::SizeDistribution readSizes(const CheckedEntries& given, const Surroundings& around);

} // namespace input
