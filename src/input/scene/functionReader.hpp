// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Functions of time, written as OpenFOAM's Function1: `keyword value;`, `keyword table ((time value) ...);`, or
// `keyword { type constant | table | sine; ... }`; and the other kinds of a program that knows more.
#pragma once

#include "input/dictionary/checkedEntries.hpp"

namespace input
{

/// Tables are linear between their rows, and keep their first and last values outside.
/// sine: level + scale amplitude sin(2 pi frequency (t - t0)).
/// Where the dictionary has Functions of its own, these make all but what they do not know; what is refused is the same.
/// Errors: InputError for what is missing, no function of time, a table without rows in the order of time, and values that are not finite at
///         time 0
nscd::ScalarOfTime readScalarFunction(const CheckedEntries& given, const std::string& keyword);

/// Likewise; in scenes of discs no vector may leave their plane.
nscd::VectorOfTime readVectorFunction(const CheckedEntries& given, const std::string& keyword, int emptyAxis);

/// As the latter for what turns about its vector: in scenes of discs it has no component in their plane.
nscd::VectorOfTime readSpinFunction(const CheckedEntries& given, const std::string& keyword, int emptyAxis);

/// Refuses a vector out of the plane of the grains, and one that turns out of it. (emptyAxis < 0: none)
void checkInPlane(const CheckedEntries& given, const std::string& keyword, const Vec3& value, int emptyAxis);
void checkNormalToPlane(const CheckedEntries& given, const std::string& keyword, const Vec3& value, int emptyAxis);

} // namespace input
