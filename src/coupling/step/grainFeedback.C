// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spreading what acts on the grains, and booking what both sides got.
#include "coupling/step/grainFeedback.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Amounts per grain whose spread fields are the sources.
struct GrainAmounts
{
    std::vector<scalar> drag;
    std::vector<Vec3> acceleration;
    std::vector<scalar> pressure;
    std::vector<Vec3> carried;
    std::vector<scalar> slip;
    std::vector<scalar> mobility;
};

GrainAmounts amountsOf
(
    const ::nscd::Grains& grains, const GrainExchange& step, const std::vector<Vec3>& debt, scalar fluidDensity, scalar deltaT
)
{
    const LinearDrag& drag = step.drag;
    const GrainResponse& response = step.response;
    const std::size_t n = grains.nOwned;
    GrainAmounts amounts;
    amounts.drag.resize(n);
    amounts.acceleration.resize(n);
    amounts.carried.resize(n);
    if (!response.isZero)
    {
        amounts.pressure.resize(n);
        amounts.slip.resize(n);
        amounts.mobility.resize(n);
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        const Vec3 own = step.at.ownWake.empty() ? Vec3::Zero() : step.at.ownWake[i];
        const Vec3 intercept = response.intercept[i] - response.slip[i]*own;
        amounts.drag[i] = (drag.implicit[i]*(1 - response.slip[i]) + drag.remainder[i] + drag.pullCoefficient(i))/fluidDensity;
        const Vec3 repaid = repaidShare/deltaT*debt[i];
        const Vec3 answered = drag.implicit[i]*(intercept + own) + drag.remainder[i]*(grains.velocity[i] + own) - drag.pull(i, -own);
        amounts.acceleration[i] = (answered + repaid)/fluidDensity;
        amounts.carried[i] = grains.volume(i)*intercept;
        if (response.isZero) continue;
        amounts.pressure[i] = drag.implicit[i]*response.mobility[i];
        amounts.slip[i] = grains.volume(i)*response.slip[i];
        amounts.mobility[i] = fluidDensity*grains.volume(i)*response.mobility[i];
    }
    for (std::size_t i = 0; i < step.exchanged.size(); ++i) amounts.acceleration[i] -= step.exchanged[i]/fluidDensity;
    return amounts;
}

} // namespace

void handOver
(
    const ::nscd::Grains& grains, const GrainExchange& step, const std::vector<Vec3>& debt, const GrainMapping& mapping,
    const GrainsAtHome& atHome, scalar fluidDensity, scalar deltaT, GrainSources& sources
)
{
    const GrainResponse& response = step.response;
    GrainAmounts amounts = amountsOf(grains, step, debt, fluidDensity, deltaT);
    GrainValues values{{&amounts.drag}, {&amounts.acceleration, &amounts.carried}};
    if (!response.isZero) values.scalars.insert(values.scalars.end(), {&amounts.pressure, &amounts.slip, &amounts.mobility});
    atHome.toHomes(values);
    std::vector<ScalarSpread> scalars{{amounts.drag, sources.drag.primitiveFieldRef()}};
    const std::vector<VectorSpread> vectors
    {
        {amounts.acceleration, sources.acceleration.primitiveFieldRef()},
        {amounts.carried, sources.carried.primitiveFieldRef()}
    };
    if (!response.isZero)
    {
        scalars.push_back({amounts.pressure, sources.pressure.primitiveFieldRef()});
        scalars.push_back({amounts.slip, sources.slip.primitiveFieldRef()});
        scalars.push_back({amounts.mobility, sources.mobility.primitiveFieldRef()});
    }
    mapping.spread(scalars, vectors);
    if (response.isZero)
    {
        for (volScalarField* field : {&sources.pressure, &sources.slip, &sources.mobility}) field->primitiveFieldRef() = 0;
    }
    if (sources.isModelB) sources.pressure.primitiveFieldRef() += 1 - sources.fluidFraction.primitiveField();
    sources.correctBoundaryConditions();
}

StepBalance settleDebt(const GrainExchange& step, scalar deltaT, std::vector<Vec3>& debt)
{
    const std::size_t n = step.received.size();
    const bool feelsPressure = !step.at.pressureGradient.empty();
    const std::vector<Vec3> none(feelsPressure ? 0 : n, Vec3::Zero());
    const std::vector<Vec3>& gradient = feelsPressure ? step.at.pressureGradient : none;
    StepBalance balance;
    for (std::size_t i = 0; i < n; ++i)
    {
        const Vec3& v0 = step.startVelocity[i];
        const Vec3 paid = deltaT*paidDrag(step.drag, step.response, v0, i, step.at.velocity[i], gradient[i]);
        const Vec3 repaid = repaidShare*debt[i];
        const Vec3 change = paid - step.received[i] - repaid;
        debt[i] += change;
        balance.paid += paid - repaid;
        balance.debtChange += change;
        balance.debt += debt[i].norm();
    }
    for (const Vec3& force : step.exchanged) balance.paid += deltaT*force;
    return balance;
}

} // namespace nscdCoupling
} // namespace Foam
