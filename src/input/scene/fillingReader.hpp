// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sources that fill a region: `region { ... } number 1000; diameter 0.01;`, or `packing { solidFraction 0.6; }`.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// What a source of type `filling` has beyond others, into source.filling; its material has been read. `mostGrains` is what the machine holds.
/// Errors: InputError for what is missing or wrong
void readFilling(const CheckedEntries& given, const MaterialTable& materials, const Surroundings& around, double mostGrains, GrainSource& source);

} // namespace input
