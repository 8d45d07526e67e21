// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts that share no grain with any other: solved exactly, once, beside the sweeps.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

namespace nscd
{

/// Solves a problem with a solver, but first, exactly and by one visit each, the contacts of the first `isolatedBlocks` blocks, each of
/// which joins two grains, or a grain and a wall, that have no other contact: W is diagonal, and nothing couples them to the rest. Without a rest that
/// can matter there is no solve: what is not closed, loaded or closing in the free motion stays so.
/// Ensures: problem.awake is as the solver leaves it, and the awake isolated blocks before
/// Errors: std::runtime_error for a velocity that is not finite
SolveReport solveBesideIsolated(ContactProblem& problem, std::size_t isolatedBlocks, const ContactSettings& settings, SolveReport (*solve)(ContactProblem&, const ContactSettings&));

} // namespace nscd
