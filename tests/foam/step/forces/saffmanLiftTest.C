// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Shear lift through the real mapping, against the formulas of the papers as they stand there.
#include "exchangedForces.H"

using namespace Foam;
using namespace Foam::nscdCoupling::testing;
using Foam::nscdCoupling::Vec3;

TEST(SaffmanLift, isThatOfTheFlowAtTheGrain)
{
    expectForce("saffmanLift", [](const SphereInFlow& s)
    {
        const scalar mu = 0.2, rho = 1000, w = s.vorticity.norm(), us = s.slip.norm();
        const scalar Re = rho*us*s.diameter/mu, beta = w*s.diameter/(2*us), root = 0.3314*std::sqrt(beta);
        EXPECT_LT(Re, 40);
        const scalar C = (1 - root)*std::exp(-Re/10) + root;
        return Vec3(1.615*s.diameter*s.diameter*std::sqrt(rho*mu/w)*C*s.slip.cross(s.vorticity));
    });
}

TEST(SaffmanLift, theFluidGetsTheOpposite) { expectTheFluidGetsTheOpposite("saffmanLift"); }

TEST(SaffmanLift, isOffUnlessNamedAndForSpheres) { expectOffUnlessNamed("saffmanLift"); }
