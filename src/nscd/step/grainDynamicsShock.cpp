// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The second solve of a step with restitution, and its energy account.
// Tested by tests/unit/nscd/step/shockWorkTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/solvers/help/andersonAcceleration.hpp"

#include <cmath>

namespace nscd
{

bool GrainDynamics::Implementation::rebound(const ExternalForces& external, SolveReport& report)
{
    const auto timer = times.time(GrainPart::rebound);
    Shock inelastic = shockImpulses.release();
    inelastic.blocks = list.awake;
    inelastic.bodies = list.bodies;
    inelastic.general = list.general.bodies;
    setFreeVelocities(list, grains, external, deltaT, sleep);
    if (!list.general.empty()) mirrorFreeGeneral(list, list.bodies);
    list.laws.beginShock(list);
    const std::vector<Body> freeBodies = std::move(list.bodies);
    list.bodies = inelastic.bodies;
    // Below twice what the forces add in a step a rebound is noise of a resting contact.
    // What the motion leaves a film between does not hit, however thin the film.
    const double threshold = 2.0*external.speedScale, band = materials.anyRoughness() ? 0.0 : deadBand();
    if (!setRestitutionBias(list, freeBodies, threshold, band)) return false;
    gatherImpulses(list.blocks, {inelastic.blocks.data(), inelastic.blocks.size()}, inelastic.impulses);
    inelastic.ofLaws.clear();
    for (std::size_t slot = 0; slot < list.slots() && list.laws.haveImpulses(); ++slot) inelastic.ofLaws.push_back(list.laws.impulses(slot));
    const TurnedMotion there = turnMotion(freeBodies, inelastic, band);
    if (there.isAny()) setRestitutionBias(list, freeBodies, threshold, band);

    ContactProblem problem = makeProblem(external.speedScale);
    problem.times = nullptr;   // all of it is the rebound
    problem.isShock = true;
    // Nothing moves with these velocities within the step, so no displacement limits them: the rms tolerance alone does.
    ContactSettings shockSettings = settings;
    shockSettings.displacementTolerance = 1.0;
    leaveOutIdle(list);
    const SolveReport shock = solveWhereAwake(problem, shockSettings, solve);
    list.awake = inelastic.blocks;
    if (!list.general.empty()) takeGeneralVelocities(list, grains.shape);
    if (sleep.any() && list.halo.any(!sleep.disturbedBy(grains, list, forcesOnBodies(), deltaT).empty()))
    {
        report = together(shock, report);
        // A shock goes through everything that touches: once more, with nobody asleep.
        swapImpulses(list, inelastic);
        setNormals(list, there.before);
        awakePart.giveBack(list, forcesOnBodies());
        giveUpSleep();
        prepareSolve(external);
        if (!list.general.empty()) takeGeneralVelocities(list, grains.shape);
        return rebound(external, report);
    }
    const SolveReport judged = judgedRebound(freeBodies, inelastic, there, shock);
    report = worstOf(judged, report);
    report.shockWork = judged.shockWork;
    report.shockResidualWork = judged.shockResidualWork;
    report.reboundShare = judged.reboundShare;
    report.impacts = impactsOfAGrain(list);
    giveToGrains(forcesOnBodies(), list.grainOf, forces);
    if (sleep.any()) shockImpulses.keep(awakePart.impulses(list));
    // The next step starts from the impulses of the motion, not from those of the shock.
    swapImpulses(list, inelastic);
    if (!sleep.any()) shockImpulses.keep(std::move(inelastic));
    return true;
}

/// Turns the list to the normals where the motion has brought the grains, for the shock to act at, which is to leave pairs along their present tangents. What
/// stopped on its way is not where velocities say; other laws give their impulses along the normals of the step's start; and where turned impulses would have
/// energy come from nowhere, all normals stay.
GrainDynamics::Implementation::TurnedMotion GrainDynamics::Implementation::turnMotion(const std::vector<Body>& freeBodies, const Shock& inelastic, double band)
{
    if (areSomeStopped || !list.laws.empty()) return {};
    TurnedMotion there;
    there.before = turnClosedNormals(list, box, band);
    there.motion.bodies = list.bodies;
    there.motion.blocks = inelastic.blocks;
    there.motion.general = inelastic.general;
    gatherImpulses(list.blocks, {inelastic.blocks.data(), inelastic.blocks.size()}, there.motion.impulses);
    if (!(shockWork(list, freeBodies, 0.0).work > 0.0)) return there;
    setNormals(list, there.before);
    list.bodies = inelastic.bodies;
    there.motion.impulses = inelastic.impulses;
    swapImpulses(list, there.motion);
    return {};
}

SolveReport GrainDynamics::Implementation::judgedRebound
(
    const std::vector<Body>& freeBodies, const Shock& inelastic, const TurnedMotion& there, SolveReport shock
)
{
    const double residual = shock.residualRms*std::sqrt(static_cast<double>(shock.contacts));
    ShockWork account = shockWork(list, freeBodies, residual);
    const bool isFromNowhere = !shock.converged && account.work > 0.0;   // what an unconverged solve may have of energy is no excuse
    if ((shock.atCap && (isFromNowhere || mayHaveNoSolution())) || isJammed(shock, makeProblem(shock.speedScale)))
    {
        setNormals(list, there.before);   // of these alone it is known that it takes energy
        reboundOfMotion(list, freeBodies, inelastic);
        account = shockWork(list, freeBodies, residual);
        shock.converged = shock.atCap = false;
        shock.isReboundOfMotion = true;
    }
    shock.shockWork = account.work;
    shock.shockResidualWork = account.residualWork;
    const Shock& motion = there.isAny() && !shock.isReboundOfMotion ? there.motion : inelastic;
    if (shock.hasGainedEnergy() || (!shock.converged && account.work > 0.0)) shock.reboundShare = limitRebound(list, freeBodies, motion);
    return shock;
}

} // namespace nscd
