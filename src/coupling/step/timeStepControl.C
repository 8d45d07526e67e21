// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Step length from Courant number and grain displacement.
#include "coupling/step/timeStepControl.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

constexpr scalar largestGrowth = 1.2;

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

} // namespace nscdCoupling
} // namespace Foam
