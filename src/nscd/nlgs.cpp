// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nonlinear Gauss-Seidel (Algorithm 2 of the method): sweeps over all contacts, warm started, with help when slow.
#include "contactSolver.hpp"
#include "directHelp.hpp"
#include "slowSolve.hpp"

#include <cmath>
#include <stdexcept>

namespace nscd
{

namespace
{

/// Whether sleeping contacts are looked at after this sweep: often at first, when velocities change most.
bool isWakingDue(int sweeps) { return sweeps % 64 == 0 || (sweeps & (sweeps - 1)) == 0; }

} // namespace

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    if (!problem.halo.any(!problem.blocks.empty())) return report;

    StopRule rule{};
    int polishing = 0;
    SlowSolve slowSolve(problem);
    DirectHelp direct(problem, settings);
    while (report.sweeps < settings.maxSweeps)
    {
        const DefectSums sums = sweepActive(problem);
        if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (++report.sweeps == 1) rule = makeStopRule(problem, settings, sums);
        const bool isFineEnough = rule.isPolished(sums) || polishing == settings.polishSweeps;
        if (rule.isMet(sums) && !isFineEnough) ++polishing;
        else if (rule.isMet(sums))
        {
            direct.checkHeavyBodies(report, rule);
            reportResidual(report, rule, residual(problem));
            if (report.converged) return report;
        }
        if ((rule.isMet(sums) || isWakingDue(report.sweeps)) && wakeBlocks(problem)) slowSolve.forget();
        if (settings.accelerate) report.sweeps += slowSolve.afterSweep(report.sweeps, sums, rule);
        if (direct.isDue(report.sweeps))
        {
            direct.solve(report, rule);
            slowSolve.forget();
        }
    }
    direct.checkHeavyBodies(report, rule);
    reportResidual(report, rule, residual(problem));
    return report;
}

} // namespace nscd
