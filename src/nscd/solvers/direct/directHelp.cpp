// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Prices and masses.
#include "nscd/solvers/direct/directHelp.hpp"

#include "nscd/solvers/direct/directSolve.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Largest ratio of masses of two bodies that a loaded contact joins.
double loadedMassRatio(const ContactProblem& problem)
{
    double largest = 1.0;
    for (const ContactBlock& block : problem.blocks)
    {
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            const double a = problem.bodies[block.a[lane]].invMass, b = problem.bodies[block.b[lane]].invMass;
            const bool isLoaded = block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0;
            if (isLoaded && a > 0.0 && b > 0.0) largest = std::max({largest, a/b, b/a});
        }
    }
    return problem.halo.max(largest);
}

} // namespace

double DirectHelp::priceLimit() const
{
    return (problem_.motion < settings_.strategy.direct.restMotion ? settings_.strategy.direct.mostPerCap : 1.0)*settings_.maxSweeps;
}

bool DirectHelp::isDue(int sweeps)
{
    if (problem_.halo.isParallel() || problem_.general || isDone_ || !settings_.strategy.direct.isOn) return false;
    if (!hasPrice_ && sweeps >= std::min(settings_.strategy.direct.firstLook, settings_.maxSweeps))
    {
        hasPrice_ = true;
        const double price = DirectSolve(problem_).price(priceLimit());
        if (price <= priceLimit()) due_ = static_cast<int>(std::min<double>(settings_.maxSweeps, price));
    }
    return sweeps >= due_;
}

void DirectHelp::solve(const StopRule& rule)
{
    isDone_ = true;
    newtonSteps_ += DirectSolve(problem_).run(rule, directFineness);
    wakeBlocks(problem_);
}

void DirectHelp::checkHeavyBodies(SolveReport& report, const StopRule& rule)
{
    const double harmless = settings_.strategy.direct.harmlessMassRatio;
    if (!(problem_.massRatio > harmless) || isDone_) return;
    const double ratio = loadedMassRatio(problem_);
    if (!(ratio > harmless)) return;
    if (!problem_.halo.isParallel() && !problem_.general && DirectSolve(problem_).price(priceLimit()) <= priceLimit()) solve(rule);
    else report.hiddenMassRatio = ratio;
}

bool DirectHelp::complete(SolveReport& report, const StopRule& rule)
{
    const bool wasDone = isDone_;
    checkHeavyBodies(report, rule);
    report.newtonSteps = newtonSteps_;
    return isDone_ && !wasDone;
}

} // namespace nscd
