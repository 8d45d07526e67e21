// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Rotating frames in the fluid's equations: flow between coaxial cylinders against Couette's velocity and its pressure.
#include "annulus.H"
#include "fluidCase.H"

#include "cellZone.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const scalar omega = 2;

/// Which cells turn, which cylinders, and what is between them.
struct Rotation
{
    scalar zoneRadius = outerRadius;
    bool turnsOuter = false;
    bool hasGrains = false;
    std::function<scalar(scalar)> fluidFraction = [](scalar) { return 1; };
};

struct Errors { scalar velocity, pressure, largest; };

/// Relative errors after the flow has come to rest in its frame; `largest` change of the velocity in the last step [m/s].
Errors errorsOf(const Rotation& rotation, label n)
{
    FluidCaseSettings settings;
    settings.box = annulusMesh(n);
    settings.box.deltaT = 0.02;
    settings.nu = 0.2;
    settings.borderP = {{0, "type fixedFluxPressure; value uniform 0;"}, {1, "type fixedFluxPressure; value uniform 0;"}};
    FluidCase annulus(settings);
    DynamicList<label> cells;
    const vectorField& centers = annulus.mesh().C();
    forAll(centers, i) if (Foam::sqrt(sqr(centers[i].x()) + sqr(centers[i].y())) < rotation.zoneRadius) cells.append(i);
    cellZoneMesh& zones = annulus.mesh().cellZones();
    zones.setSize(1);
    zones.set(0, new cellZone("rotor", cells, 0, zones));
    const std::string still = rotation.turnsOuter ? "" : "nonRotatingPatches (right); ";
    annulus.box().writeFile("constant/MRFProperties", "rotor { cellZone rotor; " + still + "origin (0 0 0); axis (0 0 1); omega 2; }");
    annulus.sources().hasGrains = rotation.hasGrains;
    setCells(annulus.sources().fluidFraction, [&](const point& x) { return rotation.fluidFraction(std::hypot(x.x(), x.y())); });
    annulus.steps(149);
    const vectorField before(annulus.fluid().U().primitiveField());
    annulus.step();

    const CouetteFlow flow(omega, rotation.turnsOuter ? omega : 0);
    const FluidSolver& fluid = annulus.fluid();
    const scalar rho = fluid.rho().value();
    scalarField difference(fluid.pRgh().primitiveField()/rho);
    forAll(difference, i) difference[i] -= flow.pressure(centers[i]);
    const scalar shift = gSum(scalarField(annulus.mesh().V()*difference))/gSum(annulus.mesh().V());
    const auto exact = [&](const point& x) { return rho*(flow.pressure(x) + shift); };
    const scalar scale = rho*sqr(omega*innerRadius);
    return
    {
        l2Error(fluid.U(), [&](const point& x) { return flow.velocity(x); })/(omega*innerRadius),
        l2Error(fluid.pRgh(), exact)/scale, max(mag(fluid.U().primitiveField() - before))
    };
}

void expectCouette(const Rotation& rotation)
{
    const Errors coarse = errorsOf(rotation, 8), fine = errorsOf(rotation, 16);
    EXPECT_LT(fine.velocity, 0.004);
    EXPECT_LT(fine.pressure, 0.006);
    EXPECT_GT(std::log2(coarse.velocity/fine.velocity), 1.6) << coarse.velocity << " to " << fine.velocity;
    // First order: at a wall that moves along itself OpenFOAM's gradient of the pressure is zero.
    EXPECT_GT(std::log2(coarse.pressure/fine.pressure), 0.8) << coarse.pressure << " to " << fine.pressure;
    EXPECT_LT(fine.largest, 1e-5);
}

TEST(rotatingZones, haveCouettesFlowBetweenCylinders)
{
    for (const bool hasGrains : {false, true})
    {
        Rotation whole;
        whole.hasGrains = hasGrains;
        expectCouette(whole);
        whole.zoneRadius = 0.75;
        expectCouette(whole);
    }
}

TEST(rotatingZones, turnAsASolidBody)
{
    for (const bool hasGrains : {false, true})
    {
        Rotation rotation;
        rotation.turnsOuter = true;
        rotation.hasGrains = hasGrains;
        expectCouette(rotation);
    }
}

/// Whatever the fluid fraction between the cylinders, as long as nothing drags.
TEST(rotatingZones, weightTheFrameByTheFluidFraction)
{
    Rotation rotation;
    rotation.hasGrains = true;
    rotation.fluidFraction = [](scalar r) { return 0.4 + 0.5*(r - innerRadius)/(outerRadius - innerRadius); };
    expectCouette(rotation);
}

} // namespace
