// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Laws for beds: values worked out apart from this code, the limits their papers build on, and how they hang on alpha.
#include "closures/drag/hinderedDrag.hpp"
#include "closures/drag/simulatedDrag.hpp"
#include "dragStates.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace
{

using namespace dragStates;

/// gamma/(3 pi mu d) at a superficial Reynolds number.
double factor(const std::string& law, double Re_s, double alpha)
{
    return relativeToStokes(closures::findDragLaw(law), Re_s/alpha, alpha);
}

/// Pressure gradient of a bed over mu U_s/d^2: n gamma |u - v|/alpha with n = 6 phi/(pi d^3), |u - v| = U_s/alpha.
double gradient(const std::string& law, double Re_s, double alpha)
{
    return 18*(1 - alpha)*factor(law, Re_s, alpha)/(alpha*alpha);
}

double ergunGradient(double Re_s, double alpha)
{
    const double phi = 1 - alpha, cube = alpha*alpha*alpha;
    return 150*phi*phi/cube + 1.75*phi/cube*Re_s;
}

/// Laws that are meant for beds and for what flies above them.
const char* const bedLaws[] =
{
    "DiFelice", "GidaspowSmooth", "SyamlalOBrien", "PlessisMasliyah", "KochHill", "HillKochLadd", "Beetstra", "Rong", "Tenneti"
};

} // namespace

// Of a program of its own, in another language, from the formulas as they are printed: alpha, Re_s, gamma/(3 pi mu d).
TEST(DragOfBeds, valuesByHand)
{
    struct Row { double alpha, Re_s, expected; };
    const struct { const char* law; std::vector<Row> rows; } cases[] =
    {
        {"GidaspowSmooth", {{0.95, 1e-3, 1.141366285}, {0.9, 10, 2.283281995}, {0.7, 50, 10.48835909}, {0.42, 300, 80.96584178}}},
        {"SyamlalOBrien", {{0.95, 1e-3, 1.138465169}, {0.9, 10, 2.86211063}, {0.7, 50, 9.510259066}, {0.42, 300, 94.83419137}}},
        {"PlessisMasliyah", {{0.95, 1e-3, 1.049334812}, {0.9, 10, 2.509495534}, {0.7, 50, 11.23586579}, {0.42, 300, 89.71144764}}},
        {"KochHill", {{0.95, 1e-3, 1.749543611}, {0.9, 10, 2.80436276}, {0.7, 50, 7.918754467}, {0.55, 2, 8.370478959}}},
        {"HillKochLadd", {{0.95, 1e-3, 1.794002643}, {0.9, 10, 2.992898005}, {0.7, 50, 8.541683034}, {0.55, 2, 8.243623903}}},
        {"HillKochLadd", {{0.42, 300, 65.81497283}, {0.995, 20, 1.577436447}}},
        {"Beetstra", {{0.95, 1e-3, 1.671281396}, {0.9, 10, 2.896262471}, {0.7, 50, 9.632214394}, {0.42, 300, 66.58956249}}},
        {"Rong", {{0.95, 1e-3, 1.198682392}, {0.9, 10, 2.501050096}, {0.7, 50, 7.644884347}, {0.42, 300, 78.57661346}}},
        {"Tenneti", {{0.95, 1e-3, 1.555730612}, {0.9, 10, 2.850103559}, {0.7, 50, 8.374095892}, {0.42, 300, 47.42233566}}}
    };
    for (const auto& one : cases)
    {
        for (const Row& r : one.rows) EXPECT_NEAR(factor(one.law, r.Re_s, r.alpha)/r.expected, 1, 2e-9) << one.law << " " << r.alpha;
    }
}

// Form A or B: Carman and Kozeny's 180 phi^2/alpha^3 is what these laws are made of in a packed bed in creeping flow.
TEST(DragOfBeds, creepingFlowThroughPackingsIsCarmanAndKozenys)
{
    for (double alpha : {0.36, 0.4, 0.5, 0.6})
    {
        const double phi = 1 - alpha, kozeny = 180*phi*phi/(alpha*alpha*alpha);
        for (const char* law : {"KochHill", "HillKochLadd"}) EXPECT_NEAR(gradient(law, 0, alpha)/kozeny, 1, 1e-12) << law << " " << alpha;
        // alpha^2 (1 + 1.5 sqrt(phi)) of Beetstra's comes on top.
        const double more = 18*phi/alpha*alpha*alpha*(1 + 1.5*std::sqrt(phi));
        EXPECT_NEAR(gradient("Beetstra", 0, alpha), kozeny + more, 1e-11*kozeny);
        EXPECT_NEAR(gradient("Tenneti", 0, alpha)/kozeny, 1, 0.11) << alpha;
    }
}

// Ergun's pressure gradient, which fits of packed beds differ from by some tens of percent. Form A taken for B would be off by 2.5.
TEST(DragOfBeds, packedBedsAreNearErguns)
{
    const double furthest = 0.4, ofSyamlal = 0.48;
    for (double Re_s : {0.01, 1.0, 10.0, 100.0})
    {
        for (const char* law : bedLaws)
        {
            const double bound = law == std::string("SyamlalOBrien") ? ofSyamlal : furthest;
            EXPECT_NEAR(gradient(law, Re_s, 0.4)/ergunGradient(Re_s, 0.4), 1, bound) << law << " " << Re_s;
        }
    }
}

// 1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 16.456 phi, the whole force in creeping flow through dilute fixed arrays (Kim & Russel 1985).
TEST(DragOfBeds, diluteArraysInCreepingFlow)
{
    for (double phi : {0.0101, 0.015, 0.02})
    {
        const double exact = 1 + 3*std::sqrt(phi/2) + 135.0/64*phi*std::log(phi) + 16.456*phi;
        const double alpha2 = (1 - phi)*(1 - phi);
        EXPECT_NEAR(factor("HillKochLadd", 0, 1 - phi)/(alpha2*exact), 1, 2e-3) << phi;
        EXPECT_NEAR(factor("KochHill", 0, 1 - phi)/(alpha2*exact), 1, 1.5e-2) << phi;
    }
}

TEST(DragOfBeds, aLoneSphereInCreepingFlowHasStokesDrag)
{
    const struct { const char* law; double limit; } cases[] =
    {
        {"KochHill", 1}, {"HillKochLadd", 1}, {"Beetstra", 1}, {"Tenneti", 1}, {"SyamlalOBrien", 0.96}, {"Rong", 0.96}
    };
    for (const auto& one : cases)
    {
        EXPECT_NEAR(factor(one.law, 1e-9, 1), one.limit, 1e-4) << one.law;
    }
}

TEST(DragOfBeds, aLoneSphereWithInertiaIsNearSchillerNaumanns)
{
    for (double Re : {1.0, 10.0, 100.0, 900.0})
    {
        EXPECT_NEAR(factor("Tenneti", Re, 1)/factor("SchillerNaumann", Re, 1), 1, 1e-12);
        for (const char* law : {"SyamlalOBrien", "Rong"}) EXPECT_NEAR(factor(law, Re, 1)/factor("DallaValle", Re, 1), 1, 1e-12) << law;
    }
}

// What the docstrings say of fits to arrays where there is but one sphere.
TEST(DragOfBeds, fitsToArraysMissLoneSpheres)
{
    const struct { double Re, kochHill, hillKochLadd, beetstra; } rows[] = {{10, 0.84, 0.68, 0.94}, {100, 1.21, 0.62, 1.16}, {1000, 2.53, 1.06, 1.69}};
    for (const auto& r : rows)
    {
        const double lone = 1 + 0.15*std::pow(r.Re, 0.687);
        EXPECT_NEAR(factor("KochHill", r.Re, 1)/lone, r.kochHill, 0.02) << r.Re;
        EXPECT_NEAR(factor("HillKochLadd", r.Re, 1)/lone, r.hillKochLadd, 0.02) << r.Re;
        EXPECT_NEAR(factor("Beetstra", r.Re, 1)/lone, r.beetstra, 0.02) << r.Re;
    }
}

// Benyahia, Syamlal & O'Brien join the two branches where they meet.
TEST(DragOfBeds, hillKochAndLaddsBranchesMeet)
{
    for (double phi : {0.011, 0.05, 0.0953, 0.1, 0.25, 0.399, 0.4, 0.6})
    {
        const closures::drag::HillKochLaddTerms t = closures::drag::hillKochLaddTerms(phi);
        const double R = (t.F3 + std::sqrt(t.F3*t.F3 - 4*t.F1*(t.F0 - t.F2)))/(2*t.F1);
        EXPECT_NEAR((t.F0 + t.F1*R*R)/(t.F2 + t.F3*R), 1, 1e-13) << phi;
        EXPECT_GT(R, 0);
    }
}

// Syamlal and O'Brien's V_r is the interstitial slip of a settling suspension over that of a lone grain: alpha^4.14 in creeping flow, B with
// inertia.
TEST(DragOfBeds, settlingRatioOfSyamlalAndOBrien)
{
    using closures::drag::syamlalOBrienRatio;
    EXPECT_NEAR(syamlalOBrienRatio(0, 0.7), std::pow(0.7, 4.14), 1e-15);
    EXPECT_NEAR(syamlalOBrienRatio(1e9, 0.7)/(0.8*std::pow(0.7, 1.28)), 1, 1e-8);
    EXPECT_NEAR(syamlalOBrienRatio(1e9, 0.9)/std::pow(0.9, 2.65), 1, 1e-8);
    EXPECT_NEAR(syamlalOBrienRatio(123, 1), 1, 1e-14);
}

// Huilin and Gidaspow's switch: halfway at 0.8, and the pure laws within 3 % far from there.
TEST(DragOfBeds, smoothGidaspowGoesFromErgunToWenYu)
{
    for (double Re : {0.01, 30.0, 900.0})
    {
        const double middle = 0.5*(factor("Ergun", Re, 0.8) + factor("WenYu", Re, 0.8));
        EXPECT_NEAR(factor("GidaspowSmooth", Re, 0.8)/middle, 1, 1e-12);
        EXPECT_NEAR(factor("GidaspowSmooth", Re, 0.45)/factor("Ergun", Re, 0.45), 1, 0.01);
        EXPECT_NEAR(factor("GidaspowSmooth", Re, 0.98)/factor("WenYu", Re, 0.98), 1, 0.03);
    }
}

// At a given superficial slip a denser bed has more drag: all of alpha, Re_s 0.01 to 1000, but where a published jump goes the other way.
TEST(DragOfBeds, dragFallsWithAlpha)
{
    for (const char* law : bedLaws)
    {
        for (double exponent = -2; exponent <= 3; exponent += 0.25)
        {
            const double Re_s = std::pow(10, exponent);
            const bool isSyamlal = law == std::string("SyamlalOBrien");
            double last = std::numeric_limits<double>::infinity();
            for (double alpha = isSyamlal ? 0.35 : 0.2; alpha < 0.985; alpha += 0.005)
            {
                const double now = factor(law, Re_s, alpha);
                EXPECT_LT(now, last) << law << " Re_s " << Re_s << " alpha " << alpha;
                last = now;
            }
        }
    }
}

TEST(DragOfBeds, rangesAreMeasuredInSuperficialReynoldsNumberAndAlpha)
{
    const closures::DragRange range = {300, 0.5, 0.9};
    closures::BeyondRange beyond = closures::beyondRange(range, stateAt(100/0.7, 0.7));
    EXPECT_NEAR(beyond.Re, 1.0/3, 1e-12);
    EXPECT_EQ(beyond.fluidFraction, 0);
    beyond = closures::beyondRange(range, stateAt(600/0.4, 0.4));
    EXPECT_NEAR(beyond.Re, 2, 1e-12);
    EXPECT_NEAR(beyond.fluidFraction, 0.1, 1e-15);
    EXPECT_NEAR(closures::beyondRange(range, stateAt(1, 1)).fluidFraction, 0.1, 1e-15);
    for (const DragLawRow& row : closures::dragLaws())
    {
        EXPECT_GT(row.range.highestRe, 0) << row.name;
        EXPECT_LT(row.range.lowestFraction, row.range.highestFraction) << row.name;
    }
}
