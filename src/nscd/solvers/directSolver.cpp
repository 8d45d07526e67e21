// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Newton's method as a solver behind the common signature; sweeps do what it leaves.
// Tested by tests/unit/nscd/solvers/contactSolverTest.cpp, tests/unit/nscd/solvers/direct/directSolveTest.cpp
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/solvers/direct/directSolve.hpp"

namespace nscd
{

SolveReport solveDirect(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    if (problem.blocks.empty()) return report;
    const StopRule rule = makeStopRule(problem, settings, residual(problem));
    report.newtonSteps = DirectSolve(problem).run(rule, directFineness);
    wakeBlocks(problem);
    reportResidual(report, rule, problem);
    if (report.converged) return report;
    const int steps = report.newtonSteps;
    report = solveNlgs(problem, settings);
    report.newtonSteps += steps;
    return report;
}

} // namespace nscd
