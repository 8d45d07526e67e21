// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Expectations of unit tests that also leave a row for the page of accuracy.
#pragma once

#include "accuracy/figures.hpp"

#include <gtest/gtest.h>

namespace figures
{

/// As EXPECT_NEAR: |ours - reference| <= tolerance.
inline void expectNear(const std::string& scene, const std::string& quantity, double ours, double reference, double tolerance)
{
    compared(scene, quantity, ours, reference, tolerance);
    EXPECT_NEAR(ours, reference, tolerance) << scene << ": " << quantity;
}

/// As EXPECT_LE, of what is an error itself.
inline void expectBelow(const std::string& scene, const std::string& quantity, double error, double bar)
{
    row(scene, quantity, none, none, error, bar);
    EXPECT_LE(error, bar) << scene << ": " << quantity;
}

} // namespace figures
