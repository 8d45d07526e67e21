// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Functions of time, written as OpenFOAM's Function1: `keyword value;`, `keyword table ((time value) ...);`, or
// `keyword { type constant | table | sine; ... }`.
#pragma once

#include "checkedEntries.hpp"

#include "nscd/scene/wallMotion.hpp"

namespace nscdGrains
{

/// Tables are linear between their rows, and keep their first and last values outside.
/// sine: level + scale amplitude sin(2 pi frequency (t - t0)).
/// Errors: SceneError for what is missing, no function of time, or a table without rows in the order of time
nscd::ScalarOfTime readScalarFunction(const CheckedEntries& given, const std::string& keyword);

/// Likewise; in scenes of discs no vector may leave their plane.
nscd::VectorOfTime readVectorFunction(const CheckedEntries& given, const std::string& keyword, bool isPlanar);

/// As the latter for what turns about its vector: in scenes of discs it has no component in their plane.
nscd::VectorOfTime readSpinFunction(const CheckedEntries& given, const std::string& keyword, bool isPlanar);

} // namespace nscdGrains
