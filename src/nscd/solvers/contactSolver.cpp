// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The table of solvers.
#include "nscd/solvers/contactSolver.hpp"

#include "nscd/base/invalidValue.hpp"

namespace nscd
{

SolveReport solveWhereAwake(ContactProblem& problem, const ContactSettings& settings, ContactSolver solve)
{
    if (problem.halo.any(!problem.awake.empty())) return solve(problem, settings);
    SolveReport report;
    report.speedScale = makeStopRule(problem, settings, {0.0, 0.0, 0.0}).speedScale;
    return report;
}

const std::vector<ContactSolverRow>& contactSolvers()
{
    static const std::vector<ContactSolverRow> rows =
    {
        {"NLGS", solveNlgs, "nonlinear Gauss-Seidel sweeps over all contacts, accelerated when slow", true},
        {"NNCG", solveNncg, "nonlinear conjugate gradients around Gauss-Seidel sweeps", true},
        {"APG", solveProjectedGradient, "accelerated projected gradient with refreshed Tresca bounds, whatever the order of contacts", false},
        {"queue", solveQueue, "a queue of contacts: only those whose neighborhood changed are solved again", false},
        {"direct", solveDirect, "Newton's method with sparse factors, for chains, walls and bodies of very different mass", false}
    };
    return rows;
}

const ContactSolverRow& findContactSolver(const std::string& name)
{
    std::string names;
    for (const ContactSolverRow& row : contactSolvers())
    {
        if (name == row.name) return row;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw invalidValue("contact solver", name, names);
}

} // namespace nscd
