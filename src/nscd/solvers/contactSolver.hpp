// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The solvers of the contact problem, which share one signature and one residual.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

#include <string>
#include <vector>

namespace nscd
{

using ContactSolver = SolveReport (*)(ContactProblem&, const ContactSettings&);

struct ContactSolverRow
{
    const char* name;
    ContactSolver solve;
    const char* description;
    bool worksOnRanks;
};

/// All solvers by name.
const std::vector<ContactSolverRow>& contactSolvers();

/// Errors: std::invalid_argument listing the names there are
const ContactSolverRow& findContactSolver(const std::string& name);

/// Solves a problem in which anything can matter; in others what is not closed, loaded or closing in the free motion stays so, and nothing is solved.
SolveReport solveWhereAwake(ContactProblem& problem, const ContactSettings& settings, ContactSolver solve);

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveQueue(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveDirect(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveNncg(ContactProblem& problem, const ContactSettings& settings);
SolveReport solveProjectedGradient(ContactProblem& problem, const ContactSettings& settings);

} // namespace nscd
