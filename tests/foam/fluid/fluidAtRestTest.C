// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Still water in a closed box stays still over any jump of the fluid fraction, and its pressure is hydrostatic (B01).

#include "fluidCase.H"
#include "mappingTools.H"

#include "accuracy/expectNear.hpp"

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
    PointFunction fluidFraction;
    scalar drag = 0;
    scalar tilt = 0;
    bool isDisturbed = false;
    bool isDistorted = false;  // points of the mesh moved at random by up to a fifth of a cell
    bool canMove = false;      // grains that would answer the fluid, if it moved
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

// A closed box of water.
FluidCaseSettings boxOfWater(const StillWater& water)
{
    FluidCaseSettings settings = planeCase(32, 64, 0.1, 0.2);
    settings.gravity = 9.81*vector(std::sin(water.tilt), -std::cos(water.tilt), 0);
    settings.pimple = "nOuterCorrectors 1; nCorrectors 2; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    if (water.isDistorted)
    {
        shake(settings.box, 0.2*0.2/64, true);
        settings.pimple += "nNonOrthogonalCorrectors 15;";
    }
    return settings;
}

// A response as of grains with k = gamma dt/m = 10, free and at rest (a = 0), of 2.5 times the fluid's density.
void letGrainsAnswer(GrainSources& sources, const scalar deltaT)
{
    sources.hasResponse = true;
    const scalarField solid(1 - sources.fluidFraction.primitiveField());
    sources.slip.primitiveFieldRef() = solid*10/11.;
    sources.mobility.primitiveFieldRef() = solid*deltaT/(2.5*11);
    sources.pressure.primitiveFieldRef() = sources.drag.primitiveField()*deltaT/11;
}

void disturb(const volScalarField& pRgh)
{
    auto& p = const_cast<volScalarField&>(pRgh);
    forAll(p, celli) p[celli] = 500*randomFraction(p.mesh().C()[celli] + vector(0.3, 0, 0));
    p.correctBoundaryConditions();
}

// 100 steps of 10 ms. Reference: u = 0, p = rho g.x up to a constant.
void expectStillWater(const StillWater& water)
{
    const FluidCaseSettings settings = boxOfWater(water);
    FluidCase stillCase(settings);
    setCells(stillCase.sources().fluidFraction, water.fluidFraction);
    const volScalarField& fluidFraction = stillCase.sources().fluidFraction;
    stillCase.sources().drag.primitiveFieldRef() = water.drag*(1 - fluidFraction.primitiveField());
    if (water.canMove) letGrainsAnswer(stillCase.sources(), settings.box.deltaT);

    FluidSolver& fluid = stillCase.fluid();
    if (water.isDisturbed) disturb(fluid.pRgh());
    scalar fastest = 0;
    for (label i = 0; i < 100; ++i)
    {
        stillCase.step();
        fastest = max(fastest, max(mag(fluid.U())).value());
    }
    figures::expectBelow(std::string("B01 ") + water.name, "largest speed [m/s]", fastest, 1e-10);
    std::cout << water.name << ": |u| <= " << fastest << " m/s\n";

    const auto& p = stillCase.mesh().lookupObject<volScalarField>("p");
    const scalar whole = 1000*9.81*0.2;
    scalar worst = 0;
    forAll(p, celli)
    {
        const scalar hydrostatic = 1000*(settings.gravity & (stillCase.mesh().C()[celli] - stillCase.mesh().C()[0]));
        ASSERT_NEAR(p[celli] - p[0], hydrostatic, 1e-8*whole) << water.name;
        worst = max(worst, mag(p[celli] - p[0] - hydrostatic));
    }
    figures::expectBelow(std::string("B01 ") + water.name, "pressure, of the whole column's", worst/whole, 1e-8);
}

TEST(fluidAtRest, theReferenceOfThePressureHasADefault)
{
    const auto pressureWith = [](const std::string& reference)
    {
        FluidCaseSettings settings = planeCase(2, 4, 0.1, 0.2);
        settings.gravity = vector(0, -9.81, 0);
        settings.pimple = "nOuterCorrectors 1; nCorrectors 2; momentumPredictor yes; " + reference;
        FluidCase closed(settings);
        closed.step();
        return scalarField(closed.mesh().lookupObject<volScalarField>("p"));
    };
    EXPECT_EQ(pressureWith(""), pressureWith("pRefCell 0; pRefValue 0;"));
    const scalarField raised(pressureWith("pRefPoint (0.001 0.001 0.0001); pRefValue 5;") - pressureWith("pRefValue 0;"));
    for (const scalar difference : raised) EXPECT_NEAR(difference, 5, 1e-9);
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

TEST(fluidAtRest, staysAtRestOnADistortedMesh)
{
    const scalar tilt = 17*constant::mathematical::pi/180;
    expectStillWater({"distorted, random, drag", randomFraction, 1e4, tilt, false, true});
    expectStillWater({"distorted, jump", jump, 0, tilt, false, true});
}

TEST(fluidAtRest, staysAtRestAmongGrainsThatCouldMove)
{
    expectStillWater({"mobile, random", randomFraction, 1e4, 0, false, false, true});
    expectStillWater({"mobile, jump, disturbed", jump, 100, 0, true, false, true});
}

TEST(fluidAtRest, forgetsADisturbedPressure)
{
    const scalar tilt = 17*constant::mathematical::pi/180;
    expectStillWater({"disturbed", jump, 0, 0, true});
    expectStillWater({"disturbed, random, drag", randomFraction, 1e4, 0, true});
    expectStillWater({"disturbed, distorted, two jumps, drag", twoJumps, 100, tilt, true, true});
}

} // End anonymous namespace
