// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The loop of all solvers that pass over the contacts again and again until the stop rule is met.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp
#pragma once

#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/problem/forceRule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace nscd
{

/// Whether sleeping blocks are looked at after this sweep: see SolverStrategy::Waking.
inline bool isWakingDue(int sweeps, const ContactProblem& problem, const SolverStrategy::Waking& strategy)
{
    const bool isPowerOfTwo = (sweeps & (sweeps - 1)) == 0, isPowerOfFour = isPowerOfTwo && sweeps % 3 == 1;
    if (sweeps % strategy.mostBetween == 0) return true;
    if (problem.leftOut) return isPowerOfTwo && sweeps >= strategy.firstPacked;
    return problem.isFlowing() ? isPowerOfFour : isPowerOfTwo;
}

/// After which sweeps the residual is evaluated: a sweep tells the defects it met, not those it left, which may meet the rule already.
/// An evaluation costs most of a sweep.
class Looks
{
public:
    explicit Looks(const SolverStrategy::Looks& strategy) : strategy_(strategy), share_(strategy.share) {}

    bool areDue(int sweeps, const DefectSums& met, const StopRule& rule) const
    {
        return strategy_.isOn && sweeps % strategy_.sweepsBetween == 0 && !rule.isMet(met) && share_*rms(met) < strategy_.nearly*rule.rmsLimit;
    }

    void note(const DefectSums& met, const DefectSums& left)
    {
        if (met.sumSquares > 0.0) share_ = rms(left)/rms(met);
    }

private:
    const SolverStrategy::Looks& strategy_;
    double share_;  ///< of the rms that a sweep meets, what it leaves
};

/// Repeats passes until the rule is met and the solution polished, or maxSweeps, or, in a flow or under walls that drive, once velocities are met, as many as its forces are worth.
/// `help` makes them and acts between them: DefectSums pass() returns the defects it met; int afterSweep(sweeps, sums, rule) returns the work it did, in sweeps; forget() is called when
/// blocks woke up; polish(sums, rule) tells whether a solution that meets the rule is polished, or now is; complete(report, rule) with
/// each solution that may be the last one.
/// Errors: std::runtime_error for a velocity that is not finite
template<class Help>
SolveReport sweepUntilMet(ContactProblem& problem, const ContactSettings& settings, Help& help)
{
    SolveReport report;
    std::optional<ForceRule> rule;
    int polishing = 0;   // sweeps
    Looks looks(settings.strategy.looks);
    const auto isSolved = [&]()
    {
        help.complete(report, rule->now());
        const DefectSums left = reportResidual(report, rule->asked(), problem);
        return rule->asked().isMet(left) && rule->judge(report, left);
    };
    while (report.sweeps < settings.maxSweeps)
    {
        const DefectSums sums = help.pass();
        if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (++report.sweeps == 1) rule.emplace(makeStopRule(problem, settings, sums), settings);
        const bool isMet = rule->now().isMet(sums);
        DefectSums left = sums;
        if (problem.isFlowing() && looks.areDue(report.sweeps, sums, rule->now())) looks.note(sums, left = residualOfActive(problem));
        const bool isPolishing = isMet && polishing < settings.polishSweeps && !help.polish(sums, rule->now());
        if (isPolishing) ++polishing;
        else if ((rule->now().isMet(left) || rule->areForcesMet(report.sweeps, problem)) && isSolved()) return report;
        if (rule->areForcesGivenUp(report.sweeps, problem)) break;
        const bool hasFailed = rule->now().isMet(left) && !isPolishing;
        if ((hasFailed || isWakingDue(report.sweeps, problem, settings.strategy.waking)) && wakeBlocks(problem)) help.forget();
        const int work = help.afterSweep(report.sweeps, left, rule->now());
        report.sweeps += work;
        if (work > 0 && problem.isFlowing() && rule->now().isMet(residual(problem)) && isSolved()) return report;
    }
    help.complete(report, rule->now());
    reportResidual(report, rule->asked(), problem);
    report.atCap = !report.converged && report.sweeps >= settings.maxSweeps;
    return report;
}

} // namespace nscd
