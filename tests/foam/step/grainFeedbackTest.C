// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What grains hand to the fluid, and what they are booked: the two sides against each other, and against sums made here.
#include "coupling/step/grainFeedback.H"
#include "fluidCase.H"
#include "mappingTools.H"
#include "spreadForce.H"
#include "stepTools.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr scalar deltaT = 0.02;

/// Grains in a box of fluid whose velocity and pressure gradient vary from cell to cell, with drag, response and debts at random.
struct Feedback
{
    FluidCase box;
    ::nscd::Grains grains;
    std::unique_ptr<GrainMapping> mapping;
    GrainsAtHome atHome;
    GrainExchange step;
    std::vector<Vec3> debt;

    static FluidCaseSettings settings()
    {
        FluidCaseSettings settings;
        settings.setCells(4, 3, 3);
        settings.setSize(4, 3, 3);
        return settings;
    }

    Feedback() : box(settings()), grains(makeGrains(randomPoints(12, Vec3(0.3, 0.3, 0.3), Vec3(3.7, 2.7, 2.7)), 0.25))
    {
        mapping = std::make_unique<GrainMapping>(box.mesh(), mappingDict("exact"), 0.25);
        mapping->update(grains, ::nscd::PeriodicBox());
        mapping->setFluidFraction(box.sources().fluidFraction);
        box.sources().hasResponse = true;
        const vectorField u = randomVectors(box.mesh().nCells(), 5), gradient = randomVectors(box.mesh().nCells(), 8);
        box.fluid();
        box.mesh().lookupObjectRef<volVectorField>("U").primitiveFieldRef() = u;
        box.mesh().lookupObjectRef<volVectorField>("balancedGradient").primitiveFieldRef() = gradient;
        RandomNumbers random(4);
        const std::size_t n = grains.size();
        for (Vec3& v : grains.velocity) v = random.vec();
        mapping->sample({}, {{u, step.at.velocity}, {gradient, step.at.pressureGradient}});
        step.drag = {random.numbers(n, 10, 50), random.numbers(n, 0, 5), random.numbers(n, 0.1, 1), {}, 0, {0, 0}, {}, {}, 0};
        step.drag.addedMass = random.numbers(n, 0.01, 0.05);
        step.drag.startFluid = random.vecs(n);
        step.drag.deltaT = deltaT;
        step.response = {random.vecs(n), random.numbers(n, 0, 1), random.numbers(n, 0, 0.1), false};
        step.startVelocity = grains.velocity;
        step.received = random.vecs(n);
        debt = random.vecs(n);
    }

    void handOver() { nscdCoupling::handOver(grains, step, debt, *mapping, atHome, 1000, deltaT, box.sources()); }

    Vec3 onFluid() { return toVec3(spreadForce(box.sources(), box.fluid())); }
};

Vec3 sum(const std::vector<Vec3>& values)
{
    Vec3 total = Vec3::Zero();
    for (const Vec3& value : values) total += value;
    return total;
}

} // namespace

TEST(GrainFeedback, theFluidLosesWhatTheGrainsAreBooked)
{
    for (const bool respond : {true, false})
    {
        for (const bool exchange : {true, false})
        {
            Feedback feedback;
            if (!respond) feedback.step.response = laggedResponse(feedback.grains);
            if (exchange) feedback.step.exchanged = RandomNumbers(6).vecs(feedback.grains.size());
            feedback.handOver();
            const StepBalance balance = settleDebt(feedback.step, deltaT, feedback.debt);
            EXPECT_LT((balance.paid + deltaT*feedback.onFluid()).norm(), 1e-12*balance.paid.norm()) << respond << exchange;
            EXPECT_GT(balance.paid.norm(), 0.01);
        }
    }
}

TEST(GrainFeedback, theFluidLosesAsMuchWhenGrainsTakeTheirWakeOut)
{
    for (const bool respond : {true, false})
    {
        Feedback feedback;
        if (!respond) feedback.step.response = laggedResponse(feedback.grains);
        std::vector<Vec3>& velocity = feedback.step.at.velocity;
        feedback.step.at.ownWake = RandomNumbers(7).vecs(velocity.size());
        for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] -= feedback.step.at.ownWake[i];
        feedback.handOver();
        const StepBalance balance = settleDebt(feedback.step, deltaT, feedback.debt);
        EXPECT_LT((balance.paid + deltaT*feedback.onFluid()).norm(), 1e-12*balance.paid.norm()) << respond;
    }
}

TEST(GrainFeedback, explicitForcesGoToTheFluidTurnedRoundAndAsTheyAre)
{
    Feedback feedback;
    const std::size_t n = feedback.grains.size();
    feedback.step.drag = {std::vector<scalar>(n, 0.0), std::vector<scalar>(n, 0.0), std::vector<scalar>(n, 1.0), {}, 0, {0, 0}, {}, {}, 0};
    feedback.debt.assign(n, Vec3::Zero());
    feedback.step.exchanged = RandomNumbers(6).vecs(n);
    feedback.handOver();
    // Cell by cell, by another way: each grain's shares of the force, from the weights themselves.
    vectorField onFluid(feedback.box.mesh().nCells(), Zero);
    const WeightMatrix& weights = feedback.mapping->weights();
    for (std::size_t i = 0; i < n; ++i)
    {
        for (label k = weights.rowStart[i]; k < weights.rowStart[i + 1]; ++k)
        {
            onFluid[weights.shares[k].cell] -= weights.shares[k].share*toFoam(feedback.step.exchanged[i]);
        }
    }
    const vectorField found(1000*feedback.box.mesh().V()*feedback.box.sources().acceleration.primitiveField());
    EXPECT_LT(max(mag(found - onFluid)), 1e-13);
    EXPECT_LT((feedback.onFluid() + sum(feedback.step.exchanged)).norm(), 1e-13);
}

TEST(GrainFeedback, theDebtIsWhatWasPaidAndNotReceivedLessTheShareRepaid)
{
    Feedback feedback;
    const std::vector<Vec3> before = feedback.debt;
    const GrainExchange& step = feedback.step;
    const StepBalance balance = settleDebt(step, deltaT, feedback.debt);
    Vec3 change = Vec3::Zero();
    scalar size = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const Vec3 u = step.at.velocity[i];
        const Vec3 answer = step.response.intercept[i] + step.response.slip[i]*u - step.response.mobility[i]*step.at.pressureGradient[i];
        const Vec3 slipping = step.drag.implicit[i]*(u - answer) + step.drag.remainder[i]*(u - step.startVelocity[i]);
        const Vec3 paid = deltaT*slipping + step.drag.addedMass[i]*(u - step.drag.startFluid[i]);
        EXPECT_LT((feedback.debt[i] - (before[i]/2 + paid - step.received[i])).norm(), 1e-13) << i;
        change += feedback.debt[i] - before[i];
        size += feedback.debt[i].norm();
    }
    EXPECT_LT((balance.debtChange - change).norm(), 1e-13);
    EXPECT_NEAR(balance.debt/size, 1, 1e-14);
    // Forces that both sides get as they are leave no debt.
    Feedback other;
    other.step.exchanged = RandomNumbers(6).vecs(before.size());
    settleDebt(other.step, deltaT, other.debt);
    EXPECT_EQ(other.debt, feedback.debt);
}

TEST(GrainFeedback, grainsThatDoNotAnswerLeaveTheTermsOfTheResponseZero)
{
    Feedback feedback;
    feedback.handOver();
    GrainSources& sources = feedback.box.sources();
    for (const volScalarField* field : {&sources.pressure, &sources.slip, &sources.mobility}) EXPECT_GT(max(mag(field->primitiveField())), 0);
    feedback.step.response = laggedResponse(feedback.grains);
    feedback.handOver();
    for (const volScalarField* field : {&sources.pressure, &sources.slip, &sources.mobility}) EXPECT_EQ(max(mag(field->primitiveField())), 0);
}
