// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Figures with their bars, for validation programs of the core.
#pragma once

#include <cstdio>

namespace bars
{

inline bool isFailed = false;

/// Prints a figure with its bar, and remembers a failure.
inline void require(const char* what, double value, double bar)
{
    const bool isMet = value <= bar;
    isFailed = isFailed || !isMet;
    std::printf("  %-66s %10.3g  bar %8.2g%s\n", what, value, bar, isMet ? "" : "  FAILED");
}

/// Status of the program.
inline int status() { return isFailed ? 1 : 0; }

} // namespace bars
