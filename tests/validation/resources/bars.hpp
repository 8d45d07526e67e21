// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Figures with their bars, for validation programs of the core: printed, and rows for the page of accuracy.
#pragma once

#include "../../accuracy/figures.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace bars
{

inline bool isFailed = false;
inline std::string currentScene;

/// Heads the figures that follow: the name of the case first, if it has one.
inline void scene(const std::string& text)
{
    currentScene = text;
    std::printf("%s\n", text.c_str());
}

inline void judge(const char* what, double error, double bar)
{
    const bool isMet = error <= bar;
    isFailed = isFailed || !isMet;
    std::printf("  %-66s %10.3g  bar %8.2g%s\n", what, error, bar, isMet ? "" : "  FAILED");
}

/// Prints a figure with its bar, and remembers a failure.
inline void require(const char* what, double value, double bar)
{
    judge(what, value, bar);
    figures::row(currentScene, what, figures::none, figures::none, value, bar);
}

/// The same of a value with a reference: their difference is judged.
inline void requireNear(const char* what, double value, double reference, double tolerance)
{
    judge(what, std::abs(value - reference), tolerance);
    figures::compared(currentScene, what, value, reference, tolerance);
}

/// Status of the program.
inline int status() { return isFailed ? 1 : 0; }

} // namespace bars
