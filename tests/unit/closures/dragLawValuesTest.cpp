// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What each drag law must give: published formulas, terminal velocities, packed and fluidized beds.
#include "dragStates.hpp"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace
{

using namespace dragStates;

const double gravity = 9.81;

/// Root of an increasing function by bisection on a logarithmic scale.
double rootOf(const std::function<double(double)>& f, double low, double high)
{
    for (int i = 0; i < 200; ++i)
    {
        const double middle = std::sqrt(low*high);
        (f(middle) > 0 ? high : low) = middle;
    }
    return low;
}

/// Grain and fluid: diameter, densities of grain and fluid, viscosity.
struct Pair
{
    double d, rhoP, rho, mu;
    double submergedWeight() const { return pi*d*d*d/6*(rhoP - rho)*gravity; }
};

double terminalVelocity(const std::string& law, const Pair& p)
{
    const auto excess = [&](double v)
    {
        return gammaOf(law, {sphereSize(p.d), v, 1, p.rho, p.mu})*v - p.submergedWeight();
    };
    return rootOf(excess, 1e-9, 100);
}

/// Superficial slip U_s at which drag carries alpha times the submerged weight (form A: the rest is pressure).
double settlingVelocity(const std::string& law, const Pair& p, double alpha)
{
    const auto excess = [&](double U)
    {
        return gammaOf(law, {sphereSize(p.d), U/alpha, alpha, p.rho, p.mu})*U/alpha - alpha*p.submergedWeight();
    };
    return rootOf(excess, 1e-9, 100);
}

/// Pressure gradient n F/alpha of a packed bed at superficial velocity U.
double pressureGradient(const std::string& law, double U, double alpha, double d, double rho, double mu)
{
    const double force = gammaOf(law, {sphereSize(d), U/alpha, alpha, rho, mu})*U/alpha;
    return (1 - alpha)/(pi*d*d*d/6)*force/alpha;
}

} // namespace

// Terminal velocities of validation cases C01 to C06: Stokes, DallaValle, Schiller-Naumann.
TEST(DragLaws, terminalVelocities)
{
    const struct { Pair pair; double stokes, dallaValle, schillerNaumann; } rows[] =
    {
        {{1e-4, 3000, 10, 1e-4}, 0.162955, 0.128610, 0.137337},
        {{1e-4, 2000, 1.2, 1.8e-5}, 0.60519, 0.423225, 0.457536},
        {{2e-3, 2500, 997, 1.00199e-3}, 3.27003, 0.232809, 0.267910},
        {{2e-3, 1200, 1115.6, 1115.6*1.77e-6}, 0.09318, 0.030822, 0.033176},
        {{2e-4, 2650, 1000, 1e-3}, 0.03597, 0.022849, 0.024796},
        {{1e-3, 2500, 1200, 0.1}, 0.0070850, 0.0068545, 0.0068982}
    };
    for (const auto& row : rows)
    {
        EXPECT_NEAR(terminalVelocity("Stokes", row.pair)/row.stokes, 1, 2e-5);
        EXPECT_NEAR(terminalVelocity("DallaValle", row.pair)/row.dallaValle, 1, 3e-5);
        EXPECT_NEAR(terminalVelocity("SchillerNaumann", row.pair)/row.schillerNaumann, 1, 3e-5);
    }
}

// Validation case C09: hindered settling of three suspensions, exponent 3.8 and Di Felice's.
TEST(DragLaws, hinderedSettling)
{
    const Pair sand = {2e-4, 2650, 1000, 1e-3}, viscous = {1e-3, 2500, 1200, 0.1}, coarse = {3e-3, 2650, 1000, 1e-3};
    const struct { double phi, sand[2], viscous[2], coarse[2]; } rows[] =
    {
        {0.00, {2.28487e-2, 2.28487e-2}, {6.85446e-3, 6.85446e-3}, {0.324636, 0.324636}},
        {0.01, {2.19610e-2, 2.20612e-2}, {6.54256e-3, 6.55030e-3}, {0.316063, 0.316625}},
        {0.05, {1.86437e-2, 1.90668e-2}, {5.40244e-3, 5.43411e-3}, {0.283098, 0.285805}},
        {0.10, {1.50005e-2, 1.56712e-2}, {4.19962e-3, 4.24858e-3}, {0.244824, 0.249982}},
        {0.20, {9.24419e-3, 1.00207e-2}, {2.41930e-3, 2.47630e-3}, {0.177769, 0.187000}},
        {0.30, {5.25409e-3, 5.84109e-3}, {1.28965e-3, 1.33706e-3}, {0.122840, 0.134910}},
        {0.40, {2.68549e-3, 3.01676e-3}, {6.21449e-4, 6.53967e-4}, {0.079347, 0.092841}}
    };
    const char* laws[] = {"DiFeliceConstant", "DiFelice"};
    for (const auto& row : rows)
    {
        for (int k : {0, 1})
        {
            const std::string scene = std::string("C09 ") + laws[k] + ", phi " + figures::text(row.phi);
            figures::expectNear(scene, "speed of 0.2 mm [m/s]", settlingVelocity(laws[k], sand, 1 - row.phi), row.sand[k], 1e-5*row.sand[k]);
            figures::expectNear(scene, "speed of 1 mm [m/s]", settlingVelocity(laws[k], viscous, 1 - row.phi), row.viscous[k], 1e-5*row.viscous[k]);
            figures::expectNear(scene, "speed of 3 mm [m/s]", settlingVelocity(laws[k], coarse, 1 - row.phi), row.coarse[k], 1e-5*row.coarse[k]);
        }
    }
}

// Validation case C08: linear drag with alpha^-2.8.
TEST(DragLaws, stokesHinderedSettling)
{
    const Pair pair = {1e-3, 2500, 1200, 0.1};
    EXPECT_NEAR(settlingVelocity("StokesHindered", pair, 0.9), 4.272715e-3, 1e-9);
    EXPECT_NEAR(settlingVelocity("StokesHindered", pair, 0.7), 1.278823e-3, 1e-9);
}

// Validation table 0.A: pressure gradients of packed beds.
TEST(DragLaws, packedBedPressureGradients)
{
    const double lattice = 1 - pi/6;
    const struct { double U, alpha, d, rho, mu, ergun, constant, diFelice; } rows[] =
    {
        {1e-3, 0.40, 1e-3, 1000, 1e-3, 860.2, 1078.8, 811.3},
        {1e-2, 0.42, 2e-3, 1000, 1e-3, 2387.7, 4059.3, 2141.4},
        {0.2, 0.40, 1e-3, 1, 1e-5, 2343.8, 4245.9, 2160.7},
        {0.02, 0.451335, 1e-3, 10, 1.5e-3, 14776, 14225, 12738},
        {1e-3, 0.38, 3e-3, 1200, 0.2, 23359, 25640, 23200},
        {1e-3, lattice, 1e-3, 1000, 1e-3, 388.81, 406.81, 323.02},
        {1e-2, lattice, 1e-3, 1000, 1e-3, 4650.8, 6365.2, 3862.7},
        {0.2, lattice, 1e-3, 1.2, 1.8e-5, 1776.0, 2504.2, 1483.7}
    };
    for (const auto& r : rows)
    {
        EXPECT_NEAR(pressureGradient("Ergun", r.U, r.alpha, r.d, r.rho, r.mu)/r.ergun, 1, 7e-5);
        EXPECT_NEAR(pressureGradient("Gidaspow", r.U, r.alpha, r.d, r.rho, r.mu)/r.ergun, 1, 7e-5);
        EXPECT_NEAR(pressureGradient("MigFlow", r.U, r.alpha, r.d, r.rho, r.mu)/r.constant, 1, 7e-5);
        EXPECT_NEAR(pressureGradient("DiFelice", r.U, r.alpha, r.d, r.rho, r.mu)/r.diFelice, 1, 7e-5);
    }
}

// Minimum fluidization of beds packed at alpha = 0.4, validation section 0.
TEST(DragLaws, minimumFluidization)
{
    const struct { Pair pair; double ergun, constant, diFelice; } rows[] =
    {
        {{1.2e-3, 1000, 1.2, 2.16e-5}, 0.326, 0.209, 0.346},
        {{2.5e-3, 2526, 1.2, 1.2e-5}, 1.275, 0.983, 1.283},
        {{3.256e-3, 1131, 1.21, 1.8e-5}, 0.934, 0.684, 0.940},
        {{0.5e-3, 1000, 1, 1e-5}, 0.152, 0.103, 0.166},
        {{1.545e-3, 1150, 1.28, 1.28*1.33e-5}, 0.518, 0.338, 0.530}
    };
    for (const auto& row : rows)
    {
        EXPECT_NEAR(settlingVelocity("Ergun", row.pair, 0.4), row.ergun, 6e-4);
        EXPECT_NEAR(settlingVelocity("DiFeliceConstant", row.pair, 0.4), row.constant, 6e-4);
        EXPECT_NEAR(settlingVelocity("DiFelice", row.pair, 0.4), row.diFelice, 6e-4);
    }
}

// Validation case C22: superficial velocity of a homogeneous liquid bed at the alpha found for each law.
TEST(DragLaws, homogeneousLiquidBed)
{
    const Pair alumina = {3.087e-3, 3585.9, 997, 997*8.379e-7};
    EXPECT_NEAR(settlingVelocity("DiFeliceConstant", alumina, 0.684277), 0.157033, 1e-6);
    EXPECT_NEAR(settlingVelocity("DiFelice", alumina, 0.661512), 0.157033, 1e-6);
    EXPECT_NEAR(settlingVelocity("SchillerNaumannDiFelice", alumina, 0.624295), 0.157033, 1e-6);
}

// n gamma = 3/4 Cd alpha phi rho |u - v|/d alpha^-2.65 (Gidaspow 1994), Cd of Re_s; worked out apart from this code.
TEST(DragLaws, wenYuByHand)
{
    const struct { double alpha, Re_s, expected; } rows[] =
    {
        {0.85, 1e-9, 1.538295925}, {0.9, 10, 2.286681828}, {0.6, 100, 17.61179507}, {0.5, 2000, 230.1446687}
    };
    for (const auto& r : rows)
    {
        EXPECT_NEAR(relativeToStokes(closures::findDragLaw("WenYu"), r.Re_s/r.alpha, r.alpha)/r.expected, 1, 1e-8);
    }
}

TEST(DragLaws, gidaspowIsErgunBelowAndWenYuFromFourFifths)
{
    for (double Re : {0.0, 1.0, 500.0})
    {
        EXPECT_EQ(gammaOf("Gidaspow", stateAt(Re, 0.799)), gammaOf("Ergun", stateAt(Re, 0.799)));
        EXPECT_EQ(gammaOf("ErgunWenYu", stateAt(Re, 0.8)), gammaOf("WenYu", stateAt(Re, 0.8)));
    }
}

// Validation case C33: a disc falls with drag rho U^2 d Cd/2 per length.
TEST(DragLaws, discs)
{
    for (double thickness : {1.0, 0.01})
    {
        const closures::GrainSize size = closures::discSize(5e-3, thickness);
        const auto excess = [&](double v)
        {
            return gammaOf("DallaValle", {size, v, 1, 1000, 1e-3})*v - size.volume*500*gravity;
        };
        EXPECT_NEAR(rootOf(excess, 1e-6, 10), 0.2569, 5e-5);
    }
}

// Ergun's bed of discs has the pressure gradient of its fluid fraction.
TEST(DragLaws, ergunOfDiscsIsPerVolume)
{
    const double U = 0.01, alpha = 0.42, d = 2e-3, phi = 1 - alpha;
    const closures::GrainSize size = closures::discSize(d, 0.3);
    const double force = gammaOf("Ergun", {size, U/alpha, alpha, 1000, 1e-3})*U/alpha;
    EXPECT_NEAR(phi/size.volume*force/alpha, 2387.7, 0.05);
}
