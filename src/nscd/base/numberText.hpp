// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Numbers as text for files that programs read again.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace nscd
{

/// As few digits as give back the number to the bit.
inline std::string exact(double number)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.15g", number);
    if (std::strtod(text, nullptr) != number) std::snprintf(text, sizeof(text), "%.17g", number);
    return text;
}

} // namespace nscd
