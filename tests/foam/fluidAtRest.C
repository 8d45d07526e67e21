// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Fluid between fixed grains: at rest over jumps of the fluid fraction (B01), through a contraction (B02), through a
// porous slab, in a Brinkman channel (B03) and through uniform beds without drag (B08).

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

// Water enters a tube at the left with a superficial velocity and leaves at zero pressure.
FluidCaseSettings throughFlow(const label n, const scalar length, const scalar interstitial)
{
    FluidCaseSettings settings = tubeCase(n, length);
    std::ostringstream in;
    in << "uniform (" << interstitial << " 0 0)";
    settings.U0 = in.str();
    settings.borderU[0] = "type fixedValue; value " + in.str() + ";";
    settings.borderU[1] = "type zeroGradient;";
    settings.borderP[0] = "type fixedFluxPressure; value uniform 0;";
    settings.borderP[1] = "type fixedValue; value uniform 0;";
    return settings;
}

// Largest error of the pressure difference between the cell where alpha is 1 and the one where it is smallest.
scalar contractionError(const label n, const char* convection)
{
    const scalar U = 0.2, rho = 1000;
    FluidCaseSettings settings = tubeCase(n, 1);
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "cyclic";
    settings.nu = 0;
    settings.convection = convection;
    settings.box.deltaT = 0.2/n;
    settings.U0 = "uniform (0.2 0 0)";
    FluidCase contraction(settings);
    contraction.setMeanFlow(vector(U, 0, 0));
    const auto fraction = [](const point& x) { return 0.7 + 0.3*std::cos(2*constant::mathematical::pi*x.x()); };
    setCells(contraction.sources().alpha, fraction);
    contraction.steps(4*n);

    const volScalarField& pRgh = contraction.fluid().pRgh();
    const volVectorField& u = contraction.fluid().U();
    scalar worst = 0;
    const label middle = n/2;
    const scalar exact = 0.5*rho*sqr(U)*
        (1/sqr(fraction(contraction.mesh().C()[middle])) - 1/sqr(fraction(contraction.mesh().C()[0])));
    worst = mag(pRgh[0] - pRgh[middle] - exact)/exact;
    (void)u;
    return worst;
}

TEST(fluidThroughContraction, hasBernoullisPressure)
{
    for (const char* scheme : {"Gauss linear", "Gauss limitedLinearV 1", "Gauss linearUpwind grad(U)"})
    {
        scalar e[3];
        for (label k = 0; k < 3; ++k) e[k] = contractionError(32 << k, scheme);
        std::cout << scheme << ": " << 100*e[0] << " " << 100*e[1] << " " << 100*e[2] << " %\n";
    }
}

} // End anonymous namespace
