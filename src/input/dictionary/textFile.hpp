// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that a user names.
#pragma once

#include "input/dictionary/inputError.hpp"

namespace input
{

/// Refuses a path that leads to no file, and names the one beside it that may be meant.
/// Errors: InputError with `place` as where the file was asked for
void checkIsFile(const std::string& path, const Place& place);

/// The text of a file.
/// Errors: InputError where it cannot be read, with `place` as where it was asked for
std::string readText(const std::string& path, const Place& place);

} // namespace input
