// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Grains that answer the fluid linearly in u and in grad p, against the same equations solved by hand.

#include "fluidCase.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const scalar meanFlow = 0.05, rho = 1000;

/// Uniform sources along x; see GrainSources.
struct Response { scalar fluidFraction, drag, acceleration, pressure, carried, slip, mobility; };

const Response dense{0.4, 300, 2, 0.3, 0.01, 0.35, 5e-4}, dilute{0.9, 50, -0.5, 0.1, -0.005, 0.05, 2e-4};

struct State { scalar u, gradient; };

// Both equations of GrainSources for a uniform state, G over rho; start: velocity at the start of a step of deltaT.
//   inertia (u - start) = -(alpha + X) G - D u + R,  inertia = alpha/deltaT
//   (alpha + S) u + A - Y G = meanFlow
State solved(const Response& r, const scalar inertia, const scalar start)
{
    const scalar a = inertia + r.drag, b = r.fluidFraction + r.pressure, right = inertia*start + r.acceleration;
    const scalar c = r.fluidFraction + r.slip, d = -r.mobility, flow = meanFlow - r.carried;
    const scalar determinant = a*d - b*c;
    return {(right*d - b*flow)/determinant, rho*(a*flow - c*right)/determinant};
}

template<class Choice>
void setSources(GrainSources& sources, const Choice& at)
{
    sources.hasResponse = true;
    setCells(sources.fluidFraction, [&](const point& x) { return at(x).fluidFraction; });
    setCells(sources.drag, [&](const point& x) { return at(x).drag; });
    setCells(sources.acceleration, [&](const point& x) { return vector(at(x).acceleration, 0, 0); });
    setCells(sources.pressure, [&](const point& x) { return at(x).pressure; });
    setCells(sources.carried, [&](const point& x) { return vector(at(x).carried, 0, 0); });
    setCells(sources.slip, [&](const point& x) { return at(x).slip; });
    setCells(sources.mobility, [&](const point& x) { return at(x).mobility; });
}

FluidCaseSettings periodicTube(const label n)
{
    FluidCaseSettings settings = tubeCase(n, 1);
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "cyclic";
    settings.nu = 0;
    settings.rho = rho;
    settings.convection = "Gauss upwind";
    settings.box.deltaT = 0.02;
    settings.pimple = "nOuterCorrectors 1; nCorrectors 8; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    return settings;
}

void expectState(FluidCase& tube, const label celli, const State& state, const scalar tolerance)
{
    EXPECT_NEAR(tube.fluid().U()[celli].x()/state.u, 1, tolerance) << "u in cell " << celli;
    EXPECT_NEAR(tube.fluid().balancedPressureGradient()[celli].x()/state.gradient, 1, tolerance) << "G in cell " << celli;
}

// Steps from rest: each is the backward-Euler step of the two equations.
TEST(fluidResponse, uniformSuspensionFollowsItsTwoEquations)
{
    for (const Response& response : {dense, dilute})
    {
        FluidCase tube(periodicTube(4));
        tube.setMeanFlow(vector(meanFlow, 0, 0));
        setSources(tube.sources(), [&](const point&) { return response; });
        State state{0, 0};
        for (label i = 0; i < 5; ++i)
        {
            tube.step();
            state = solved(response, response.fluidFraction/0.02, state.u);
            expectState(tube, 2, state, 1e-9);
            EXPECT_NEAR(tube.fluid().meanFlowGradient().x()/state.gradient, 1, 1e-9);
        }
    }
}

// Grains that vanish at once: the fluid of before, alpha per volume of it, is what must be accelerated in that step.
TEST(fluidResponse, clearedSourcesAreNoGrains)
{
    FluidCase tube(periodicTube(4));
    tube.setMeanFlow(vector(meanFlow, 0, 0));
    setSources(tube.sources(), [&](const point&) { return dense; });
    tube.steps(3);
    const scalar start = tube.fluid().U()[2].x();
    tube.step([&] { tube.sources().clear(); });
    EXPECT_NEAR(tube.fluid().U()[2].x(), meanFlow, 1e-12);
    EXPECT_NEAR(tube.fluid().balancedPressureGradient()[2].x()/(-rho*dense.fluidFraction*(meanFlow - start)/0.02), 1, 1e-9);
    tube.step();
    EXPECT_NEAR(tube.fluid().balancedPressureGradient()[2].x(), 0, 1e-6);
}

// Layers in series carry one volume flux; away from their border each is in its own steady state.
TEST(fluidResponse, layersShareTheFluxAndSplitTheGradient)
{
    FluidCase tube(periodicTube(40));
    tube.setMeanFlow(vector(meanFlow, 0, 0));
    setSources(tube.sources(), [](const point& x) { return x.x() < 0.5 ? dense : dilute; });
    tube.steps(100);
    expectState(tube, 10, solved(dense, 0, 0), 1e-6);
    expectState(tube, 30, solved(dilute, 0, 0), 1e-6);
}

// A raft of grains in a single cell, its faces shared with cells without any: it sinks through the fluid that it displaces.
// Equation: (1 + k) v1 = v0 + k (u - V G/gamma - w), V/gamma = solid/(rho drag), w the slip speed in fluid without a gradient.
// On the faces half of its flux is met by alpha u: (alpha + solid/2) v = -alpha^2 w, where a thick layer has v = -alpha^2 w.
TEST(fluidResponse, aRaftOneCellHighSinks)
{
    const scalar solid = 2.0/3, fluid = 1 - solid, drag = 5e4, k = 100, s = 0.3, share = k/(1 + k), w = 0.1;
    const scalar perGradient = share*solid/(rho*drag);
    FluidCase tube(periodicTube(9));
    tube.setMeanFlow(Zero);
    scalar v = 0;
    for (label i = 0; i < 100; ++i)
    {
        const scalar u = tube.fluid().U()[4].x(), gradient = tube.fluid().balancedPressureGradient()[4].x();
        v = v/(1 + k) + share*(u - w) - perGradient*gradient;
        const scalar a = v - s*u + perGradient*gradient;
        const Response none{1, 0, 0, 0, 0, 0, 0};
        const Response raft{fluid, drag*(1 - s), drag*a, share*solid, solid*a, solid*s, share*sqr(solid)/drag};
        tube.step([&] { setSources(tube.sources(), [&](const point& x) { return mag(x.x() - 0.5) < 0.05 ? raft : none; }); });
    }
    EXPECT_NEAR(v/(-sqr(fluid)*w/(fluid + solid/2)), 1, 0.05);
}

// Cells that grow by 1.4, from one to the next as different as suspensions are: what all cells feel of the pressure is what the ends do.
TEST(fluidResponse, gradientsSumToTheForceOnTheEndsInGrowingCells)
{
    for (const bool responds : {true, false})
    {
        FluidCaseSettings settings = tubeCase(12, 1);
        settings.box.movePoint = [](const point& x) { return point((std::pow(1.4, 12*x.x()) - 1)/(std::pow(1.4, 12) - 1), x.y(), x.z()); };
        settings.nu = 0;
        settings.rho = rho;
        settings.convection = "Gauss upwind";
        settings.box.deltaT = 0.02;
        settings.borderU = {{0, "type fixedValue; value uniform (0.05 0 0);"}, {1, "type zeroGradient;"}};
        settings.borderP = {{0, "type fixedFluxPressure; value uniform 0;"}, {1, "type fixedValue; value uniform 0;"}};
        settings.pimple = "nOuterCorrectors 1; nCorrectors 8; momentumPredictor yes;";
        FluidCase tube(settings);
        setSources(tube.sources(), [&](const point& x) { return int(1e4*x.x()) % 3 ? dense : dilute; });
        tube.sources().hasResponse = responds;
        tube.steps(3);
        const volScalarField& p = tube.mesh().lookupObject<volScalarField>("p_rgh");
        scalar onEnds = 0;
        forAll(p.boundaryField(), patchi) onEnds += sum(p.boundaryField()[patchi]*tube.mesh().Sf().boundaryField()[patchi].component(0));
        const scalar felt = sum(tube.mesh().V().field()*tube.fluid().balancedPressureGradient().primitiveField().component(0));
        EXPECT_NEAR(felt/onEnds, 1, 1e-9) << responds;
    }
}

} // End anonymous namespace
