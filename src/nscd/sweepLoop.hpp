// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The loop of all solvers that pass over the contacts again and again until the stop rule is met.
#pragma once

#include "contactSolver.hpp"

#include <cmath>
#include <stdexcept>

namespace nscd
{

/// Whether sleeping contacts are looked at after this sweep: often at first, when velocities change most.
inline bool isWakingDue(int sweeps) { return sweeps % 64 == 0 || (sweeps & (sweeps - 1)) == 0; }

/// Repeats `pass`, which returns the defects it met, until the rule is met and the solution polished, or maxSweeps.
/// `help` acts between passes: int afterSweep(sweeps, sums, rule) returns the work it did, in sweeps; forget() is called when
/// blocks woke up; polish(sums, rule) tells whether a solution that meets the rule is polished, or now is; complete(report, rule) with each solution that may be the last one.
/// Errors: std::runtime_error for a velocity that is not finite
template<class Help>
SolveReport sweepUntilMet(ContactProblem& problem, const ContactSettings& settings, DefectSums (*pass)(ContactProblem&), Help& help)
{
    SolveReport report;
    StopRule rule{};
    int polishing = 0;
    while (report.sweeps < settings.maxSweeps)
    {
        const DefectSums sums = pass(problem);
        if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (++report.sweeps == 1) rule = makeStopRule(problem, settings, sums);
        const bool isMet = rule.isMet(sums);
        if (isMet && polishing < settings.polishSweeps && !help.polish(sums, rule)) ++polishing;
        else if (isMet)
        {
            help.complete(report, rule);
            reportResidual(report, rule, residual(problem));
            if (report.converged) return report;
        }
        if ((isMet || isWakingDue(report.sweeps)) && wakeBlocks(problem)) help.forget();
        report.sweeps += help.afterSweep(report.sweeps, sums, rule);
    }
    help.complete(report, rule);
    reportResidual(report, rule, residual(problem));
    return report;
}

} // namespace nscd
