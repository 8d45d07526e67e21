// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of exact(): what is read again is what was written, in no more digits than needed.
#include "nscd/base/numberText.hpp"

#include <gtest/gtest.h>

#include <random>

TEST(NumberText, isReadAgainToTheBit)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> mantissa(-1, 1);
    for (int k = 0; k < 10000; ++k)
    {
        const double number = std::ldexp(mantissa(random), k % 600 - 300);
        ASSERT_EQ(std::strtod(nscd::exact(number).c_str(), nullptr), number);
    }
}

TEST(NumberText, isShort)
{
    EXPECT_EQ(nscd::exact(0.1), "0.1");
    EXPECT_EQ(nscd::exact(0.1 + 0.2), "0.30000000000000004");
    EXPECT_EQ(nscd::exact(-2), "-2");
}
