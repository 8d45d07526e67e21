// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One visit for isolated contacts, the solver for the rest.
#include "nscd/solvers/help/isolatedPairs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace nscd
{

namespace
{

/// On this rank.
DefectSums defectsOf(const ContactProblem& problem, BlockRange range)
{
    const SweepFunction evaluate = problem.isFrictional ? problem.kernels.evaluate : problem.kernels.evaluateFrictionless;
    return evaluate(problem.bodies.data(), problem.blocks.data(), range);
}

/// `squares`, `largest`: the defects of isolated contacts, summed up and the largest [m2/s2, m/s].
void addIsolated(SolveReport& report, std::size_t isolated, double squares, double largest)
{
    squares += report.residualRms*report.residualRms*static_cast<double>(report.contacts);
    report.isolated = isolated;
    report.contacts += isolated;
    report.residualRms = std::sqrt(squares/static_cast<double>(report.contacts));
    report.residualMax = std::max(report.residualMax, largest);
}

} // namespace

SolveReport solveBesideIsolated(ContactProblem& problem, std::size_t isolatedBlocks, const ContactSettings& settings, SolveReport (*solve)(ContactProblem&, const ContactSettings&))
{
    std::vector<std::uint32_t>& awake = problem.awake;
    const auto firstOfRest = [&]() { return std::lower_bound(awake.begin(), awake.end(), isolatedBlocks); };
    const std::vector<std::uint32_t> isolated(awake.begin(), firstOfRest());
    awake.erase(awake.begin(), firstOfRest());
    problem.firstBlock = isolatedBlocks;

    const BlockRange apart{isolated.data(), isolated.size()};
    if (!std::isfinite(sweepBlocks(problem, apart).sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
    const DefectSums left = defectsOf(problem, apart);  // round-off
    double numbers[3] = {static_cast<double>(awake.size()), left.active, left.sumSquares};
    problem.halo.sum(numbers, 3);

    SolveReport report;
    if (numbers[0] > 0.0) report = solve(problem, settings);
    else report.speedScale = makeStopRule(problem, settings, {0.0, 0.0, 0.0}).speedScale;
    if (numbers[1] > 0.0) addIsolated(report, static_cast<std::size_t>(numbers[1]), numbers[2], problem.halo.max(std::sqrt(left.maxSquare)));
    // A solver may have taken all blocks.
    awake.erase(awake.begin(), firstOfRest());
    awake.insert(awake.begin(), isolated.begin(), isolated.end());
    return report;
}

} // namespace nscd
