// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nusselt numbers: values worked out from the papers' formulas, limits, what a step does to a sphere.
#include "closures/nusseltLaws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using closures::conductanceOverStep;
using closures::NusseltLawRow;

double nusselt(const char* law, double Re, double Pr, double alpha) { return closures::findNusseltLaw(law).law({Re, Pr, alpha}); }

} // namespace

TEST(NusseltLaws, haveThePapersValues)
{
    // Pr 8, of which the cube root is 2. Ranz & Marshall: 2 + 0.6*10*2.
    EXPECT_NEAR(nusselt("RanzMarshall", 100, 8, 0.4), 14, 1e-12);
    // Gunn, alpha 0.5, Re_s 32: (7 - 5 + 1.25)(1 + 0.7*2*2) + (1.33 - 1.2 + 0.3)*32^0.7*2 = 3.25*3.8 + 0.86*11.313708.
    EXPECT_NEAR(nusselt("Gunn", 64, 8, 0.5), 12.35 + 0.86*11.313708498984761, 1e-12);
    // Wakao, alpha 0.5, Re_s 32: 2 + 1.1*8*2.
    EXPECT_NEAR(nusselt("Wakao", 64, 8, 0.5), 19.6, 1e-12);
    // Li & Mason, alpha 0.25, so alpha^3.5 is 1/128: at Re 100, 1024 and 1e5 (of which the power 1.8 is 1e9).
    EXPECT_NEAR(nusselt("LiMason", 100, 8, 0.25), 2 + 0.6*10*2/128, 1e-12);
    EXPECT_NEAR(nusselt("LiMason", 1024, 8, 0.25), 2 + (0.5*32 + 0.02*256)*2/128, 1e-12);
    EXPECT_NEAR(nusselt("LiMason", 1e5, 8, 0.25), 2 + 4.5e-5*1e9/128, 1e-9);
}

TEST(NusseltLaws, ofALoneSphereAtRestAreTwo)
{
    for (const NusseltLawRow& row : closures::nusseltLaws()) EXPECT_NEAR(row.law({0, 0.7, 1}), 2, 1e-12) << row.name;
}

TEST(NusseltLaws, growWithTheSlipAndAreFinite)
{
    for (const NusseltLawRow& row : closures::nusseltLaws())
    {
        for (const double alpha : {0.3, 0.6, 1.0})
        {
            double before = 0;
            for (const double Re : {0.0, 1e-6, 1.0, 1e2, 1e5, 1e8})
            {
                const double value = row.law({Re, 0.7, alpha});
                EXPECT_TRUE(std::isfinite(value)) << row.name;
                EXPECT_GT(value, before) << row.name << ' ' << Re << ' ' << alpha;
                before = value;
            }
        }
    }
}

TEST(NusseltLaws, aWrongNameIsToldTheRightOnes)
{
    try
    {
        closures::findNusseltLaw("Gun");
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find("Gun'; known are RanzMarshall, Gunn, Wakao, LiMason"), std::string::npos);
    }
}

TEST(Conductance, overAStepIsTheExponentials)
{
    const double hA = 3, C = 2;
    for (const double deltaT : {1e-9, 1e-3, 1.0, 1e3})
    {
        // From 0 in a fluid of 1: C T = dt H.
        EXPECT_NEAR(deltaT*conductanceOverStep(hA, C, deltaT)/C, -std::expm1(-hA*deltaT/C), 1e-15) << deltaT;
    }
    EXPECT_NEAR(conductanceOverStep(hA, C, 1e-12), hA, 1e-11);
    // Never past the fluid's temperature.
    EXPECT_LE(1e9*conductanceOverStep(hA, C, 1e9), C*(1 + std::numeric_limits<double>::epsilon()));
}
