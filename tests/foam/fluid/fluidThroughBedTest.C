// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Flow through fixed beds against analytic answers: Bernoulli (B02), a drag slab, Brinkman's channel (B03), Poiseuille
// with a uniform fluid fraction (B08), a held mean flow, and the balance of forces between fluid and grains.

#include "fluidCase.H"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const scalar pi = constant::mathematical::pi;

std::string uniformVector(const vector& v)
{
    std::ostringstream os;
    os.precision(17);
    os << "uniform (" << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
    return os.str();
}

FluidCaseSettings periodicTube(const label n, const scalar length, const scalar U)
{
    FluidCaseSettings settings = tubeCase(n, length);
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "cyclic";
    settings.U0 = uniformVector(vector(U, 0, 0));
    return settings;
}

// Errors of u and of the pressure difference between the widest and the narrowest place, relative.
struct ContractionErrors { scalar u, p; };

// B02: alpha = .7 + .3 cos(2 pi x), inviscid. Reference: alpha u = U, p + rho u^2/2 uniform, 105 Pa between ends.
ContractionErrors contractionErrors(const label n, const char* convection)
{
    const scalar U = 0.2;
    FluidCaseSettings settings = periodicTube(n, 1, U);
    settings.nu = 0;
    settings.convection = convection;
    settings.box.deltaT = 0.2/n;
    FluidCase contraction(settings);
    contraction.setMeanFlow(vector(U, 0, 0));
    const auto fraction = [](const point& x) { return 0.7 + 0.3*std::cos(2*pi*x.x()); };
    setCells(contraction.sources().fluidFraction, fraction);
    contraction.steps(4*n);

    const volScalarField& p = contraction.fluid().pRgh();
    const auto& C = contraction.mesh().C();
    const auto dynamic = [&](const label i) { return 0.5*1000*sqr(U/fraction(C[i])); };
    const label narrow = n/2;
    const auto u = [&](const point& x) { return vector(U/fraction(x), 0, 0); };
    return {l2Error(contraction.fluid().U(), u)/U, mag(p[0] - p[narrow] + dynamic(0) - dynamic(narrow))/105};
}

TEST(fluidThroughBed, contractionHasBernoullisPressure)
{
    for (const char* scheme : {"Gauss linear", "Gauss limitedLinearV 1", "Gauss linearUpwind grad(U)"})
    {
        const ContractionErrors coarse = contractionErrors(32, scheme), fine = contractionErrors(64, scheme);
        std::cout << scheme << ": p " << 100*coarse.p << ' ' << 100*fine.p << " %, u " << coarse.u << ' ' << fine.u
            << '\n';
        figures::expectBelow(std::string("B02 ") + scheme, "pressure difference, 64 cells", fine.p, 0.005);
        figures::row(std::string("B02 ") + scheme, "rms error of u over U, 64 cells", figures::none, figures::none, fine.u, figures::none);
        EXPECT_GT(std::log2(coarse.p/fine.p), 1.9) << scheme;
        EXPECT_GT(std::log2(coarse.u/fine.u), 1.9) << scheme;
    }
}

struct SlabResult { scalar pressureDrop, grainForce, overshoot; };

// Slab of alpha = .4 in the middle third; imposed U, free fluid around. stiffness is B = D dt/alpha inside.
SlabResult slab(const label n, const scalar stiffness)
{
    const scalar U = 0.1, alphaBed = 0.4, dt = 0.1*(1./n)/U, D = stiffness*alphaBed/dt;
    FluidCaseSettings settings = tubeCase(n, 1);
    settings.nu = 0;
    settings.convection = "Gauss limitedLinearV 1";
    settings.box.deltaT = dt;
    settings.U0 = uniformVector(vector(U, 0, 0));
    settings.borderU[0] = "type fixedValue; value " + settings.U0 + ";";
    settings.borderU[1] = "type zeroGradient;";
    settings.borderP[0] = "type fixedFluxPressure; value uniform 0;";
    settings.borderP[1] = "type fixedValue; value uniform 0;";
    FluidCase slabCase(settings);
    const auto isBed = [](const point& x) { return mag(x.x() - 0.5) < 1./6; };
    setCells(slabCase.sources().fluidFraction, [&](const point& x) { return isBed(x) ? alphaBed : 1; });
    setCells(slabCase.sources().drag, [&](const point& x) { return isBed(x) ? D : 0; });
    slabCase.steps(10*n);

    const scalar exact = 1000*D*U/sqr(alphaBed)/3, area = 0.01;
    const FluidSolver& fluid = slabCase.fluid();
    SlabResult result{fluid.pRgh()[0]/exact, 0, 0};
    forAll(fluid.U(), i)
    {
        const scalar fluidFraction = slabCase.sources().fluidFraction[i];
        const scalar drag = 1000*slabCase.sources().drag[i]*fluid.U()[i].x();
        const scalar pressureForce = -(1 - fluidFraction)*fluid.balancedPressureGradient()[i].x();
        result.grainForce += slabCase.mesh().V()[i]*(drag + pressureForce)/(exact*area);
        result.overshoot = max(result.overshoot, mag(fluidFraction*fluid.U()[i].x()/U - 1));
    }
    return result;
}

TEST(fluidThroughBed, slabHasItsDragLawsPressureDropAndWeight)
{
    for (const scalar stiffness : {2., 2e2, 2e5})
    for (const label n : {24, 96})
    {
        const SlabResult result = slab(n, stiffness);
        std::cout << "B " << stiffness << " n " << n << ": dp/exact " << result.pressureDrop << ", force on grains "
            << result.grainForce << ", largest |alpha u/U - 1| " << result.overshoot << '\n';
        EXPECT_NEAR(result.pressureDrop, 1, stiffness < 10 ? 1e-4 : 2e-5);
        EXPECT_NEAR(result.grainForce, 1, stiffness < 10 ? 1e-4 : 2e-5);
        EXPECT_LT(result.overshoot, 0.15);
    }
}

// A channel -h < y < h, periodic along x, driven by a force per fluid mass G/rho with drag beta u per volume.
std::unique_ptr<FluidCase> channel(const label cellsPerHalf, const scalar fluidFraction, const scalar beta, const scalar drive)
{
    const scalar h = 0.01;
    FluidCaseSettings settings = planeCase(1, 2*cellsPerHalf, h/cellsPerHalf, 2*h);
    settings.box.min = point(0, -h, 0);
    settings.box.max.y() = h;
    settings.box.patchTypes[0] = settings.box.patchTypes[1] = "cyclic";
    settings.rho = 1;
    settings.nu = 1e-3;
    settings.box.deltaT = 10;
    settings.pimple = "nOuterCorrectors 1; nCorrectors 3; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    std::unique_ptr<FluidCase> flow(new FluidCase(settings));
    setCells(flow->sources().fluidFraction, [=](const point&) { return fluidFraction; });
    setCells(flow->sources().drag, [=](const point&) { return beta; });
    setCells(flow->fluid().bodyAcceleration(), [=](const point&) { return vector(drive, 0, 0); });
    flow->steps(60);
    return flow;
}

scalar brinkmanError(const label cellsPerHalf, const scalar beta)
{
    const scalar fluidFraction = 0.5, mu = 1e-3, h = 0.01, l = std::sqrt(fluidFraction*mu/beta);
    const auto flow = channel(cellsPerHalf, fluidFraction, beta, 1);
    const auto exact = [=](const point& x)
    {
        return vector(fluidFraction/beta*(1 - std::cosh(x.y()/l)/std::cosh(h/l)), 0, 0);
    };
    return l2Error(flow->fluid().U(), exact)/mag(exact(point(0, 0, 0)));
}

// B03. Reference: u = (alpha G/beta)(1 - cosh(y/l)/cosh(h/l)), l^2 = alpha mu/beta.
TEST(fluidThroughBed, brinkmanChannelIsSecondOrder)
{
    for (const scalar beta : {10., 0.1})
    {
        const scalar coarse = brinkmanError(8, beta), fine = brinkmanError(16, beta);
        std::cout << "Brinkman beta " << beta << ": " << coarse << ' ' << fine << '\n';
        figures::expectBelow("B03 beta " + figures::text(beta), "rms error of u, 16 cells a half", fine, 0.01);
        EXPECT_GT(std::log2(coarse/fine), 1.9);
    }
}

// B08: without drag a uniform fluid fraction cancels from the equations.
TEST(fluidThroughBed, uniformFractionWithoutDragChangesNothing)
{
    const auto half = channel(8, 0.6, 0, 1), whole = channel(8, 1, 0, 1);
    const scalar fastest = max(mag(whole->fluid().U())).value();
    EXPECT_NEAR(fastest, 0.05, 1e-3);
    figures::expectBelow("B08", "u at alpha 0.6 against alpha 1", max(mag(half->fluid().U() - whole->fluid().U().primitiveField()))/fastest, 1e-8);
}

// Layers in series under a held mean flow: the gradient is the mean of the layers' own.
TEST(fluidThroughBed, meanFlowIsHeldThroughUnevenDrag)
{
    const scalar U = 0.05;
    FluidCaseSettings settings = periodicTube(40, 1, 0);
    settings.nu = 0;
    settings.convection = "Gauss upwind";
    settings.box.deltaT = 0.1;
    FluidCase layers(settings);
    layers.setMeanFlow(vector(U, 0, 0));
    const auto fraction = [](const point& x) { return x.x() < 0.5 ? 0.4 : 0.9; };
    const auto drag = [](const point& x) { return x.x() < 0.5 ? 1e4 : 1.; };
    setCells(layers.sources().fluidFraction, fraction);
    setCells(layers.sources().drag, drag);
    layers.steps(3);

    const scalar exact = -1000*U*0.5*(1e4/sqr(0.4) + 1/sqr(0.9));
    EXPECT_NEAR(layers.fluid().meanFlowGradient().x()/exact, 1, 1e-4);
    EXPECT_LT(layers.fluid().continuityError().largest, 1e-9);
    forAll(layers.fluid().phi(), facei) EXPECT_NEAR(layers.fluid().phi()[facei], U*0.01, 1e-10);
    vector gradient = Zero;
    forAll(layers.fluid().U(), i) gradient += layers.fluid().balancedPressureGradient()[i]/40;
    EXPECT_NEAR(gradient.x()/layers.fluid().meanFlowGradient().x(), 1, 1e-9);
}

TEST(fluidThroughBed, meanFlowAlongAWallIsRefused)
{
    FluidCase closed(planeCase(4, 4, 1, 1));
    closed.setMeanFlow(vector(0.1, 0, 0));
    EXPECT_NE(errorMessage([&] { closed.fluid(); }).find("no cyclic patches"), std::string::npos);
}

// Force of the fluid on all grains [N]: drag, -V G and V div(tau).
vector forceOnGrains(FluidCase& bed)
{
    const FluidSolver& fluid = bed.fluid();
    const volVectorField& divTau = fluid.divTau();
    vector force = Zero;
    forAll(fluid.U(), i)
    {
        const scalar solids = 1 - bed.sources().fluidFraction[i];
        const vector drag = fluid.rho().value()*bed.sources().drag[i]*fluid.U()[i];
        force += bed.mesh().V()[i]*(drag + solids*(divTau[i] - fluid.balancedPressureGradient()[i]));
    }
    return force;
}

// What drives a periodic box of fixed grains is what its fluid gains and its grains get.
TEST(fluidThroughBed, forcesOnFluidAndGrainsBalance)
{
    FluidCaseSettings settings = planeCase(16, 16, 1, 1);
    settings.box.patchTypes = {"cyclic", "cyclic", "cyclic", "cyclic", "empty", "empty"};
    settings.nu = 1e-2;
    settings.pimple = "nOuterCorrectors 1; nCorrectors 40; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    FluidCase bed(settings);
    const auto wave = [](const point& x) { return std::cos(2*pi*x.x())*std::cos(4*pi*x.y()); };
    setCells(bed.sources().fluidFraction, [&](const point& x) { return 0.65 + 0.3*wave(x); });
    setCells(bed.sources().drag, [&](const point& x) { return 40*(1 + wave(x)); });
    const vector drive(0.3, 0.2, 0);
    setCells(bed.fluid().bodyAcceleration(), [=](const point&) { return drive; });

    bed.steps(20);
    const vector before = bed.fluid().momentum().inside;
    bed.step();
    const vector gained = (bed.fluid().momentum().inside - before)/bed.time().deltaTValue();
    const scalar fluidMass = 1000*gSum((bed.mesh().V()*bed.sources().fluidFraction.primitiveField())());
    const vector driven = fluidMass*drive, onGrains = forceOnGrains(bed);
    std::cout << "force balance: " << mag(driven - gained - onGrains)/mag(driven) << ", gained/driven "
        << mag(gained)/mag(driven) << '\n';
    EXPECT_LT(mag(driven - gained - onGrains)/mag(driven), 1e-9);
}

} // End anonymous namespace
