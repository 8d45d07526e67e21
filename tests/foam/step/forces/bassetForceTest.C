// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The Basset force: a sphere that rises from rest in creeping flow against the closed form, what is remembered, and steps of changing length.
#include "coupling/step/dragResponse.H"
#include "coupling/step/slipHistory.H"
#include "../stepTools.H"

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const scalar radius = 5e-4, density = 1000, viscosity = 1e-3, rhoP = 500;
const scalar unitTime = radius*radius*density/viscosity;   // a^2/nu, 0.25 s

scalar terminalSpeed() { return 2*radius*radius*(density - rhoP)*9.81/(9*viscosity); }

/// exp(x^2 t) erfc(-x sqrt(t))
scalar scaled(scalar x, scalar t) { return std::exp(x*x*t)*std::erfc(-x*std::sqrt(t)); }

/// Of (2 s + 1)/9 v' + v + int v'/sqrt(pi (t - tau)) dtau = 1, s = rho_p/rho, v(0) = 0, in units of a^2/nu and the terminal speed: its transform is
/// 1/(y^2 (A y^2 + y + 1)), y^2 the variable, whose roots are real where s < 5/8.
scalar risen(scalar t)
{
    const scalar A = (2*rhoP/density + 1)/9, root = std::sqrt(1 - 4*A), x = (-1 + root)/(2*A), z = (-1 - root)/(2*A);
    return ((scaled(x, t) - 1)/x - (scaled(z, t) - 1)/z)/(A*(x - z));
}

/// A sphere in a fluid at rest, with its history.
struct Rising
{
    ::nscd::Grains grains;
    FluidAtGrains at;
    std::vector<Vec3> lastContactForce{Vec3::Zero()};
    GrainMemory memory;
    SlipHistory history{memory};
    GrainForces forces{forcesOf("drag { law Stokes; } addedMass on; basset on; pressureGradient off; viscous off; spinDrag off;"), spheresInFluid};
    scalar lastDeltaT = 0;

    Rising()
    {
        grains.add(Vec3::Zero(), radius, rhoP, 0, 0);
        at.velocity = at.convection = {Vec3::Zero()};
        at.viscosity = {viscosity};
        at.fluidFraction = {1};
        memory.start(1);
    }

    ForceInputs inputs() const { return {grains, at, density, Vec3(0, 0, -9.81)}; }

    void step(scalar deltaT)
    {
        history.follow(inputs(), deltaT, lastDeltaT, at);
        const std::vector<Vec3> exchanged = forces.exchanged(inputs());
        const std::vector<Vec3> force = forces.explicitForces(inputs(), exchanged);
        const LinearDrag drag = forces.linearize(inputs(), {force, lastContactForce, deltaT});
        grains.velocity = freePrediction(grains, forces.external(inputs(), force, drag), deltaT).velocity;
        lastDeltaT = deltaT;
    }

    scalar speed() const { return grains.velocity[0][2]/terminalSpeed(); }
};

/// Largest difference from the closed form up to two units of time, with so many steps a unit.
scalar largestError(int steps)
{
    Rising sphere;
    scalar most = 0;
    for (int k = 1; k <= 2*steps; ++k)
    {
        sphere.step(unitTime/steps);
        most = std::max(most, std::abs(sphere.speed() - risen(scalar(k)/steps)));
    }
    return most;
}

} // namespace

TEST(Basset, aSphereRisesFromRestAsInClosedForm)
{
    EXPECT_NEAR(risen(1e-6), 1e-6*9/2, 2e-8);
    EXPECT_LT(risen(2), 0.8) << "without its history it would have come to 1";
    const scalar coarse = largestError(20), fine = largestError(80), finest = largestError(320);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, coarse/2.5);
    EXPECT_LT(finest, 0.003);
}

TEST(Basset, stepsMayChange)
{
    Rising sphere;
    scalar t = 0;
    for (int k = 0; t < 2*unitTime; ++k)
    {
        const scalar deltaT = (k % 3 + 1)*unitTime/200;
        sphere.step(deltaT);
        t += deltaT;
    }
    EXPECT_NEAR(sphere.speed(), risen(t/unitTime), 0.005);
}

/// What a grain had of slip when it came in is no part of its history.
TEST(Basset, beginsWithoutAPast)
{
    Rising sphere;
    sphere.grains.velocity[0] = Vec3(1, 2, 3);
    sphere.history.follow(sphere.inputs(), 1e-3, 1e-3, sphere.at);
    EXPECT_EQ(sphere.at.historyForce[0], Vec3::Zero());
    sphere.history.follow(sphere.inputs(), 1e-3, 1e-3, sphere.at);
    EXPECT_EQ(sphere.at.historyForce[0], Vec3::Zero()) << "nothing has changed";
    sphere.grains.velocity[0] = Vec3(1, 2, 2);
    sphere.history.follow(sphere.inputs(), 1e-3, 1e-3, sphere.at);
    EXPECT_GT(sphere.at.historyForce[0][2], 0);
    EXPECT_EQ(sphere.at.historyForce[0][0], 0);
}
