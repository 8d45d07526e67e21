// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws that know of sphericity: the published formulas, worked out apart from this code, and exact Stokes drag of two touching spheres.
#include "dragStates.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace dragStates;

DragState lying(double Re, double alpha, double sphericity, double crosswise)
{
    DragState state = stateAt(Re, alpha);
    state.sphericity = sphericity;
    state.crosswiseSphericity = crosswise;
    return state;
}

/// Cd of a lone grain.
double cdOf(const std::string& law, double Re, double sphericity, double crosswise)
{
    const DragState state = lying(Re, 1, sphericity, crosswise);
    return gammaOf(law, state)/(0.5*state.size.frontalArea*state.density*state.slip);
}

} // namespace

TEST(NonsphericalDrag, haiderLevenspielByHand)
{
    const struct { double Re, sphericity, expected; } rows[] =
    {
        {0.01, 1, 2422.1051017309637}, {1, 0.806, 30.637514279656237}, {100, 0.806, 1.2845675498932174}, {1000, 0.5, 3.5919937007579286},
        {5000, 0.9, 0.8391174452566434}
    };
    for (const auto& row : rows)
    {
        EXPECT_NEAR(cdOf("HaiderLevenspiel", row.Re, row.sphericity, 1)/row.expected, 1, 1e-12);
        EXPECT_EQ(cdOf("HaiderLevenspiel", row.Re, row.sphericity, 0.3), cdOf("HaiderLevenspiel", row.Re, row.sphericity, 1));
    }
}

TEST(NonsphericalDrag, hoelzerSommerfeldByHand)
{
    const struct { double Re, sphericity, crosswise, expected; } rows[] =
    {
        {0.01, 1, 1, 2430.42}, {1, 0.806, 0.7, 31.975138679}, {100, 0.7937, 1.5874, 1.073133353}, {1000, 0.5, 0.3, 3.085764402},
        {5000, 0.9, 1.2, 0.626080272}
    };
    for (const auto& row : rows) EXPECT_NEAR(cdOf("HoelzerSommerfeld", row.Re, row.sphericity, row.crosswise)/row.expected, 1, 1e-9);
    EXPECT_NEAR(cdOf("HoelzerSommerfeld", 100, 1 + 1e-15, 1), cdOf("HoelzerSommerfeld", 100, 1, 1), 1e-12);
}

// The curve of spheres, Schiller and Naumann's, within what fits to all shapes are off by there: 8 % and 17 %.
TEST(NonsphericalDrag, spheresAreNearTheCurveOfSpheres)
{
    for (double Re : {0.1, 1.0, 10.0, 100.0, 800.0})
    {
        const double sphere = cdOf("SchillerNaumann", Re, 1, 1);
        EXPECT_NEAR(cdOf("HaiderLevenspiel", Re, 1, 1)/sphere, 1, 0.1) << Re;
        EXPECT_NEAR(cdOf("HoelzerSommerfeld", Re, 1, 1)/sphere, 1, 0.2) << Re;
    }
}

// Drag on each of two touching spheres over Stokes': 0.645 along their line (Stimson & Jeffery 1926, Proc. R. Soc. A 111, 110), 0.7249 across it
// (Goldman, Cox & Brenner 1966, Chem. Eng. Sci. 21, 1151).
TEST(NonsphericalDrag, twoTouchingSpheresInCreepingFlow)
{
    const double sphericity = std::pow(2.0, -1.0/3), perSphere = 2/std::cbrt(2.0), Re = 1e-9;
    const double stokes = cdOf("Stokes", Re, 1, 1);
    EXPECT_NEAR(cdOf("HoelzerSommerfeld", Re, sphericity, std::pow(2.0, 2.0/3))/stokes, 0.645*perSphere, 0.03);
    EXPECT_NEAR(cdOf("HoelzerSommerfeld", Re, sphericity, std::pow(2.0, -1.0/3))/stokes, 0.7249*perSphere, 0.03);
}

TEST(NonsphericalDrag, isHinderedAsDiFeliceHasIt)
{
    for (double Re_s : {0.3, 30.0, 3000.0})
    {
        const double alpha = 0.6, exponent = 3.7 - 0.65*std::exp(-0.5*std::pow(1.5 - std::log10(Re_s), 2));
        for (const char* law : {"HaiderLevenspiel", "HoelzerSommerfeld"})
        {
            // gamma = A/2 rho Cd(Re_s) U_s^2 alpha^-beta/|u - v|, |u - v| = U_s/alpha.
            const double lone = gammaOf(law, lying(Re_s, 1, 0.8, 0.9)), dense = gammaOf(law, lying(Re_s/alpha, alpha, 0.8, 0.9));
            EXPECT_NEAR(dense/lone, std::pow(alpha, 1 - exponent), 1e-12);
        }
    }
}
