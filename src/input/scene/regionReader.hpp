// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Regions: `region { type box; box (0 0 0) (1 1 1); }`.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// The region that a keyword describes; in scenes of discs its part in their plane.
/// Errors: InputError for what is missing or wrong, and for a region without a point
nscd::Region readRegion(const CheckedEntries& given, const std::string& keyword, const Surroundings& around);

/// Likewise, for grains with radii up to the one given [m]; also the regions that the program alone knows.
nscd::EntryRegion readEntryRegion(const CheckedEntries& given, const std::string& keyword, const Surroundings& around, double largestRadius);

} // namespace input
