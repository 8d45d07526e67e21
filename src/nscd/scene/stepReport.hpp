// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a contact solve and a step report of themselves.
// Tested by tests/unit/nscd/scene/stepWarningsTest.cpp
#pragma once

#include <algorithm>
#include <cstddef>

namespace nscd
{

/// Of a grain in a step, in the mean: with more, impacts take a tenth of their energy too little and more (src/nscd/method.md).
constexpr double manyImpacts = 0.25;

struct SolveReport
{
    int sweeps = 0;
    int newtonSteps = 0;        ///< of the direct method and of clusters, where they were used
    bool converged = true;      ///< velocities and forces: see StopRule
    bool atCap = false;         ///< not converged, and no sweep left
    /// Coulomb's law had no solution, or none that sweeps found: friction was held within bounds that it comes near, velocities are those of a convex
    /// problem, which was solved. See heldFriction.hpp.
    bool isHeld = false;
    bool isSqueezed = false;    ///< walls or driven grains move so that the others have no room, as it seems: at the cap, and some still close
    double frictionOff = 0.0;   ///< sum of what held friction is off Coulomb's, over the sum of mu r_n [-]
    double createdEnergy = 0.0; ///< work of the impulses of a step that has not converged, beyond round-off, where it is positive [J]
    double residualRms = 0.0;   ///< natural map over active contacts, rms [m/s]
    double residualMax = 0.0;   ///< natural map, largest [m/s]
    double speedScale = 0.0;    ///< what the tolerance multiplies [m/s]
    double forceError = 0.0;    ///< share of the forces on grains that has not come down to what carries them [-]: see StopRule
    std::size_t contacts = 0;   ///< contacts that carry an impulse
    /// Largest ratio of masses across a loaded contact, where it is so large that forces can be wrong though velocities have
    /// converged, and the direct method could not be used; 0: nothing to fear. See warning() in stepWarnings.hpp.
    double hiddenMassRatio = 0.0;
    int stepsAtCap = 0;         ///< steps in a row that ended at the cap of sweeps, this one included; see warning()
    /// Work of the impulses of a step with restitution, from the free velocities to the last ones, and what the residual may have of it
    /// [J]: work beyond that is energy that Newton's law would create. The rebound is then scaled until nothing is. See shockWork.hpp.
    double shockWork = 0.0;
    double shockResidualWork = 0.0;
    double reboundShare = 1.0;  ///< what was left of the rebound
    double impacts = 0.0;       ///< of a grain that moves, with restitution, in the mean [-]: contacts that rebound
    int stepsOfManyImpacts = 0; ///< steps in a row that had more than manyImpacts, this one included; see warning()
    bool isReboundOfMotion = false;   ///< the shock was not solved, grains rebound by the impulses of the motion: see reboundOfMotion()

    bool hasGainedEnergy() const { return shockWork > shockResidualWork; }
};

struct StepReport
{
    SolveReport solve;
    std::size_t candidates = 0;       ///< pairs listed
    bool listRebuilt = false;
    double overlapMax = 0.0;          ///< over contacts that carry an impulse, in d
    double overlapMean = 0.0;
    double overlapUncorrected = 0.0;  ///< the deepest before the overlap correction, loaded or not, in d
    int correctionSweeps = 0;         ///< of the overlap correction
    double maxDisplacement = 0.0;     ///< of any grain in this step, in d
    std::size_t stoppedOnWay = 0;     ///< fast grains that stopped where their way led through a wall, or into one that did
    std::size_t asleep = 0;           ///< grains that sleep; figures of `solve` and overlapMean leave contacts between them out
};

/// The report of two solves of the same step, one after the other, as one: what the later one reached, and the work of both.
inline SolveReport together(const SolveReport& earlier, SolveReport later)
{
    later.sweeps += earlier.sweeps;
    later.newtonSteps += earlier.newtonSteps;
    later.hiddenMassRatio = std::max(earlier.hiddenMassRatio, later.hiddenMassRatio);
    return later;
}

/// The report of solves that all count, as the two of a step with restitution or those of several steps: the work of both, the worst of
/// what they reached.
inline SolveReport worstOf(const SolveReport& before, const SolveReport& next)
{
    SolveReport worst = together(before, next);
    worst.converged = before.converged && next.converged;
    worst.atCap = before.atCap || next.atCap;
    worst.isHeld = before.isHeld || next.isHeld;
    worst.isSqueezed = before.isSqueezed || next.isSqueezed;
    worst.isReboundOfMotion = before.isReboundOfMotion || next.isReboundOfMotion;
    worst.frictionOff = std::max(before.frictionOff, next.frictionOff);
    worst.createdEnergy = std::max(before.createdEnergy, next.createdEnergy);
    worst.residualRms = std::max(before.residualRms, next.residualRms);
    worst.residualMax = std::max(before.residualMax, next.residualMax);
    worst.forceError = std::max(before.forceError, next.forceError);
    worst.stepsAtCap = std::max(before.stepsAtCap, next.stepsAtCap);
    worst.impacts = std::max(before.impacts, next.impacts);
    worst.stepsOfManyImpacts = std::max(before.stepsOfManyImpacts, next.stepsOfManyImpacts);
    if (before.reboundShare < next.reboundShare)
    {
        worst.shockWork = before.shockWork;
        worst.shockResidualWork = before.shockResidualWork;
        worst.reboundShare = before.reboundShare;
    }
    return worst;
}

/// The report of several steps in a row as one: sums of sweeps, the worst of the rest; `count` steps with `next`.
inline StepReport worstOf(const StepReport& before, const StepReport& next, int count)
{
    if (count == 1) return next;
    StepReport worst = next;
    worst.solve = worstOf(before.solve, next.solve);
    worst.listRebuilt = before.listRebuilt || next.listRebuilt;
    worst.overlapMax = std::max(before.overlapMax, next.overlapMax);
    worst.overlapMean = std::max(before.overlapMean, next.overlapMean);
    worst.overlapUncorrected = std::max(before.overlapUncorrected, next.overlapUncorrected);
    worst.correctionSweeps += before.correctionSweeps;
    worst.maxDisplacement = std::max(before.maxDisplacement, next.maxDisplacement);
    worst.stoppedOnWay += before.stoppedOnWay;
    return worst;
}

} // namespace nscd
