// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The wake of each grain in a fluid of random values, against the same worked out here, and what it corrects.
#include "coupling/step/ownWake.H"
#include "stepTools.H"

#include "closures/ownWake.hpp"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr scalar forEver = 1e9;

struct Wakes
{
    RandomSuspension suspension;
    std::vector<Vec3> fluidForce, wake;
    FluidAtGrains sampled;

    Wakes()
    {
        RandomNumbers random(9);
        const std::size_t n = suspension.size();
        OwnTrace& own = suspension.at.own;
        own.fraction = random.numbers(n, 0.01, 0.5);
        own.others.assign(n, 0.0);
        own.flowDiagonal = random.vecs(n);
        own.flowOffDiagonal = random.vecs(n);
        fluidForce = random.vecs(n);
        wake.assign(n, Vec3::Zero());
        sampled = suspension.at;
    }

    void follow(scalar deltaT, scalar stressShare = 1)
    {
        FluidAtGrains& at = suspension.at;
        at = sampled;
        followOwnWake(suspension.inputs(), fluidForce, stressShare, deltaT, at, wake);
    }

    /// Flow of the force that the fluid gets, hydrostatic force apart, with inertia by the slip without the larger part of the wake `before`.
    Vec3 steady(std::size_t i, const Vec3& before) const
    {
        const Vec3& d = sampled.own.flowDiagonal[i];
        const Vec3& o = sampled.own.flowOffDiagonal[i];
        Eigen::Matrix3d flow;
        flow << d[0], o[2], o[1],  o[2], d[1], o[0],  o[1], o[0], d[2];
        const scalar volume = suspension.grains.volume(i);
        const Vec3 onGrain = fluidForce[i] + suspension.density*volume*suspension.gravity;
        const scalar h = std::cbrt(volume/sampled.own.fraction[i]);
        const scalar Re = suspension.density*(sampled.velocity[i] - (1 - closures::wakeTakenAlong)*before - suspension.grains.velocity[i]).norm()*h/sampled.viscosity[i];
        return -flow*onGrain/sampled.viscosity[i]/(1 + 0.20*Re + 0.10*Re/(Re + 0.05));
    }
};

} // namespace

TEST(OwnWakeOfGrains, isTheFlowOfTheForceOnTheFluidAndLeavesTheVelocity)
{
    Wakes wakes;
    wakes.follow(forEver);
    for (std::size_t i = 0; i < wakes.wake.size(); ++i)
    {
        const Vec3 expected = wakes.steady(i, Vec3::Zero());
        EXPECT_LT((wakes.wake[i] - expected).norm(), 1e-12*expected.norm()) << i;
        EXPECT_LT((wakes.suspension.at.velocity[i] + expected - wakes.sampled.velocity[i]).norm(), 1e-12*expected.norm());
    }
    // Sampled anew after the fluid is solved.
    FluidAtGrains& at = wakes.suspension.at;
    const std::vector<Vec3> once = at.velocity;
    at.velocity = wakes.sampled.velocity;
    removeOwnWake(at);
    EXPECT_EQ(at.velocity, once);
}

/// Wakes that are there already count with the part that the grain does not take along.
TEST(OwnWakeOfGrains, knowsTheWakeOfBefore)
{
    Wakes wakes;
    const std::vector<Vec3> before = RandomNumbers(11).vecs(wakes.wake.size());
    wakes.wake = before;
    wakes.follow(forEver);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const Vec3 expected = wakes.steady(i, before[i]);
        EXPECT_LT((wakes.wake[i] - expected).norm(), 1e-12*expected.norm()) << i;
    }
}

TEST(OwnWakeOfGrains, followsTheForceInItsTime)
{
    Wakes wakes;
    wakes.follow(1e-7);
    for (std::size_t i = 0; i < wakes.wake.size(); ++i)
    {
        const RandomSuspension& suspension = wakes.suspension;
        const scalar h = std::cbrt(suspension.grains.volume(i)/wakes.sampled.own.fraction[i]);
        const scalar slip = (wakes.sampled.velocity[i] - suspension.grains.velocity[i]).norm();
        const scalar time = closures::wakeTime(wakes.sampled.viscosity[i], suspension.density, h, slip);
        const Vec3 expected = 1e-7/time*wakes.steady(i, Vec3::Zero());
        EXPECT_LT((wakes.wake[i] - expected).norm(), 1e-4*expected.norm());
    }
}

TEST(OwnWakeOfGrains, takesTheOwnPartOutOfAlphaAndOfTheStress)
{
    Wakes wakes;
    wakes.follow(forEver, 2.0/3);
    for (std::size_t i = 0; i < wakes.wake.size(); ++i)
    {
        EXPECT_NEAR(wakes.suspension.at.fluidFraction[i], wakes.sampled.fluidFraction[i] + wakes.sampled.own.fraction[i], 1e-15);
        EXPECT_NEAR(wakes.suspension.at.dragFactor[i], 1 - wakes.sampled.own.fraction[i]*2/3, 1e-15);
    }
}

TEST(OwnWakeOfGrains, isForgottenAmongOthers)
{
    Wakes wakes;
    wakes.follow(forEver);
    wakes.sampled.own.others.assign(wakes.wake.size(), 0.3);
    wakes.follow(1e-9);
    for (std::size_t i = 0; i < wakes.wake.size(); ++i)
    {
        EXPECT_EQ(wakes.wake[i], Vec3::Zero());
        EXPECT_EQ(wakes.suspension.at.velocity[i], wakes.sampled.velocity[i]);
        EXPECT_EQ(wakes.suspension.at.fluidFraction[i], wakes.sampled.fluidFraction[i]);
        EXPECT_EQ(wakes.suspension.at.dragFactor[i], 1);
    }
}

TEST(OwnWakeOfGrains, hasNoneOutsideTheMesh)
{
    Wakes wakes;
    wakes.sampled.own.fraction[2] = 0;
    wakes.follow(1e-3);
    EXPECT_EQ(wakes.wake[2], Vec3::Zero());
    EXPECT_EQ(wakes.suspension.at.velocity[2], wakes.sampled.velocity[2]);
    EXPECT_NE(wakes.wake[3], Vec3::Zero());
}

TEST(OwnWakeOfGrains, ofStressIsThatOfTheForcesThatAreOn)
{
    EXPECT_NEAR(ownStressShare(forcesOf("")), 1, 1e-15);
    EXPECT_NEAR(ownStressShare(forcesOf("viscous off;")), 1.0/3, 1e-15);
    EXPECT_NEAR(ownStressShare(forcesOf("pressureGradient off; viscous off;")), 0, 1e-15);
}

/// The factor reaches the coefficient: law and Reynolds number stay.
TEST(OwnWakeOfGrains, scalesTheDragCoefficient)
{
    RandomSuspension suspension;
    const GrainForces forces(forcesOf("drag { law SchillerNaumann; weight backwardEuler; }"), spheresInFluid);
    suspension.lastContactForce.assign(suspension.size(), Vec3::Ones());
    const std::vector<Vec3> none(suspension.size(), Vec3::Zero());
    const StepInputs step{none, suspension.lastContactForce, 1e-3};
    const LinearDrag whole = forces.linearize(suspension.inputs(), step);
    suspension.at.dragFactor.assign(suspension.size(), 0.7);
    const LinearDrag less = forces.linearize(suspension.inputs(), step);
    for (std::size_t i = 0; i < suspension.size(); ++i) EXPECT_NEAR(less.implicit[i]/whole.implicit[i], 0.7, 1e-13);
}
