// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Still water in a closed box stays still over any jump of the fluid fraction, and its pressure is hydrostatic (B01).

#include "fluidCase.H"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

struct StillWater
{
    const char* name;
    PointFunction alpha;
    scalar drag = 0;
    scalar tilt = 0;
    bool isDisturbed = false;
};

scalar jump(const point& x)
{
    return x.y() < 0.1 ? 0.4 : 1;
}

scalar twoJumps(const point& x)
{
    return x.y() < 0.09 ? 0.4 : x.y() < 0.09 + 0.2/64 ? 0.7 : x.y() < 0.09 + 0.4/64 ? 0.36 : 1;
}

scalar randomFraction(const point& x)
{
    std::minstd_rand engine(unsigned(1e6*x.x()) + 7919u*unsigned(1e6*x.y()));
    engine.discard(5);
    return std::uniform_real_distribution<double>(0.36, 1)(engine);
}

// Closed box of water, 100 steps of 10 ms. Reference: u = 0, p = rho g.x up to a constant.
void expectStillWater(const StillWater& water)
{
    FluidCaseSettings settings = planeCase(32, 64, 0.1, 0.2);
    settings.gravity = 9.81*vector(std::sin(water.tilt), -std::cos(water.tilt), 0);
    FluidCase stillCase(settings);
    setCells(stillCase.sources().alpha, water.alpha);
    const volScalarField& alpha = stillCase.sources().alpha;
    stillCase.sources().drag.primitiveFieldRef() = water.drag*(1 - alpha.primitiveField());

    FluidSolver& fluid = stillCase.fluid();
    if (water.isDisturbed)
    {
        volScalarField& pRgh = const_cast<volScalarField&>(fluid.pRgh());
        forAll(pRgh, celli) pRgh[celli] = 500*randomFraction(stillCase.mesh().C()[celli] + vector(0.3, 0, 0));
    }
    scalar fastest = 0;
    for (label i = 0; i < 100; ++i)
    {
        stillCase.step();
        fastest = max(fastest, max(mag(fluid.U())).value());
    }
    EXPECT_LT(fastest, 1e-10) << water.name;

    const auto& p = stillCase.mesh().lookupObject<volScalarField>("p");
    const scalar whole = 1000*9.81*0.2;
    forAll(p, celli)
    {
        const scalar hydrostatic = 1000*(settings.gravity & (stillCase.mesh().C()[celli] - stillCase.mesh().C()[0]));
        ASSERT_NEAR(p[celli] - p[0], hydrostatic, 1e-8*whole) << water.name;
    }
}

TEST(fluidAtRest, staysAtRestOverJumpsOfTheFluidFraction)
{
    const scalar tilt = 17*constant::mathematical::pi/180;
    for (const StillWater& water : {
        StillWater{"jump", jump}, StillWater{"jump, drag", jump, 1e4}, StillWater{"random", randomFraction},
        StillWater{"random, drag", randomFraction, 1e4}, StillWater{"two jumps", twoJumps},
        StillWater{"two jumps, drag", twoJumps, 10}, StillWater{"tilted", jump, 100, tilt}})
    {
        expectStillWater(water);
    }
}

TEST(fluidAtRest, forgetsADisturbedPressure)
{
    expectStillWater({"disturbed", jump, 0, 0, true});
    expectStillWater({"disturbed, random, drag", randomFraction, 1e4, 0, true});
}

} // End anonymous namespace
