// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Nonlinear Gauss-Seidel (Algorithm 2 of the method): sweeps over all contacts, warm started, with help when slow.
#include "slowSolve.hpp"
#include "sweepLoop.hpp"

namespace nscd
{

namespace
{

struct NoHelp
{
    int afterSweep(int, const DefectSums&, const StopRule&) { return 0; }
    void forget() {}
};

} // namespace

SolveReport solveNlgs(ContactProblem& problem, const ContactSettings& settings)
{
    if (!problem.halo.any(!problem.blocks.empty())) return SolveReport();
    SlowSolve slowSolve(problem);
    NoHelp none;
    return settings.accelerate ? sweepUntilMet(problem, settings, sweepActive, slowSolve) : sweepUntilMet(problem, settings, sweepActive, none);
}

} // namespace nscd
