// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The queue of Henry 2025 as a solver behind the common signature, judged by the common residual.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/help/contactQueue.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

SolveReport solveQueue(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    // A queue reaches any block, and what is loaded has to be among those whose impulses are summed up after the solve.
    problem.awake.resize(problem.all().count);
    std::iota(problem.awake.begin(), problem.awake.end(), 0u);
    ContactQueue queue(problem, problem.all());
    const std::size_t used = queue.slots().size();
    if (used == 0) return report;

    const StopRule rule = makeStopRule(problem, settings, residual(problem));
    const std::size_t maxVisits = used*static_cast<std::size_t>(settings.maxSweeps);
    std::size_t visits = 0;
    // The local threshold bounds each contact, the stop rule all of them; tighten until the rule is met.
    const double finest = std::min(rule.polishedRms, rule.polishedMax);
    double threshold = std::min(rule.rmsLimit, rule.maxLimit);
    do
    {
        visits += queue.work(queue.slots(), threshold, maxVisits - visits);
        reportResidual(report, rule, problem);
        threshold *= 0.5;
    }
    while (!report.converged && visits < maxVisits);
    if (report.converged && finest < threshold)
    {
        visits += queue.work(queue.slots(), finest, used*static_cast<std::size_t>(settings.polishSweeps));
        reportResidual(report, rule, problem);
    }
    report.sweeps = static_cast<int>((visits + used - 1)/used);
    report.atCap = !report.converged;
    return report;
}

} // namespace nscd
