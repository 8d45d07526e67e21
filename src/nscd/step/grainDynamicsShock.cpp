// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The second solve of a step with restitution, and its energy account.
// Tested by tests/unit/nscd/step/shockWorkTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/solvers/heldFriction.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"

#include <cmath>

namespace nscd
{

void GrainDynamics::Implementation::rebound(const ExternalForces& external, SolveReport& report)
{
    const auto timer = times.time(GrainPart::rebound);
    Shock inelastic;
    inelastic.impulses = shockImpulses.release();
    inelastic.bodies = list.bodies;
    inelastic.general = list.general.bodies;
    setFreeVelocities(list, grains, external, deltaT, sleep);
    if (!list.general.empty()) mirrorFreeGeneral(list, list.bodies);
    const std::vector<Body> freeBodies = std::move(list.bodies);
    list.bodies = inelastic.bodies;
    // Below twice what the forces add in a step a rebound is noise of a resting contact.
    if (!setRestitutionBias(list, freeBodies, 2.0*external.speedScale, deadBand())) return;

    ContactProblem problem = makeProblem(external.speedScale);
    problem.times = nullptr;   // all of it is the rebound
    gatherImpulses(list.blocks, {nullptr, list.blocks.size()}, inelastic.impulses);
    inelastic.ofLaws.clear();
    for (std::size_t slot = 0; slot < list.slots() && list.laws.haveImpulses(); ++slot) inelastic.ofLaws.push_back(list.laws.impulses(slot));
    // Nothing moves with these velocities within the step, so no displacement limits them: the rms tolerance alone does.
    ContactSettings shockSettings = settings;
    shockSettings.displacementTolerance = 1.0;
    SolveReport shock = solveWhereAwake(problem, shockSettings, solve);
    if (shock.atCap && mayHoldFriction())
    {
        Shock start = inelastic;
        list.bodies = std::move(start.bodies);
        list.general.bodies = std::move(start.general);
        swapImpulses(list, start.impulses, start.ofLaws);
        shock = together(shock, solveHeld(problem, shockSettings));
    }
    if (!list.general.empty()) takeGeneralVelocities(list, grains.shape);
    report = worstOf(shock, report);
    if (sleep.any() && !sleep.disturbedBy(grains, list, forcesOnBodies(), deltaT).empty())
    {
        // A shock goes through everything that touches: once more, with nobody asleep.
        swapImpulses(list, inelastic.impulses, inelastic.ofLaws);
        awakePart.giveBack(list, forcesOnBodies());
        giveUpSleep();
        prepareSolve(external);
        rebound(external, report);
        return;
    }
    limitWork(freeBodies, inelastic, shock, report);
    giveToGrains(forcesOnBodies(), list.grainOf, forces);
    if (sleep.any()) shockImpulses.keep(awakePart.impulses(list));
    // The next step starts from the impulses of the motion, not from those of the shock.
    swapImpulses(list, inelastic.impulses, inelastic.ofLaws);
    if (!sleep.any()) shockImpulses.keep(std::move(inelastic));
}

void GrainDynamics::Implementation::limitWork
(
    const std::vector<Body>& freeBodies, const Shock& inelastic, const SolveReport& shock, SolveReport& report
)
{
    const double residual = shock.residualRms*std::sqrt(static_cast<double>(shock.contacts));
    const ShockWork account = shockWork(list, freeBodies, residual);
    report.shockWork = account.work;
    report.shockResidualWork = account.residualWork;
    // What an unconverged solve may have of energy is no excuse.
    const bool isFromNowhere = !shock.converged && account.work > 0.0;
    if (report.hasGainedEnergy() || isFromNowhere) report.reboundShare = limitRebound(list, freeBodies, inelastic);
}

} // namespace nscd
