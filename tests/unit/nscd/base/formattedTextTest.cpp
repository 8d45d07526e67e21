// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Numbers and durations in text.
#include "nscd/base/formattedText.hpp"

#include <gtest/gtest.h>

TEST(FormattedText, isAsPrintfHasIt)
{
    EXPECT_EQ(nscd::formatted("%s: %5.2f|%-4d|", "a", 1.005e2, 7), "a: 100.50|7   |");
    EXPECT_EQ(nscd::formatted("%1000d", 1).size(), 1000u);
}

TEST(FormattedText, durationsReadAsAClock)
{
    EXPECT_EQ(nscd::clockText(0.4), "0:00:00");
    EXPECT_EQ(nscd::clockText(59.6), "0:01:00");
    EXPECT_EQ(nscd::clockText(100*3600 + 61), "100:01:01");
    EXPECT_EQ(nscd::clockText(1e60), "277777777:46:40");
}
