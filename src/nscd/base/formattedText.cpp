// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Formatting by the C library.
#include "nscd/base/formattedText.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace nscd
{

std::string formatted(const char* format, ...)
{
    std::va_list arguments;
    va_start(arguments, format);
    std::va_list again;
    va_copy(again, arguments);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)), ' ');
    std::vsnprintf(&text[0], text.size() + 1, format, again);
    va_end(again);
    va_end(arguments);
    return text;
}

std::string clockText(double seconds)
{
    constexpr double longestShown = 1e12;   // 30 000 years; no whole number of the computer holds what an endTime of 1e30 asks for
    const long whole = std::lround(std::min(seconds, longestShown));
    return formatted("%ld:%02ld:%02ld", whole/3600, whole/60 % 60, whole % 60);
}

} // namespace nscd
