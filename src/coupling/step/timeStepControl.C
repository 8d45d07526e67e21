// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Step length from Courant number and grain displacement.
#include "coupling/step/timeStepControl.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

constexpr scalar largestGrowth = 1.2;
constexpr scalar keptOfRate = 0.9;      // from step to step, of a rate of impacts that has gone down

StepLimits readLimits(const Time& time, scalar maxDisplacement)
{
    StepLimits limits;
    limits.maxCourant = time.controlDict().lookupOrDefault<scalar>("maxCo", 1.0);
    limits.maxDeltaT = time.controlDict().lookupOrDefault<scalar>("maxDeltaT", GREAT);
    limits.maxDisplacement = maxDisplacement;
    return limits;
}

} // namespace

void adjustTimeStep(Time& time, const StepReach& last, scalar maxDisplacement)
{
    if (!time.controlDict().lookupOrDefault("adjustTimeStep", false)) return;
    const StepLimits limits = readLimits(time, maxDisplacement);

    scalar factor = largestGrowth;
    if (limits.maxCourant > 0 && last.courant > 0) factor = min(factor, limits.maxCourant/last.courant);
    if (limits.maxDisplacement > 0 && last.displacement > 0) factor = min(factor, limits.maxDisplacement/last.displacement);
    time.setDeltaT(min(factor*time.deltaTValue(), limits.maxDeltaT));
}

label subCyclesOf(const GrainTimeSettings& settings, scalar deltaT, scalar impactRate)
{
    if (!(settings.maxGrainImpacts > 0)) return settings.subCycles;
    const scalar wanted = std::ceil(deltaT*impactRate/settings.maxGrainImpacts);
    return max(settings.subCycles, label(min(scalar(GrainTimeSettings::mostForImpacts), wanted)));
}

scalar expectedImpactRate(scalar before, scalar impacts, scalar deltaT)
{
    return max(impacts/deltaT, keptOfRate*before);
}

} // namespace nscdCoupling
} // namespace Foam
