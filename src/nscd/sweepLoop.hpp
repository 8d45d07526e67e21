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

/// Whether what a sweep leaves may meet the rule already though what it met does not: half of it, or less where sweeps have momentum.
/// A look costs most of a sweep.
inline bool isLookDue(const ContactProblem& problem, int sweeps, const DefectSums& sums, const StopRule& rule)
{
    constexpr int sweepsPerLook = 4;
    constexpr double nearly = 2.0;
    return problem.isFlowing() && sweeps % sweepsPerLook == 0 && rms(sums) < nearly*rule.rmsLimit;
}

/// Repeats `pass`, which returns the defects it met, until the rule is met and the solution polished, or maxSweeps.
/// `help` acts between passes: int afterSweep(sweeps, sums, rule) returns the work it did, in sweeps; forget() is called when
/// blocks woke up; complete(report, rule) with each solution that may be the last one.
/// Errors: std::runtime_error for a velocity that is not finite
template<class Help>
SolveReport sweepUntilMet(ContactProblem& problem, const ContactSettings& settings, DefectSums (*pass)(ContactProblem&), Help& help)
{
    SolveReport report;
    StopRule rule{};
    int polishing = 0;
    const auto isSolved = [&]()
    {
        help.complete(report, rule);
        reportResidual(report, rule, residual(problem));
        return report.converged;
    };
    while (report.sweeps < settings.maxSweeps)
    {
        const DefectSums sums = pass(problem);
        if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (++report.sweeps == 1) rule = makeStopRule(problem, settings, sums);
        const bool isFineEnough = rule.isPolished(sums) || polishing == settings.polishSweeps;
        const DefectSums left = isLookDue(problem, report.sweeps, sums, rule) ? residual(problem) : sums;
        if (rule.isMet(sums) && !isFineEnough) ++polishing;
        else if (rule.isMet(left) && isSolved()) return report;
        if ((rule.isMet(sums) || isWakingDue(report.sweeps)) && wakeBlocks(problem)) help.forget();
        const int work = help.afterSweep(report.sweeps, left, rule);
        report.sweeps += work;
        if (work > 0 && problem.isFlowing() && rule.isMet(residual(problem)) && isSolved()) return report;
    }
    help.complete(report, rule);
    reportResidual(report, rule, residual(problem));
    return report;
}

} // namespace nscd
