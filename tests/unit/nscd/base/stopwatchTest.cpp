// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The stopwatch against a clock read just inside and just outside of its life.
#include "nscd/base/stopwatch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

TEST(Stopwatch, addsItsOwnLifeToWhatIsThere)
{
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
    const double before = 2.0;
    double total = before, inside = 0.0;
    const Clock::time_point start = Clock::now();
    for (int k = 0; k < 2; ++k)
    {
        const nscd::Stopwatch watch(total);
        const Clock::time_point begin = Clock::now();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        inside += seconds(Clock::now() - begin);
    }
    EXPECT_GE(total, before + inside);
    EXPECT_LE(total, before + seconds(Clock::now() - start));
}
