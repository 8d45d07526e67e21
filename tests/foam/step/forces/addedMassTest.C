// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Added mass: velocities at the end of a step against the closed form, in one step and in parts; the suspension as a whole is in
// tests/validation/uniformSuspension.
#include "coupling/step/dragResponse.H"
#include "../stepTools.H"

#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const scalar deltaT = 1e-3;

struct Suspension : RandomSuspension
{
    std::vector<Vec3> start;  ///< u^n
    std::vector<Vec3> exchanged;
    GrainForces forces;
    LinearDrag drag;

    explicit Suspension(const std::string& law)
    :
        forces(forcesOf("drag { law " + law + "; } pressureGradient off; viscous off; spinDrag off; addedMass on;"), spheresInFluid)
    {
        RandomNumbers random(11);
        start = at.velocity;
        at.convection = random.vecs(size());
        exchanged = forces.exchanged(inputs());
        drag = forces.linearize(inputs(), {forces.explicitForces(inputs(), exchanged), lastContactForce, deltaT});
        // What the fluid does in the step.
        at.velocity = random.vecs(size());
    }

    /// Velocities after `parts` steps of deltaT/parts without contacts.
    std::vector<Vec3> after(int parts) const
    {
        RandomSuspension now(*this);
        for (int part = 0; part < parts; ++part)
        {
            const LinearDrag split = parts == 1 ? drag : forces.splitAgain(now.grains, drag, deltaT/parts);
            const auto external = forces.external(now.inputs(), forces.explicitForces(now.inputs(), exchanged), split);
            now.grains.velocity = freePrediction(now.grains, external, deltaT/parts).velocity;
        }
        return now.grains.velocity;
    }
};

} // namespace

/// (m + m_a) (v1 - v0)/dt = (m - rho V) g + m_a ((u1 - u0)/dt + (u . grad) u), m_a = rho V/2.
TEST(AddedMass, withoutDragIsThatOfHalfTheVolume)
{
    const Suspension s("none");
    const std::vector<Vec3> whole = s.after(1), parts = s.after(4);
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
    {
        const scalar volume = 4*constant::mathematical::pi/3*std::pow(s.grains.radius[i], 3), mass = 2500*volume, added = 500*volume;
        const Vec3 force = (mass - 1000*volume)*s.gravity + added*((s.at.velocity[i] - s.start[i])/deltaT + s.at.convection[i]);
        const Vec3 expected = s.grains.velocity[i] + deltaT/(mass + added)*force;
        EXPECT_LT((whole[i] - expected).norm(), 1e-13) << i;
        EXPECT_LT((parts[i] - expected).norm(), 1e-13) << i;
    }
    EXPECT_EQ(whole.back(), s.grains.velocity.back()) << "the held one";
}

/// Stokes' drag in a step: exact for a uniform fluid and a fluid that pulls evenly, with m + m_a for the mass.
TEST(AddedMass, dragSlowsTheMassThatIsTakenAlongToo)
{
    const Suspension s("Stokes");
    const std::vector<Vec3> whole = s.after(1);
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
    {
        const scalar d = 2*s.grains.radius[i], volume = constant::mathematical::pi*d*d*d/6, inertia = 3000*volume;
        const scalar gamma = 3*constant::mathematical::pi*s.at.viscosity[i]*d, k = gamma*deltaT/inertia;
        const Vec3 force = 1500*volume*s.gravity + 500*volume*((s.at.velocity[i] - s.start[i])/deltaT + s.at.convection[i]);
        const Vec3 terminal = s.at.velocity[i] + force/gamma;
        EXPECT_LT((whole[i] - terminal - std::exp(-k)*(s.grains.velocity[i] - terminal)).norm(), 1e-11*terminal.norm()) << i;
    }
}

TEST(AddedMass, isAskedForByNameAlone)
{
    const GrainForces with(forcesOf("addedMass on;"), spheresInFluid), without(forcesOf(""), spheresInFluid);
    EXPECT_TRUE(with.readsAtStart() & reads::convection);
    EXPECT_FALSE(without.readsAtStart() & reads::convection);
    EXPECT_FALSE(with.readsAfterSolve() & reads::convection);
    const RandomSuspension grains;
    EXPECT_TRUE(without.linearize(grains.inputs(), {grains.at.velocity, grains.lastContactForce, deltaT}).addedMass.empty());
}
