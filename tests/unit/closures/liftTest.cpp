// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lift: values worked out from the papers' formulas, limits, signs, what happens without slip, vorticity and spin.
#include "closures/lift.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

namespace
{

using closures::LiftState;
using closures::magnusLift;
using closures::saffmanMeiLift;
using Eigen::Vector3d;

const double pi = std::acos(-1.0);

/// d 2 mm, rho 1000, mu 1e-2: Re = 200 |us|.
LiftState stateOf(const Vector3d& slip, const Vector3d& vorticity, const Vector3d& spin = Vector3d::Zero())
{
    return {2e-3, slip, vorticity, spin, 1000, 1e-2};
}

/// Slip of a Reynolds number along x, and vorticity of a beta across it.
LiftState stateAt(double Re, double beta)
{
    const double slip = Re/200;
    return stateOf(Vector3d(slip, 0, 0), Vector3d(0, 0, -2*slip*beta/2e-3));
}

/// C of Saffman and Mei, by what the lift of a state is over Saffman's own.
double meiFactor(double Re, double beta)
{
    const LiftState state = stateAt(Re, beta);
    const double k = state.vorticity.norm(), a = state.diameter/2, nu = state.viscosity/state.density;
    return saffmanMeiLift(state).norm()/(6.46*state.viscosity*a*a*state.slip.norm()*std::sqrt(k/nu));
}

/// C of Oesterle and Bui Dinh, by what the lift of a sphere is that spins across its slip.
double magnusFactor(double Re, double ReW)
{
    const LiftState state = stateOf(Vector3d(Re/200, 0, 0), Vector3d::Zero(), Vector3d(0, 0, ReW*1e-2/(1000*4e-6)));
    return magnusLift(state).norm()/(0.5*state.density*pi/4*state.diameter*state.diameter*state.slip.squaredNorm());
}

} // namespace

TEST(SaffmanMeiLift, isSaffmansAtSmallReynoldsNumbers)
{
    for (const double Re : {1e-3, 1e-6, 1e-12}) EXPECT_NEAR(meiFactor(Re, 0.1), 1, 0.1*Re) << Re;
}

TEST(SaffmanMeiLift, hasMeisFactor)
{
    // Worked out from Mei's two expressions to six digits.
    EXPECT_NEAR(meiFactor(1, 0.1), 0.914810, 1e-6);
    EXPECT_NEAR(meiFactor(10, 0.1), 0.434124, 1e-6);
    EXPECT_NEAR(meiFactor(10, 0.4), 0.500369, 1e-6);
    EXPECT_NEAR(meiFactor(30, 0.02), 0.094321, 1e-6);
    EXPECT_NEAR(meiFactor(60, 0.1), 0.128353, 1e-6);
    EXPECT_NEAR(meiFactor(100, 0.4), 0.331407, 1e-6);
}

TEST(SaffmanMeiLift, jumpsAtReynoldsNumber40AsPublishedAndNowhereElse)
{
    for (const double beta : {0.005, 0.1, 0.4})
    {
        const double jump = meiFactor(40, beta) - meiFactor(40*(1 + 1e-12), beta);
        EXPECT_NEAR(jump, (1 - 0.3314*std::sqrt(beta))*std::exp(-4.0), 1e-4*std::sqrt(beta)) << beta;
        for (const double Re : {1e-3, 0.1, 1.0, 10.0, 39.9, 40.1, 100.0})
        {
            EXPECT_NEAR(meiFactor(Re*(1 + 1e-9), beta), meiFactor(Re, beta), 1e-8) << Re;
        }
    }
}

TEST(SaffmanMeiLift, movesASphereThatLagsIntoTheFasterFluid)
{
    // u = (k y, 0, 0) has curl (0, 0, -k): fluid above is faster. A sphere with u - v along x lags behind.
    const Vector3d shear(0, 0, -5);
    const Vector3d lags = saffmanMeiLift(stateOf(Vector3d(0.01, 0, 0), shear)), leads = saffmanMeiLift(stateOf(Vector3d(-0.01, 0, 0), shear));
    EXPECT_GT(lags.y(), 0);
    EXPECT_EQ(lags.x(), 0);
    EXPECT_EQ(lags.z(), 0);
    EXPECT_EQ(leads, -lags);
    // Across both, in any direction; slip along the vorticity gives none.
    const LiftState slanted = stateOf(Vector3d(0.01, -0.02, 0.03), Vector3d(3, 1, -2));
    const Vector3d lift = saffmanMeiLift(slanted);
    EXPECT_NEAR(lift.dot(slanted.slip), 0, 1e-15*lift.norm()*slanted.slip.norm());
    EXPECT_NEAR(lift.dot(slanted.vorticity), 0, 1e-15*lift.norm()*slanted.vorticity.norm());
    EXPECT_GT(lift.dot(slanted.slip.cross(slanted.vorticity)), 0);
    EXPECT_EQ(saffmanMeiLift(stateOf(Vector3d(0, 0, 0.01), shear)), Vector3d(Vector3d::Zero()));
}

TEST(SaffmanMeiLift, doesNotKnowTheSpin)
{
    EXPECT_EQ(saffmanMeiLift(stateOf({0.01, 0, 0}, {0, 0, -5}, {1, 2, 3})), saffmanMeiLift(stateOf({0.01, 0, 0}, {0, 0, -5})));
}

TEST(SaffmanMeiLift, vanishesWithSlipAndWithVorticityAndTrapsNothing)
{
    std::feclearexcept(FE_ALL_EXCEPT);
    const Vector3d some(0.3, -0.2, 0.1), none = Vector3d::Zero();
    EXPECT_EQ(saffmanMeiLift(stateOf(none, none)), none);
    EXPECT_EQ(saffmanMeiLift(stateOf(none, some)), none);
    EXPECT_EQ(saffmanMeiLift(stateOf(some, none)), none);
    const Vector3d across(0.1, 0.3, 0.2), slow = 0.01*some;
    // Linear in a small slip, and as the root of a small vorticity.
    const double perSlip = saffmanMeiLift(stateOf(1e-7*some, across)).norm()/1e-7;
    const double perRoot = saffmanMeiLift(stateOf(slow, 1e-9*across)).norm()/std::sqrt(1e-9);
    for (const double small : {1e-10, 1e-30, 1e-150})
    {
        EXPECT_NEAR(saffmanMeiLift(stateOf(small*some, across)).stableNorm()/small/perSlip, 1, 1e-4) << small;
        EXPECT_NEAR(saffmanMeiLift(stateOf(slow, small*across)).stableNorm()/std::sqrt(small)/perRoot, 1, 1e-3) << small;
    }
    for (const double tiny : {1e-160, 1e-320})
    {
        EXPECT_TRUE(saffmanMeiLift(stateOf(tiny*some, across)).allFinite() && saffmanMeiLift(stateOf(slow, tiny*across)).allFinite());
    }
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

TEST(MagnusLift, isRubinowAndKellersAtSmallReynoldsNumbers)
{
    for (const double Re : {1e-8, 1e-10, 1e-12})
    {
        EXPECT_NEAR(magnusFactor(Re, 1e-2)/(1e-2/Re), 1, 0.06*std::pow(1e-2, 0.4)*std::pow(Re, 0.3)) << Re;
    }
    // F = pi rho a^3 (omega - w/2) x (v - u), by its parts.
    const LiftState state = stateOf(Vector3d(1, -2, 3)*1e-15, Vector3d(2, 4, -6), Vector3d(-1, 0.5, 2));
    const Vector3d expected = pi*state.density*1e-9*(state.spin - 0.5*state.vorticity).cross(-state.slip);
    EXPECT_LT((magnusLift(state) - expected).norm(), 1e-4*expected.norm());
}

TEST(MagnusLift, hasTheFactorOfOesterleAndBuiDinh)
{
    // Worked out from their expression to six digits.
    EXPECT_NEAR(magnusFactor(0.5, 1), 1.930066, 1e-6);
    EXPECT_NEAR(magnusFactor(1, 2), 1.888001, 1e-6);
    EXPECT_NEAR(magnusFactor(10, 20), 1.514346, 1e-6);
    EXPECT_NEAR(magnusFactor(20, 80), 2.035976, 1e-6);
    EXPECT_NEAR(magnusFactor(100, 400), 0.745549, 1e-6);
    EXPECT_NEAR(magnusFactor(140, 1680), 0.537552, 1e-6);
}

TEST(MagnusLift, jumpsNowhereNotAtReynoldsNumber1Either)
{
    for (const double ratio : {0.1, 2.0, 12.0})
    {
        for (const double Re : {1e-6, 0.5, 1.0, 10.0, 140.0, 500.0})
        {
            EXPECT_NEAR(magnusFactor(Re*(1 + 1e-9), Re*ratio), magnusFactor(Re, Re*ratio), 1e-8*ratio) << Re;
        }
    }
    // As far below Rubinow and Keller's force at Re 1 as the header says.
    EXPECT_NEAR(magnusFactor(1, 2)/2, 0.944, 5e-4);
    EXPECT_NEAR(magnusFactor(1, 12)/12, 0.863, 5e-4);
}

TEST(MagnusLift, pushesASphereWhereItsSurfaceMovesWithTheFlow)
{
    // Fluid passes along x; a sphere that spins about z moves with it below, so the flow is quicker there and presses less.
    const Vector3d slip(0.01, 0, 0), none = Vector3d::Zero();
    const Vector3d lift = magnusLift(stateOf(slip, none, Vector3d(0, 0, 5)));
    EXPECT_LT(lift.y(), 0);
    EXPECT_EQ(lift.x(), 0);
    EXPECT_EQ(lift.z(), 0);
    EXPECT_EQ(magnusLift(stateOf(slip, none, Vector3d(0, 0, -5))), -lift);
    EXPECT_EQ(magnusLift(stateOf(-slip, none, Vector3d(0, 0, 5))), -lift);
    EXPECT_EQ(magnusLift(stateOf(slip, none, Vector3d(7, 0, 0))), none) << "spin along the slip";
    // It is the spin beside the fluid's own, half its vorticity, that counts.
    EXPECT_EQ(magnusLift(stateOf(slip, Vector3d(0, 0, 10), Vector3d(0, 0, 5))), none);
    EXPECT_EQ(magnusLift(stateOf(slip, Vector3d(0, 0, -10), none)), lift);
}

TEST(MagnusLift, addsToSaffmansNextOrderWhatASphereHeldInAShearLacks)
{
    // -11/8 held and -7/8 turning with the fluid, in pi rho a^3 |us| k: the difference is the Magnus lift of the held one.
    const double k = 1e-6, us = 1e-9;
    const LiftState held = stateOf(Vector3d(us, 0, 0), Vector3d(0, 0, -k));
    EXPECT_NEAR(magnusLift(held).y()/(pi*held.density*1e-9*us*k), -11./8 + 7./8, 1e-5);
}

TEST(MagnusLift, vanishesWithSlipAndWithSpinAndTrapsNothing)
{
    std::feclearexcept(FE_ALL_EXCEPT);
    const Vector3d some(0.3, -0.2, 0.1), across(0.1, 0.3, 0.2), none = Vector3d::Zero();
    EXPECT_EQ(magnusLift(stateOf(none, none, none)), none);
    EXPECT_EQ(magnusLift(stateOf(none, none, some)), none);
    EXPECT_EQ(magnusLift(stateOf(some, none, none)), none);
    for (const double small : {1e-9, 1e-30, 1e-150, 1e-160, 1e-320})
    {
        const Vector3d slow = magnusLift(stateOf(small*some, none, across)), turned = magnusLift(stateOf(some, none, small*across));
        EXPECT_TRUE(slow.allFinite() && turned.allFinite()) << small;
        EXPECT_LE(slow.stableNorm(), 4e-6*small*some.norm()*across.norm()) << small;
        EXPECT_LE(turned.stableNorm(), 1e-3*std::pow(small, 0.4)) << small;
    }
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}
