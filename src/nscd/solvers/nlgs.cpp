// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nonlinear Gauss-Seidel (Henry 2025, Algorithm 2): sweeps over all contacts, warm started, with help when slow.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/direct/directHelp.hpp"
#include "nscd/solvers/help/loneDefects.hpp"
#include "nscd/solvers/help/packedContacts.hpp"
#include "nscd/solvers/help/slowSolve.hpp"
#include "nscd/solvers/sweepLoop.hpp"

namespace nscd
{

namespace
{

/// Mixing and queue for slow solves, and the direct method where it is the cheaper way.
class NlgsHelp
{
public:
    NlgsHelp(ContactProblem& problem, const ContactSettings& settings)
    :
        problem_(problem),
        isAccelerated_(settings.accelerate),
        maxSweeps_(settings.maxSweeps),
        strategy_(settings.strategy),
        slowSolve_(problem, strategy_),
        direct_(problem, settings)
    {}

    DefectSums pass() { return sweepActive(problem_, slowSolve_.forNextSweep()); }

    int afterSweep(int sweeps, const DefectSums& sums, const StopRule& rule)
    {
        const bool isDirect = direct_.isDue(sweeps);
        // Momentum may lead out of the friction cones: a sweep has to follow.
        const int work = isAccelerated_ && !isDirect && sweeps < maxSweeps_ ? slowSolve_.afterSweep(sweeps, sums, rule) : 0;
        if (isDirect)
        {
            direct_.solve(rule);
            slowSolve_.forget();
        }
        return work;
    }

    bool polish(const DefectSums& sums, const StopRule& rule)
    {
        if (rule.isPolished(sums)) return true;
        if (areDefectsLone_ && rule.hasLoneDefects(sums)) return areDefectsLone_ = polishLoneDefects(problem_, rule, strategy_.loneDefects);
        return false;
    }

    void forget() { slowSolve_.wake(); }

    void complete(SolveReport& report, const StopRule& rule)
    {
        if (direct_.complete(report, rule)) slowSolve_.forget();
        report.newtonSteps += slowSolve_.newtonSteps();
    }

private:
    ContactProblem& problem_;
    bool isAccelerated_;
    int maxSweeps_;
    const SolverStrategy& strategy_;
    bool areDefectsLone_ = strategy_.loneDefects.isOn;   ///< as long as working on them alone has done
    SlowSolve slowSolve_;
    DirectHelp direct_;
};

SolveReport sweepWithHelp(ContactProblem& problem, const ContactSettings& settings)
{
    NlgsHelp help(problem, settings);
    return sweepUntilMet(problem, settings, help);
}

} // namespace

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings)
{
    if (!problem.halo.any(!problem.blocks.empty())) return SolveReport();
    if (!problem.packing) return sweepWithHelp(problem, settings);
    SolveReport report;
    if (problem.packing->isWorthwhile(problem, settings.strategy.packing))
    {
        ContactProblem packed = problem.packing->pack(problem, settings.strategy.packing.nearlyClosing);
        report = sweepWithHelp(packed, settings);
        problem.packing->giveBack(problem);
    }
    else report = sweepWithHelp(problem, settings);
    problem.packing->note(problem.isShock, report.sweeps);
    return report;
}

} // namespace nscd
