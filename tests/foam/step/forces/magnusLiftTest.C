// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Magnus lift through the real mapping, against the formula of the paper as it stands there.
#include "exchangedForces.H"

using namespace Foam;
using namespace Foam::nscdCoupling::testing;
using Foam::nscdCoupling::Vec3;

TEST(MagnusLift, isThatOfTheFlowAtTheGrain)
{
    expectForce("magnusLift", [](const SphereInFlow& s)
    {
        const Vec3 W = 0.5*s.vorticity - s.omega;
        const scalar mu = 0.2, rho = 1000, d = s.diameter, us = s.slip.norm();
        const scalar Re = rho*us*d/mu, ReR = rho*d*d*W.norm()/mu;
        EXPECT_GT(Re, 1);
        const scalar C = 0.45 + (ReR/Re - 0.45)*std::exp(-0.05684*std::pow(ReR, 0.4)*std::pow(Re, 0.3));
        return Vec3(0.5*rho*constant::mathematical::pi/4*d*d*C*us/W.norm()*W.cross(s.slip));
    });
}

TEST(MagnusLift, theFluidGetsTheOpposite) { expectTheFluidGetsTheOpposite("magnusLift"); }

TEST(MagnusLift, isOffUnlessNamedAndForSpheres) { expectOffUnlessNamed("magnusLift"); }
