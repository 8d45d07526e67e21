// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Limits of a step's solve.
#include "nscd/solvers/problem/stopRule.hpp"

#include <cmath>

namespace nscd
{

StopRule makeStopRule(const ContactProblem& problem, const ContactSettings& settings, const DefectSums& first)
{
    const double lengthRate = problem.diameter/problem.deltaT;
    const double speed = std::max({problem.speedScale, 1e-3*rms(first), 1e-3*settings.deadBand*lengthRate});
    const SolverStrategy::Polish& polishing = settings.strategy.polish;
    const double polish = std::min(1.0, std::max(polishing.finest, polishing.perMotion*problem.motion));
    const double rmsLimit = settings.tolerance*speed, maxLimit = settings.displacementTolerance*lengthRate;
    return {rmsLimit, maxLimit, speed, polish*rmsLimit, polish < 1.0 ? polish*std::min(maxLimit, polishing.loneDefect*rmsLimit) : maxLimit, settings.forceTolerance, polish*settings.forceTolerance};
}

double forceErrorNow(const StopRule& rule, const ContactProblem& problem, const DefectSums& residual)
{
    return problem.freeVelocity ? rule.forceError(residual, netImpulse(problem)) : 0.0;
}

DefectSums reportResidual(SolveReport& report, const StopRule& rule, ContactProblem& problem)
{
    const DefectSums sums = residual(problem);
    report.residualRms = rms(sums);
    report.residualMax = std::sqrt(sums.maxSquare);
    report.speedScale = rule.speedScale;
    report.contacts = static_cast<std::size_t>(sums.active);
    report.forceError = forceErrorNow(rule, problem, sums);
    report.converged = rule.isMet(sums) && report.forceError <= rule.forceLimit;
    return sums;
}

} // namespace nscd
