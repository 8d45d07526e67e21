// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Text for logs and messages, numbers in columns.
#pragma once

#include <string>

namespace nscd
{

/// As printf, into a string.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// A duration as h:mm:ss, rounded to seconds.
std::string clockText(double seconds);

} // namespace nscd
