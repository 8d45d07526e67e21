// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sweeps over the few contacts that keep a solution from being polished.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

namespace nscd
{

/// Sweeps over the contacts whose defect exceeds half the largest one of a polished solution and over those a few contacts away, until
/// none does, or that has cost as much as five sweeps over all. In a bed at rest these are some tens among tens of thousands of
/// contacts, around grains that roll, and need ten times the sweeps that all others do. Call it on all ranks.
/// Returns whether none does any more.
bool polishLoneDefects(ContactProblem& problem, const StopRule& rule, const SolverStrategy::LoneDefects& strategy);

} // namespace nscd
