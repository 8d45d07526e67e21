// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sums that decay.
#include "coupling/step/slipHistory.H"

#include "closures/historyKernel.hpp"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const Remembered<scalar> ageOfHistory{"slipHistoryAge", "s", 0, true, OnRestart::optional};
const Remembered<Vec3> lastSlip{"slipHistoryLast", "m/s", Vec3::Zero(), true, OnRestart::optional};

Remembered<Vec3> sumOfTerm(std::size_t k) { return {word("slipHistory" + std::to_string(k)), "m/s", Vec3::Zero(), true, OnRestart::optional}; }

} // namespace

SlipHistory::SlipHistory(GrainMemory& memory)
:
    age_(memory.add(ageOfHistory)),
    slip_(memory.add(lastSlip))
{
    for (std::size_t k = 0; k < closures::historyTerms; ++k) sums_.push_back(&memory.add(sumOfTerm(k)));
}

void SlipHistory::follow(const ForceInputs& in, scalar deltaT, scalar lastDeltaT, FluidAtGrains& at)
{
    const std::size_t n = in.grains.size();
    at.historyForce.assign(n, Vec3::Zero());
    at.historyMass.assign(n, 0);
    std::vector<scalar> coefficient(n);
    std::vector<Vec3> change(n, Vec3::Zero());
    for (std::size_t i = 0; i < n; ++i)
    {
        const Vec3 slip = at.velocity[i] - in.grains.velocity[i];
        if (age_[i] > 0) change[i] = slip - slip_[i];
        slip_[i] = slip;
        age_[i] += deltaT;
        // A parcel's force is that of its real grains, l^3 of them.
        coefficient[i] = pow3(in.coarseness(i))*closures::bassetCoefficient(2*in.realRadius[i], in.fluidDensity, at.viscosity[i]);
        at.historyMass[i] = 4*coefficient[i]*std::sqrt(deltaT)/3;
    }
    for (std::size_t k = 0; k < sums_.size(); ++k)
    {
        const closures::HistoryTerm& term = closures::historyKernel()[k];
        const scalar decay = std::exp(-term.rate*lastDeltaT), taken = closures::meanDecay(term.rate*lastDeltaT);
        const scalar given = term.weight*closures::meanDecay(term.rate*deltaT);
        std::vector<Vec3>& sum = *sums_[k];
        for (std::size_t i = 0; i < n; ++i)
        {
            sum[i] = decay*sum[i] + taken*change[i];
            at.historyForce[i] += coefficient[i]*given*sum[i];
        }
    }
}

} // namespace nscdCoupling
} // namespace Foam
