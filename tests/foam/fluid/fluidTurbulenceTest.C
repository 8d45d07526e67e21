// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Turbulence models between grains: a uniform fluid fraction cancels from them, an uneven one leaves them sound.

#include "fluidCase.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const char* const kEpsilon = "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs no; }";
const char* const smagorinsky =
    "simulationType LES; LES { LESModel Smagorinsky; turbulence on; printCoeffs no; delta cubeRootVol;"
    "cubeRootVolCoeffs {} }";

std::string turbulentField(const char* dimensions, const char* value)
{
    const std::string uniform = std::string("uniform ") + value + ";";
    return std::string("dimensions ") + dimensions + "; internalField " + uniform + " boundaryField {"
        "left { type fixedValue; value " + uniform + " } \"(right|bottom|top)\" { type zeroGradient; }"
        "\"(front|back)\" { type empty; } }";
}

// A shear flow that enters a channel at 1 to 3 m/s.
std::unique_ptr<FluidCase> shearFlow(const char* model, const PointFunction& fluidFraction, const scalar drag)
{
    FluidCaseSettings settings = planeCase(24, 12, 0.2, 0.1);
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "patch";
    settings.nu = 1e-5;
    settings.box.deltaT = 1e-3;
    settings.convection = "Gauss linearUpwind grad(U)";
    settings.borderU[0] = "type fixedValue; value uniform (1 0 0);";
    settings.borderU[1] = "type zeroGradient;";
    settings.borderP[0] = "type fixedFluxPressure; value uniform 0;";
    settings.borderP[1] = "type fixedValue; value uniform 0;";
    settings.turbulence = model;
    std::unique_ptr<FluidCase> flow(new FluidCase(settings));
    flow->box().writeFile("0/k", turbulentField("[0 2 -2 0 0 0 0]", "0.05"));
    flow->box().writeFile("0/epsilon", turbulentField("[0 2 -3 0 0 0 0]", "0.5"));
    flow->box().writeFile("0/nut", turbulentField("[0 2 -1 0 0 0 0]", "0"));
    setCells(flow->sources().fluidFraction, fluidFraction);
    setCells(flow->sources().drag, [&](const point& x) { return drag*(1 - fluidFraction(x)); });
    flow->setVelocity([](const point& x) { return vector(1 + 20*x.y(), 0, 0); });
    flow->steps(60);
    return flow;
}

const volScalarField& viscosity(FluidCase& flow)
{
    return flow.mesh().lookupObject<volScalarField>("nut");
}

TEST(fluidTurbulence, aUniformFluidFractionCancels)
{
    for (const char* model : {kEpsilon, smagorinsky})
    {
        const auto half = shearFlow(model, [](const point&) { return 0.6; }, 0);
        const auto whole = shearFlow(model, [](const point&) { return 1; }, 0);
        const scalarField& nut = viscosity(*whole);
        EXPECT_GT(min(nut), 0) << model;
        EXPECT_GT(max(nut), 1e-5) << model;
        EXPECT_LT(max(mag(viscosity(*half).primitiveField() - nut))/max(nut), 1e-8) << model;
        EXPECT_LT(max(mag(half->fluid().U().primitiveField() - whole->fluid().U().primitiveField())), 1e-8) << model;
    }
}

TEST(fluidTurbulence, staysSoundThroughABed)
{
    const auto bed = [](const point& x) { return x.x() > 0.08 && x.x() < 0.14 && x.y() < 0.06 ? 0.4 : 1; };
    for (const char* model : {kEpsilon, smagorinsky})
    {
        const auto flow = shearFlow(model, bed, 1e3);
        const scalarField& nut = viscosity(*flow);
        EXPECT_TRUE(std::isfinite(sum(nut)) && std::isfinite(max(mag(flow->fluid().pRgh())).value())) << model;
        EXPECT_GE(min(nut), 0) << model;
        EXPECT_LT(max(nut), 0.1) << model;
        EXPECT_LT(max(mag(flow->fluid().U())).value(), 20) << model;
        EXPECT_LT(flow->fluid().continuityError().largest, 1e-7) << model;
    }
}

} // End anonymous namespace
