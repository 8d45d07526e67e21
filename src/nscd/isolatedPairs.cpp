// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One visit for isolated contacts, the solver for the rest.
#include "isolatedPairs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace nscd
{

SolveReport solveBesideIsolated(ContactProblem& problem, std::size_t isolatedBlocks, const ContactSettings& settings, ContactSolver solve)
{
    std::vector<std::uint32_t>& awake = problem.awake;
    const auto firstOfRest = [&]() { return std::lower_bound(awake.begin(), awake.end(), isolatedBlocks); };
    const std::vector<std::uint32_t> isolated(awake.begin(), firstOfRest());
    awake.erase(awake.begin(), firstOfRest());
    problem.firstBlock = isolatedBlocks;

    const DefectSums sums = sweepBlocks(problem, {isolated.data(), isolated.size()});
    if (!std::isfinite(sums.sumSquares)) throw std::runtime_error("contact solve met a velocity that is not finite");
    double numbers[2] = {static_cast<double>(awake.size()), sums.active};
    problem.halo.sum(numbers, 2);

    SolveReport report;
    if (numbers[0] > 0.0) report = solve(problem, settings);
    else report.speedScale = makeStopRule(problem, settings, {0.0, 0.0, 0.0}).speedScale;
    report.isolated = static_cast<std::size_t>(numbers[1]);
    const double swept = static_cast<double>(report.contacts);
    report.contacts += report.isolated;
    // The mean square is one over all contacts, and these have no defect left.
    report.residualRms *= std::sqrt(std::max(1.0, swept)/std::max<double>(1.0, static_cast<double>(report.contacts)));
    // A solver may have taken all blocks.
    awake.erase(awake.begin(), firstOfRest());
    awake.insert(awake.begin(), isolated.begin(), isolated.end());
    return report;
}

} // namespace nscd
