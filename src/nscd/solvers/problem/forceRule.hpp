// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a solve goes on for once the velocities are met: forces.
// Tested by tests/unit/nscd/solvers/problem/forceRuleTest.cpp
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

namespace nscd
{

/// Sweeps after which a flow, or a bed that walls drive, is done with its forces, of a solve that met the velocities asked for after `met` sweeps: see SolverStrategy::Forces.
inline int lastSweepForForces(int met, const SolverStrategy::Forces& strategy)
{
    return met + std::max(strategy.leastSweeps, static_cast<int>(strategy.share*met));
}

/// The rule that a solve follows: the one asked for, and a finer one where forces ask for it once the velocities are met.
class ForceRule
{
public:
    ForceRule(const StopRule& asked, const ContactSettings& settings)
    :
        asked_(asked),
        now_(asked),
        settings_(settings)
    {}

    const StopRule& asked() const { return asked_; }
    const StopRule& now() const { return now_; }

    /// Whether the forces of a solution that meets the velocities asked for are right: within what a polished one may be off by for some sweeps, then within their limit.
    bool judge(const SolveReport& report, const DefectSums& left)
    {
        if (met_ < 0) met_ = report.sweeps;
        now_.wereForcesOff = now_.wereForcesOff || report.forceError > asked_.forceLimit;
        if (report.forceError <= sought(report.sweeps)) return true;
        now_.tighten(left, report.forceError/sought(report.sweeps));
        return false;
    }

    /// Where forces were off, whether what is sought of them is met by now, though the finer velocities are not: looked at now and then.
    bool areForcesMet(int sweeps, ContactProblem& problem) const
    {
        if (!now_.wereForcesOff || problem.areForcesBounded() || sweeps % settings_.strategy.forces.sweepsBetween != 0) return false;
        const DefectSums left = residual(problem);
        return asked_.isMet(left) && forceErrorNow(asked_, problem, left) <= sought(sweeps);
    }

    /// In a flow, or under walls that drive, whether forces have had the sweeps that they are worth, and velocities are met.
    bool areForcesGivenUp(int sweeps, ContactProblem& problem) const
    {
        return met_ > 0 && problem.areForcesBounded() && sweeps >= lastSweepForForces(met_, settings_.strategy.forces) && asked_.isMet(residual(problem));
    }

private:
    double sought(int sweeps) const { return sweeps < 2*met_ + settings_.polishSweeps ? asked_.polishedForce : asked_.forceLimit; }

    StopRule asked_, now_;
    const ContactSettings& settings_;
    int met_ = -1;   ///< sweeps after which the velocities asked for were met
};

} // namespace nscd
