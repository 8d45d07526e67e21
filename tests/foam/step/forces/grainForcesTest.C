// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The forces on the grains that every case has, and the choice of them: each against its formula.
#include "coupling/step/forces/forceTable.H"
#include "../stepTools.H"

#include "closures/dragLaws.hpp"
#include "closures/implicitDrag.hpp"

#include "mathematicalConstants.H"

#include <set>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string noForce = "drag { law none; } pressureGradient off; viscous off; spinDrag off; ";

/// Explicit forces of a case whose `forces` are as given.
std::vector<Vec3> explicitForces(const RandomSuspension& grains, const std::string& settings)
{
    const GrainForces forces(forcesOf(settings), spheresInFluid);
    return forces.explicitForces(grains.inputs(), forces.exchanged(grains.inputs()));
}

LinearDrag linearized(const GrainForces& forces, const RandomSuspension& grains, scalar deltaT)
{
    const std::vector<Vec3> force = forces.explicitForces(grains.inputs(), {});
    return forces.linearize(grains.inputs(), {force, grains.lastContactForce, deltaT});
}

} // namespace

TEST(GrainForces, theKeywordsAreTheRowsOfTheTable)
{
    std::set<std::string> rows, keywords;
    for (const ForceRow& row : forceTable())
    {
        if (row.isSwitched) rows.insert(row.name);
    }
    for (const auto& given : forcesOf("").switches) keywords.insert(given.first);
    keywords.erase("modelB");   // says which of the rows act, and is none
    EXPECT_EQ(rows, keywords);
}

TEST(GrainForces, weightPressureAndStressFollowTheirFormulas)
{
    const RandomSuspension grains;
    const std::vector<Vec3> weight = explicitForces(grains, noForce);
    const std::vector<Vec3> pressed = explicitForces(grains, noForce + "pressureGradient on;");
    const std::vector<Vec3> sheared = explicitForces(grains, noForce + "viscous on;");
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar d = 2*grains.grains.radius[i], volume = constant::mathematical::pi*d*d*d/6;
        const Vec3 submerged = (2500 - 1000)*volume*grains.gravity;
        EXPECT_LT((weight[i] - submerged).norm(), 1e-14*submerged.norm());
        EXPECT_LT((pressed[i] - weight[i] + volume*grains.at.pressureGradient[i]).norm(), 1e-14*submerged.norm());
        EXPECT_LT((sheared[i] - weight[i] - volume*grains.at.divTau[i]).norm(), 1e-14*submerged.norm());
    }
}

TEST(GrainForces, withoutFluidTheWholeWeightIsLeft)
{
    RandomSuspension grains;
    grains.density = 0;
    grains.at = FluidAtGrains();
    const GrainForces forces(forcesOf(""), {false, true, true});
    EXPECT_EQ(forces.readsAtStart(), reads::nothing);
    const std::vector<Vec3> force = forces.explicitForces(grains.inputs(), {});
    for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_EQ(force[i], grains.grains.mass[i]*grains.gravity);
    const ::nscd::ExternalForces external = forces.external(grains.inputs(), force, LinearDrag());
    EXPECT_EQ(external.force, force);
    EXPECT_TRUE(external.torque.empty() && external.implicitDrag.empty() && external.implicitSpinDrag.empty());
}

TEST(GrainForces, readWhatTheyNeedAndWhen)
{
    const auto startAndAfter = [](const std::string& settings)
    {
        const GrainForces forces(forcesOf(settings), spheresInFluid);
        return std::make_pair(forces.readsAtStart(), forces.readsAfterSolve());
    };
    using Pair = std::pair<unsigned, unsigned>;
    EXPECT_EQ(startAndAfter(noForce), Pair(reads::nothing, reads::nothing));
    EXPECT_EQ(startAndAfter(noForce + "pressureGradient on;"), Pair(reads::pressureGradient, reads::pressureGradient));
    EXPECT_EQ(startAndAfter(noForce + "viscous on;"), Pair(reads::divTau, reads::divTau));
    const unsigned ofDrag = reads::viscosity | reads::fluidFraction, ofSpin = reads::viscosity | reads::spin;
    EXPECT_EQ(startAndAfter(noForce + "drag { law Stokes; }"), Pair(ofDrag, reads::nothing));
    EXPECT_EQ(startAndAfter(noForce + "drag { law Stokes; } spinDrag on;"), Pair(ofDrag | ofSpin, ofSpin));
    // Without drag there is no viscous torque, and without friction no spin.
    EXPECT_EQ(startAndAfter(noForce + "spinDrag on;"), Pair(reads::nothing, reads::nothing));
    EXPECT_EQ(GrainForces(forcesOf(""), {true, false, true}).readsAtStart() & reads::spin, 0u);
    EXPECT_TRUE(GrainForces(forcesOf(""), spheresInFluid).followPressure());
    EXPECT_FALSE(GrainForces(forcesOf("pressureGradient off;"), spheresInFluid).followPressure());
}

TEST(GrainForces, dragIsThatOfItsLawSplitOverTheStep)
{
    const RandomSuspension grains;
    const GrainForces forces(forcesOf("drag { law DiFelice; weight backwardEuler; }"), spheresInFluid);
    const scalar deltaT = 1e-3;
    const LinearDrag drag = linearized(forces, grains, deltaT);
    const std::vector<Vec3> force = forces.explicitForces(grains.inputs(), {});
    scalar stiffest = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3& u = grains.at.velocity[i];
        const closures::DragLaw law = closures::findDragLaw("DiFelice").law;
        const closures::DragState state{closures::sphereSize(2*grains.grains.radius[i]), (u - grains.grains.velocity[i]).norm(),
            grains.at.fluidFraction[i], grains.density, grains.at.viscosity[i]};
        const bool isFree = i % 3 != 0 && !grains.grains.isFixed[i];
        const scalar mass = grains.grains.mass[i];
        const scalar gamma = !isFree ? law(state) : closures::gammaAtMidSlip
        (
            law, state, {u, force[i], mass, deltaT}, grains.grains.velocity[i], closures::backwardEuler
        );
        EXPECT_NEAR(drag.implicit[i]/gamma, 1, 1e-14);
        EXPECT_NEAR(drag.remainder[i]/gamma, 0, 1e-14);
        EXPECT_NEAR(drag.velocityFactor[i], 1/(1 + gamma*deltaT/mass), 1e-14);
        EXPECT_NEAR(drag.spin[i]/(constant::mathematical::pi*grains.at.viscosity[i]*std::pow(2*grains.grains.radius[i], 3)), 1, 1e-14);
        if (!grains.grains.isFixed[i]) stiffest = std::max(stiffest, gamma*deltaT/mass);
    }
    EXPECT_NEAR(drag.largestStiffness/stiffest, 1, 1e-14);
}

// Of a grain in a mix: y^2 the coefficient of the mean diameter, y = d/<d>; without a home, as a grain of its own size.
TEST(GrainForces, dragInAMixOfSizesIsThatOfTheMeanTimesTheSquareOfTheRatio)
{
    RandomSuspension grains;
    for (std::size_t i = 0; i < grains.size(); ++i) grains.lastContactForce[i] = Vec3(1, 0, 0);
    for (std::size_t i = 0; i < grains.size(); ++i) grains.at.meanDiameter.push_back(i % 5 ? 0.7e-3 + 0.05e-3*scalar(i) : 0);
    const GrainForces mixed(forcesOf("drag { law Beetstra; polydisperse on; }"), spheresInFluid);
    EXPECT_TRUE(mixed.readsAtStart() & reads::meanDiameter);
    EXPECT_FALSE(mixed.readsAfterSolve() & reads::meanDiameter);
    const LinearDrag drag = linearized(mixed, grains, 1e-3);
    const closures::DragLaw law = closures::findDragLaw("Beetstra").law;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar d = 2*grains.grains.radius[i], mean = i % 5 ? grains.at.meanDiameter[i] : d;
        const scalar slip = (grains.at.velocity[i] - grains.grains.velocity[i]).norm();
        const scalar ofMean = law({closures::sphereSize(mean), slip, grains.at.fluidFraction[i], grains.density, grains.at.viscosity[i]});
        EXPECT_NEAR((drag.implicit[i] + drag.remainder[i])/(d*d/(mean*mean)*ofMean), 1, 1e-12) << i;
    }
    EXPECT_FALSE(GrainForces(forcesOf("drag { law Beetstra; }"), spheresInFluid).readsAtStart() & reads::meanDiameter);
    const std::string refusal = complaint([] { GrainForces(forcesOf("drag { polydisperse on; }"), {true, true, false}); });
    EXPECT_NE(refusal.find("forces.drag.polydisperse"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("is for spheres"), std::string::npos) << refusal;
}

TEST(GrainForces, howFarGrainsAreBeyondTheRangeOfTheLawIsKnown)
{
    RandomSuspension grains;
    scalar Re = 0, lowest = 1;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar slip = (grains.at.velocity[i] - grains.grains.velocity[i]).norm(), alpha = grains.at.fluidFraction[i];
        Re = std::max(Re, grains.density*alpha*slip*2*grains.grains.radius[i]/grains.at.viscosity[i]);
        lowest = std::min(lowest, alpha);
    }
    const LinearDrag drag = linearized(GrainForces(forcesOf("drag { law Stokes; }"), spheresInFluid), grains, 1e-3);
    EXPECT_NEAR(drag.beyond.Re/(Re/0.1), 1, 1e-12);
    ASSERT_LT(lowest, 0.95);
    EXPECT_NEAR(drag.beyond.fluidFraction, 0.95 - lowest, 1e-14);
    EXPECT_EQ(linearized(GrainForces(forcesOf("drag { law DiFelice; }"), spheresInFluid), grains, 1e-3).beyond.fluidFraction, 0);
}

TEST(GrainForces, aShorterStepKeepsTheCoefficientAndItsShareIsImplicit)
{
    const RandomSuspension grains;
    const GrainForces forces(forcesOf(""), spheresInFluid);
    const LinearDrag whole = linearized(forces, grains, 0.1), part = forces.splitAgain(grains.grains, whole, 0.025);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar gamma = whole.implicit[i] + whole.remainder[i], mass = grains.grains.mass[i];
        EXPECT_NEAR((part.implicit[i] + part.remainder[i])/gamma, 1, 1e-13);
        EXPECT_NEAR(part.implicit[i]*0.025/mass, closures::exponential(gamma*0.025/mass), 1e-12*(1 + gamma*0.025/mass));
        EXPECT_NEAR(part.velocityFactor[i], 1/(1 + part.implicit[i]*0.025/mass), 1e-14);
    }
    EXPECT_EQ(part.spin, whole.spin);
    EXPECT_EQ(part.largestStiffness, whole.largestStiffness);
}

TEST(GrainForces, theLibraryGetsForcesWithTheFluidsVelocityAndTorquesWithItsSpin)
{
    const RandomSuspension grains;
    const GrainForces forces(forcesOf(""), spheresInFluid);
    const LinearDrag drag = linearized(forces, grains, 0.01);
    const std::vector<Vec3> force = forces.explicitForces(grains.inputs(), {});
    const ::nscd::ExternalForces external = forces.external(grains.inputs(), force, drag);
    EXPECT_EQ(external.implicitDrag, drag.implicit);
    EXPECT_EQ(external.implicitSpinDrag, drag.spin);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3 u = grains.at.velocity[i], v = grains.grains.velocity[i];
        const Vec3 onGrain = force[i] + (drag.implicit[i] + drag.remainder[i])*u - drag.remainder[i]*v;
        EXPECT_LT((external.force[i] - onGrain).norm(), 1e-14*(force[i].norm() + drag.implicit[i]));
        EXPECT_EQ(external.torque[i], drag.spin[i]*grains.at.spin[i]);
    }
}

TEST(GrainForces, theSpeedScaleIsTheLargestOfForcesTakenOneByOne)
{
    RandomSuspension grains;
    const GrainForces forces(forcesOf(""), spheresInFluid);
    const scalar deltaT = 1e-3;
    const auto scale = [&](const std::vector<Vec3>& exchanged)
    {
        return forces.speedScale(grains.inputs(), exchanged, linearized(forces, grains, deltaT), deltaT, ::nscd::Exchange());
    };
    const auto rms = [&](const auto& forceOn)
    {
        const LinearDrag drag = linearized(forces, grains, deltaT);
        scalar sum = 0;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            sum += (deltaT/grains.grains.mass[i]*drag.velocityFactor[i]*forceOn(i)).squaredNorm();
        }
        return std::sqrt(sum/scalar(grains.size()));
    };
    const std::vector<Vec3> none;
    const auto drag = [&](std::size_t i)
    {
        const LinearDrag linear = linearized(forces, grains, deltaT);
        return Vec3((linear.implicit[i] + linear.remainder[i])*(grains.at.velocity[i] - grains.grains.velocity[i]));
    };
    EXPECT_NEAR(scale(none)/rms(drag), 1, 1e-13);
    grains.gravity *= 1e6;
    const auto weight = [&](std::size_t i) { return Vec3((1 - 1000./2500)*grains.grains.mass[i]*grains.gravity); };
    EXPECT_NEAR(scale(none)/rms(weight), 1, 1e-13);
    for (Vec3& gradient : grains.at.pressureGradient) gradient *= 1e13;
    const auto pressure = [&](std::size_t i) { return Vec3(grains.grains.volume(i)*grains.at.pressureGradient[i]); };
    EXPECT_NEAR(scale(none)/rms(pressure), 1, 1e-13);
    for (Vec3& stress : grains.at.divTau) stress *= 1e16;
    const auto stress = [&](std::size_t i) { return Vec3(grains.grains.volume(i)*grains.at.divTau[i]); };
    EXPECT_NEAR(scale(none)/rms(stress), 1, 1e-13);
    const std::vector<Vec3> exchanged(grains.size(), Vec3(0, 1e12, 0));
    EXPECT_NEAR(scale(exchanged)/rms([&](std::size_t i) { return exchanged[i]; }), 1, 1e-13);
}
