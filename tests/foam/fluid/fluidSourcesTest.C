// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// OpenFOAM's fvOptions in the fluid's equations against closed forms: a porous zone, alone and with grains in it, and fluid that is added.
#include "fluidCase.H"

#include "cellZone.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const scalar rho = 1000, nu = 1e-3, length = 1, speed = 0.1;

/// A tube of this length, with the outlet at its right.
FluidCaseSettings openTube(label n, const std::string& inlet)
{
    FluidCaseSettings settings = tubeCase(n, length);
    settings.nu = nu;
    settings.convection = "Gauss linear";
    settings.U0 = inlet;
    settings.borderU = {{0, "type fixedValue; value " + inlet + ";"}, {1, "type zeroGradient;"}};
    settings.borderP = {{0, "type fixedFluxPressure; value uniform 0;"}, {1, "type fixedValue; value uniform 0;"}};
    return settings;
}

void addZone(FluidCase& tube, const word& name, const PointFunction& isIn)
{
    DynamicList<label> cells;
    forAll(tube.mesh().C(), i) if (isIn(tube.mesh().C()[i]) > 0) cells.append(i);
    cellZoneMesh& zones = tube.mesh().cellZones();
    zones.setSize(1);
    zones.set(0, new cellZone(name, cells, 0, zones));
}

const scalar darcy = 2000, forchheimer = 40;

/// Pressure drop over a porous middle of 0.4 m, less that of the closed form, relative. With grains: all cells hold fixed ones that
/// leave the fluid `fraction` and drag by `drag` [1/s].
scalar errorOfPorousDrop(label n, bool hasGrains, scalar fraction, scalar drag)
{
    FluidCaseSettings settings = openTube(n, "uniform (0.1 0 0)");
    settings.box.deltaT = 0.5/n;
    FluidCase tube(settings);
    addZone(tube, "porous", [](const point& x) { return mag(x.x() - 0.5) < 0.2; });
    tube.box().writeFile("constant/fvOptions",
        "zone { type explicitPorositySource; explicitPorositySourceCoeffs { selectionMode cellZone; cellZone porous; type DarcyForchheimer;"
        "DarcyForchheimerCoeffs { d (2000 2000 2000); f (40 40 40);"
        "coordinateSystem { type cartesian; origin (0 0 0); e1 (1 0 0); e2 (0 1 0); } } } }");
    tube.sources().hasGrains = hasGrains;
    setCells(tube.sources().fluidFraction, [&](const point&) { return fraction; });
    setCells(tube.sources().drag, [&](const point&) { return drag; });
    tube.steps(3*n);
    const scalar u = speed;  // the inlet's, between the grains
    const scalar porous = 0.4*(nu*darcy + 0.5*forchheimer*u)*u, grains = (length - 0.5/n)*drag*u/fraction;
    return tube.fluid().pRgh()[0]/(rho*(porous + grains)) - 1;
}

/// Its ends are cells that resist beside cells that do not: the drop is low by an error of second order in cell and step.
void expectPorousDrop(bool hasGrains, scalar fraction, scalar drag, scalar tolerance)
{
    const scalar coarse = mag(errorOfPorousDrop(20, hasGrains, fraction, drag)), fine = mag(errorOfPorousDrop(40, hasGrains, fraction, drag));
    EXPECT_LT(fine, tolerance);
    EXPECT_GT(std::log2(coarse/fine), 1.6);
}

TEST(fluidSources, aPorousZoneHasItsPressureDropAlone) { expectPorousDrop(false, 1, 0, 0.016); }

TEST(fluidSources, aPorousZoneAddsToTheDragOfGrains)
{
    expectPorousDrop(true, 1, 0, 0.007);
    expectPorousDrop(true, 0.5, 0, 0.007);
    expectPorousDrop(true, 0.5, 3, 0.002);
}

std::string added(const std::string& name, const std::string& selection, scalar rate)
{
    return name + " { type scalarSemiImplicitSource; selectionMode " + selection
      + " volumeMode absolute; injectionRateSuSp { alpha.fluid (" + std::to_string(rate) + " 0); } }";
}

/// Fluid that comes from all cells of a tube closed at its left, 1 m3/s per m3 of it.
struct FilledTube { scalar outflow, drop, continuityError; };

FilledTube filledTube(bool hasGrains)
{
    const label n = 50;
    FluidCaseSettings settings = openTube(n, "uniform (0 0 0)");
    settings.box.deltaT = 0.2/n;
    settings.nu = 0;
    FluidCase tube(settings);
    tube.box().writeFile("constant/fvOptions", added("spring", "all;", 0.01));
    tube.sources().hasGrains = hasGrains;
    tube.steps(20*n);
    const FluidSolver& fluid = tube.fluid();
    return {fluid.phi().boundaryField()[1][0], fluid.pRgh()[0], fluid.continuityError().largest};
}

/// Bernoulli's pressure: what is added takes the speed of the flow. If it had to be brought to speed the drop were twice as large.
TEST(fluidSources, addedFluidLeavesAndHasTheSpeedOfTheFlow)
{
    for (const bool hasGrains : {false, true})
    {
        const FilledTube tube = filledTube(hasGrains);
        EXPECT_NEAR(tube.outflow, 0.01, 1e-12) << hasGrains;
        EXPECT_LT(tube.continuityError, 1e-10) << hasGrains;
        EXPECT_NEAR(tube.drop, 0.5*rho, 0.02*0.5*rho) << hasGrains;
    }
}

FluidCase* closedTube(const std::string& options)
{
    FluidCaseSettings settings = tubeCase(10, length);
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "wall";
    FluidCase* tube = new FluidCase(settings);
    tube->box().writeFile("constant/fvOptions", options);
    return tube;
}

TEST(fluidSources, aClosedDomainTakesWhatIsRemovedElsewhere)
{
    const std::string spring = added("spring", "points; points ((0.05 0.05 0.05));", 1e-3), sink = added("sink", "points; points ((0.95 0.05 0.05));", -1e-3);
    for (const bool hasGrains : {false, true})
    {
        const std::unique_ptr<FluidCase> open(closedTube(spring + sink)), closed(closedTube(spring));
        open->sources().hasGrains = closed->sources().hasGrains = hasGrains;
        open->steps(5);
        EXPECT_NEAR(open->fluid().phi()[4], 1e-3, 1e-11);
        EXPECT_THROW(closed->steps(1), Foam::error);
    }
}

} // namespace
