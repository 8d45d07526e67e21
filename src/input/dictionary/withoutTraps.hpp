// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading numbers that may be too large, in programs that stop at floating-point exceptions.
#pragma once

#include <cfenv>

namespace input
{

/// While it lives, floating-point exceptions stop nobody. OpenFOAM's programs stop at an overflow, which strtod raises for 1e999: what reads
/// a user's text must get past that to say what is wrong.
class WithoutTraps
{
public:
    WithoutTraps() { std::feholdexcept(&before_); }
    ~WithoutTraps() { std::fesetenv(&before_); }
    WithoutTraps(const WithoutTraps&) = delete;
    void operator=(const WithoutTraps&) = delete;

private:
    std::fenv_t before_;
};

} // namespace input
