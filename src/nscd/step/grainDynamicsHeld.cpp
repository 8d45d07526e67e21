// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Steps that have not converged: solved again with friction that is held, and their account of energy.
// Tested by tests/unit/nscd/solvers/heldFrictionTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/solvers/heldFriction.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

/// Whether what a solve left at the cap makes energy, or grains overlap, or may have no solution at all for the friction there is. Else it is a
/// solution that is not yet sharp, as of a bed from cold, and nearer to Coulomb's law than friction that is held.
bool GrainDynamics::Implementation::isHarmful(const SolveReport& report) const
{
    return report.atCap && (mayHaveNoSolution() || report.createdEnergy > 0.0 || leavesOverlap(report));
}

bool GrainDynamics::Implementation::leavesOverlap(const SolveReport& report) const
{
    return report.residualMax*deltaT > settings.strategy.held.overlap*diameter;
}

/// Whether a contact carries far more than all contacts together give the grains: where Coulomb's law has no solution impulses grow until what they
/// leave drowns in round-off, which meets any stop rule. Attraction may press as hard.
bool GrainDynamics::Implementation::isJammed(const SolveReport& report, const ContactProblem& problem) const
{
    const SolverStrategy::Held& strategy = settings.strategy.held;
    const bool mayGrow = report.sweeps >= strategy.sweepsToJam || mayHaveNoSolution();
    if (list.laws.areOfStart() || !mayGrow) return false;
    double largest2 = 0.0, mass = 0.0;
    for (std::uint32_t k : list.awake)
    {
        const ContactBlock& block = list.blocks[k];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            largest2 = std::max(largest2, block.r[0][lane]*block.r[0][lane] + block.r[1][lane]*block.r[1][lane] + block.r[2][lane]*block.r[2][lane]);
        }
    }
    for (int body = 0; body < list.owned(); ++body) mass += list.bodies[body].invMass > 0.0 ? 1.0/list.bodies[body].invMass : 0.0;
    return std::sqrt(list.halo.max(largest2)) > (report.atCap ? strategy.jamAtCap : strategy.jam)*(netImpulse(problem) + list.halo.sum(mass)*report.speedScale);
}

/// The step's problem once more, without what impulses the solve before left: those may be of any size.
SolveReport GrainDynamics::Implementation::solveAnew(ContactSolver solver, const ExternalForces& external, const ContactSettings& asked)
{
    for (ContactBlock& block : list.blocks) std::fill_n(&block.r[0][0], 3*blockLanes, 0.0);
    // Laws beside Coulomb's that work within sweeps know of no bounds that are held: such a step is solved without them.
    for (std::size_t slot = 0; slot < list.slots() && list.laws.haveImpulses(); ++slot) list.laws.setImpulses(slot, noLawImpulses());
    ContactProblem problem = prepareProblem(external);
    return solveBy(solver, problem, asked, external);
}

/// Whether walls or driven grains that move may have left the others no room: at the cap, and some still close.
bool GrainDynamics::Implementation::mayBeSqueezed(const SolveReport& report) const
{
    return report.atCap && leavesOverlap(report) && list.halo.max(fastestDriven2()) > report.speedScale*report.speedScale;
}

/// Whether a solve at the cap, beside something driven, left far more motion than there was, and than driven bodies have: its impulses are of any size, and
/// their changes, by momentum of sweeps or by the turn of a normal since they were kept, throw grains about. Attraction is not in the free motion known here.
bool GrainDynamics::Implementation::isFlung(const SolveReport& report) const
{
    if (!settings.strategy.held.isOn || !report.atCap || list.laws.areOfStart()) return false;
    const double fastest2 = list.halo.max(fastestDriven2());
    if (!(fastest2 > report.speedScale*report.speedScale)) return false;
    double sums[3] = {0.0, 0.0, 0.0};   // kinetic energy now, and of the free motion [J]; mass [kg]
    const auto add = [&](const Vec3& v, const Vec3& freeV, double invMass)
    {
        if (invMass == 0.0) return;
        sums[0] += 0.5*v.squaredNorm()/invMass;
        sums[1] += 0.5*freeV.squaredNorm()/invMass;
        sums[2] += 1.0/invMass;
    };
    for (int body = 0; body < list.owned(); ++body)
    {
        // Sweeps move clumps, and not their members.
        const bool isMember = !list.general.empty() && list.general.memberOf[body] >= 0;
        if (!isMember) add(Vec3(list.bodies[body].v), freeVelocity[body], list.bodies[body].invMass);
    }
    for (std::size_t k = 0; k < list.general.own(); ++k) add(list.general.bodies[k].v, list.general.bodies[k].freeV, list.general.bodies[k].invMass);
    list.halo.sum(sums, 3);
    return sums[0] > settings.strategy.held.energy*(sums[1] + 0.5*sums[2]*fastest2);
}

/// Of walls and driven grains that are here [m2/s2].
double GrainDynamics::Implementation::fastestDriven2() const
{
    double fastest2 = 0.0;
    for (const Body& body : list.bodies)
    {
        if (body.invMass == 0.0) fastest2 = std::max(fastest2, Vec3(body.v).squaredNorm());
    }
    return fastest2;
}

/// Kinetic energy of what moves here [J], without the spins.
double GrainDynamics::Implementation::translationalEnergy() const
{
    double sum = 0.0;
    for (int body = 0; body < list.owned(); ++body)
    {
        const Body& each = list.bodies[body];
        if (each.invMass > 0.0) sum += 0.5*Vec3(each.v).squaredNorm()/each.invMass;
    }
    return list.halo.sum(sum);
}

/// Work of the impulses [J], where it is positive beyond what the tolerance may have of it. A solution has r.(u^- + u)/2 <= 0 at every contact.
/// The tolerance may have little of large impulses, and those of a jam are of any size: no more than some times the energy there was.
double GrainDynamics::Implementation::createdEnergy(const ExternalForces& external, const SolveReport& report)
{
    // Attraction is part of the free motion, and not of the velocities before contact that are known here.
    if (list.laws.areOfStart()) return 0.0;
    std::vector<Body> solved = list.bodies;
    setFreeVelocities(list, grains, external, deltaT, sleep);
    if (!list.general.empty()) mirrorFreeGeneral(list, list.bodies);
    const double most = settings.strategy.held.energy*translationalEnergy();
    solved.swap(list.bodies);
    const double residual = settings.tolerance*report.speedScale*std::sqrt(static_cast<double>(report.contacts));
    const ShockWork account = shockWork(list, solved, residual);
    return std::max(0.0, account.work - std::min(account.residualWork, most));
}

} // namespace nscd
