// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sum of exponentials against 1/sqrt(t), and the coefficient.
#include "closures/historyKernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace closures;

TEST(HistoryKernel, isTheInverseRoot)
{
    for (double t = 2e-6; t < 100.0; t *= 1.3)
    {
        double sum = 0.0;
        for (const HistoryTerm& term : historyKernel()) sum += term.weight*std::exp(-term.rate*t);
        EXPECT_NEAR(sum*std::sqrt(t), 1.0, 3e-3) << t;
    }
}

TEST(HistoryKernel, decaysByItsMeanOverAStep)
{
    EXPECT_EQ(meanDecay(0.0), 1.0);
    EXPECT_NEAR(meanDecay(1e-9), 1.0 - 0.5e-9, 1e-16);
    EXPECT_NEAR(meanDecay(2.0), (1.0 - std::exp(-2.0))/2.0, 1e-15);
}

TEST(HistoryKernel, coefficientIsThatOfBasset)
{
    // 6 a^2 sqrt(pi rho mu)
    EXPECT_NEAR(bassetCoefficient(2e-3, 1000.0, 1e-3), 6.0*1e-6*std::sqrt(std::acos(-1.0)), 1e-18);
}
