// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What every drag law must do: the tests each row of the table inherits.
#include "dragStates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <functional>
#include <stdexcept>

namespace
{

using namespace dragStates;

class EveryDragLaw : public testing::TestWithParam<DragLawRow>
{};

/// Largest relative jump of f over [low, high]: a scan, then bisection into each suspect interval.
double largestJump(const std::function<double(double)>& f, double low, double high, int n)
{
    double largest = 0;
    for (int i = 0; i < n; ++i)
    {
        double a = low + (high - low)*i/n, b = low + (high - low)*(i + 1)/n;
        for (int k = 0; k < 40; ++k)
        {
            const double c = (a + b)/2;
            (std::abs(f(c) - f(a)) > std::abs(f(b) - f(c)) ? b : a) = c;
        }
        largest = std::max(largest, std::max(f(b)/f(a), f(a)/f(b)) - 1);
    }
    return largest;
}

} // namespace

TEST_P(EveryDragLaw, isPositiveAndFinite)
{
    for (double exponent = -12; exponent <= 6; exponent += 0.25)
    {
        for (double alpha = 0.2; alpha < 1.0001; alpha += 0.05)
        {
            const double gamma = GetParam().law(stateAt(std::pow(10, exponent), std::min(alpha, 1.0)));
            EXPECT_TRUE(std::isfinite(gamma) && gamma > 0) << "Re 1e" << exponent << " alpha " << alpha;
        }
    }
}

// Sums of shares give cells without solids an alpha of 1 to round-off, above it as well as below.
TEST_P(EveryDragLaw, takesAFluidFractionOfOneToRoundOff)
{
    for (double Re : {1e-3, 10.0})
    {
        const double alone = relativeToStokes(GetParam(), Re, 1);
        for (double excess : {2.3e-16, 1e-15}) EXPECT_NEAR(relativeToStokes(GetParam(), Re, 1 + excess)/alone, 1, 1e-10) << Re;
    }
}

TEST_P(EveryDragLaw, hasItsStokesLimit)
{
    EXPECT_NEAR(relativeToStokes(GetParam(), 0, 1), GetParam().stokesLimit, 1e-12);
    EXPECT_NEAR(relativeToStokes(GetParam(), 1e-12, 1), GetParam().stokesLimit, 1e-6);
}

TEST_P(EveryDragLaw, isContinuousAtRest)
{
    for (double alpha : {0.2, 0.4, 0.79, 0.8, 0.9})
    {
        const double atRest = relativeToStokes(GetParam(), 0, alpha);
        EXPECT_TRUE(std::isfinite(atRest));
        EXPECT_GT(atRest, 0);
        EXPECT_NEAR(relativeToStokes(GetParam(), 1e-300, alpha)/atRest, 1, 1e-12);
        EXPECT_NEAR(relativeToStokes(GetParam(), 1e-14, alpha)/atRest, 1, 1e-6);
    }
}

TEST_P(EveryDragLaw, trapsNothingAtRest)
{
    // A run may stop at invalid operations and divisions by zero.
    std::feclearexcept(FE_ALL_EXCEPT);
    volatile double sum = 0;
    for (double Re : {0.0, 1e-300, 1e-13}) sum = sum + relativeToStokes(GetParam(), Re, 0.5);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

TEST_P(EveryDragLaw, jumpsOverSlipByWhatItsRowStates)
{
    double largest = 0;
    for (double alpha : {0.3, 0.85, 0.95})
    {
        const auto f = [&](double x) { return GetParam().law(stateAt(std::pow(10, x), alpha)); };
        largest = std::max(largest, largestJump(f, -14, 6, 2000));
    }
    EXPECT_LE(largest, GetParam().slipJump + 1e-9);
    EXPECT_GE(largest, 0.95*GetParam().slipJump);
}

TEST_P(EveryDragLaw, jumpsOverAlphaByWhatItsRowStates)
{
    double largest = 0;
    for (double exponent = -12; exponent <= 6; ++exponent)
    {
        // Constant Re_s: the jump of Schiller-Naumann over Re_s is not one over alpha.
        const auto f = [&](double a) { return GetParam().law(stateAt(std::pow(10, exponent)/a, a)); };
        largest = std::max(largest, largestJump(f, 0.21, 0.9999, 400));
    }
    EXPECT_LE(largest, std::max(GetParam().alphaJump, GetParam().slipJump) + 1e-9);
    EXPECT_GE(largest, 0.95*GetParam().alphaJump);
}

TEST_P(EveryDragLaw, forceGrowsWithSlip)
{
    for (double alpha : {0.2, 0.4, 0.6, 0.79, 0.8, 1.0})
    {
        double last = 0;
        for (double exponent = -12; exponent <= 6; exponent += 0.05)
        {
            const DragState state = stateAt(std::pow(10, exponent), alpha);
            const double force = GetParam().law(state)*state.slip;
            EXPECT_GT(force, last) << "Re 1e" << exponent << " alpha " << alpha;
            last = force;
        }
    }
}

TEST_P(EveryDragLaw, dependsOnlyOnReynoldsNumberAndAlpha)
{
    for (double Re : {1e-6, 0.3, 40.0, 5e4})
    {
        for (double alpha : {0.4, 0.85})
        {
            const double d = 0.02, mu = 1.8e-5, rho = 1.2;
            const double gamma = GetParam().law({sphereSize(d), Re*mu/(rho*d), alpha, rho, mu});
            EXPECT_NEAR(gamma/(3*pi*mu*d)/relativeToStokes(GetParam(), Re, alpha), 1, 1e-12);
        }
    }
}

TEST_P(EveryDragLaw, isFoundByNameAndAlias)
{
    EXPECT_EQ(closures::findDragLaw(GetParam().name).law, GetParam().law);
    const std::string alias = GetParam().alias;
    EXPECT_EQ(closures::findDragLaw(alias.empty() ? GetParam().name : alias).law, GetParam().law);
    EXPECT_NE(*GetParam().source, '\0');
}

INSTANTIATE_TEST_SUITE_P
(
    Table, EveryDragLaw, testing::ValuesIn(closures::dragLaws()),
    [](const testing::TestParamInfo<DragLawRow>& info) { return std::string(info.param.name); }
);

TEST(DragLaws, aWrongNameListsTheTable)
{
    for (const char* wrong : {"DiFelcie", "", "stokes"})
    {
        try
        {
            closures::findDragLaw(wrong);
            FAIL() << wrong;
        }
        catch (const std::invalid_argument& error)
        {
            for (const std::string& name : closures::dragLawNames())
            {
                EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
            }
        }
    }
}
