// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Growing clusters, the worst first.
#include "nscd/solvers/help/stiffClusters.hpp"

#include "nscd/solvers/help/clusterSolve.hpp"
#include "nscd/solvers/problem/localContact.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <utility>

namespace nscd
{

namespace
{

std::array<std::int32_t, 2> bodiesOf(const ContactProblem& problem, std::uint32_t slot)
{
    const ContactBlock& block = problem.blocks[slot/blockLanes];
    return {block.a[slot % blockLanes], block.b[slot % blockLanes]};
}

bool isMovable(const ContactProblem& problem, std::int32_t body) { return problem.bodies[body].invMass > 0.0; }

} // namespace

bool haveStiffClusters(const ContactProblem& problem, const SolverStrategy::Clusters& strategy)
{
    return strategy.isOn && !problem.areFilms && problem.massRatio >= strategy.leastMassRatio;
}

StiffClusters::StiffClusters(ContactProblem& problem, const SolverStrategy::Clusters& strategy)
:
    problem_(problem),
    strategy_(strategy),
    start_(problem.bodies.size() + 1, 0),
    isUnlike_(problem.bodies.size(), 0),
    isTaken_(problem.blocks.size()*blockLanes, 0)
{
    const BlockRange range = problem.inner();
    const auto forEach = [&](auto&& visit)
    {
        for (std::size_t k = 0; k < range.count; ++k)
        for (std::uint32_t slot = range[k]*blockLanes; slot < (range[k] + 1)*blockLanes; ++slot)
        {
            if (!isUsed(problem.blocks[range[k]], slot % blockLanes)) continue;
            for (std::int32_t body : bodiesOf(problem, slot)) if (isMovable(problem, body)) visit(body, slot);
        }
    };
    forEach([&](std::int32_t body, std::uint32_t) { ++start_[body + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    slotsOfBody_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    forEach([&](std::int32_t body, std::uint32_t slot)
    {
        slotsOfBody_[next[body]++] = slot;
        isUnlike_[body] = isUnlike_[body] || isBetweenUnlike(slot);
    });
}

bool StiffClusters::isBetweenUnlike(std::uint32_t slot) const
{
    const auto [a, b] = bodiesOf(problem_, slot);
    if (!isMovable(problem_, a) || !isMovable(problem_, b)) return false;
    const double ratio = problem_.bodies[a].invMass/problem_.bodies[b].invMass;
    return std::max(ratio, 1.0/ratio) >= strategy_.leastMassRatio;
}

bool StiffClusters::isAtUnlike(std::uint32_t slot) const
{
    const auto [a, b] = bodiesOf(problem_, slot);
    return isUnlike_[a] || isUnlike_[b];
}

bool StiffClusters::mayCarry(std::uint32_t slot) const
{
    const ContactBlock& block = problem_.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    if (block.bias[lane] == 0.0 || block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0) return true;
    const double *const a = problem_.bodies[block.a[lane]].v, *const b = problem_.bodies[block.b[lane]].v;
    return block.n[0][lane]*(a[0] - b[0]) + block.n[1][lane]*(a[1] - b[1]) + block.n[2][lane]*(a[2] - b[2]) + block.bias[lane] < 0.0;
}

std::vector<std::uint32_t> StiffClusters::seeds(double threshold) const
{
    std::vector<std::pair<double, std::uint32_t>> sorted;
    for (std::uint32_t slot : defectiveSlots(problem_, problem_.inner(), threshold))
    {
        if (isAtUnlike(slot)) sorted.push_back({-localChange(problem_, slot).defect, slot});
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint32_t> slots;
    for (const auto& [defect, slot] : sorted) slots.push_back(slot);
    return slots;
}

/// The contact, and those of the bodies at hand that may carry and are in no other cluster of this round, the lightest body first: what holds a light body
/// between heavy ones is all there. Bodies with more contacts than there is room for are left out.
std::vector<std::uint32_t> StiffClusters::around(std::uint32_t seed)
{
    std::vector<std::uint32_t> slots;
    std::vector<std::int32_t> met;
    std::priority_queue<std::pair<double, std::int32_t>> next;
    const auto add = [&](std::uint32_t slot)
    {
        isTaken_[slot] = 1;
        slots.push_back(slot);
        for (std::int32_t body : bodiesOf(problem_, slot))
        {
            if (!isMovable(problem_, body) || std::find(met.begin(), met.end(), body) != met.end()) continue;
            met.push_back(body);
            next.push({problem_.bodies[body].invMass, body});
        }
    };
    add(seed);
    const std::size_t least = problem_.lawBlocks ? strategy_.contactsWithMoments : strategy_.contacts;
    while (!next.empty() && slots.size() < least)
    {
        const std::int32_t body = next.top().second;
        next.pop();
        std::vector<std::uint32_t> more;
        for (std::uint32_t k = start_[body]; k < start_[body + 1]; ++k)
        {
            const std::uint32_t slot = slotsOfBody_[k];
            if (!isTaken_[slot] && mayCarry(slot)) more.push_back(slot);
        }
        if (static_cast<int>(slots.size() + more.size()) <= ClusterSolve::mostContacts(problem_)) std::for_each(more.begin(), more.end(), add);
    }
    return slots;
}

int StiffClusters::solveRound(const std::vector<std::uint32_t>& seeds, double threshold)
{
    std::fill(isTaken_.begin(), isTaken_.end(), 0);
    int steps = 0, clusters = 0;
    for (auto seed = seeds.begin(); seed != seeds.end() && clusters < strategy_.mostInRound; ++seed)
    {
        if (isTaken_[*seed]) continue;
        steps += ClusterSolve(problem_, around(*seed)).run(strategy_.fineness*threshold);
        ++clusters;
    }
    return steps;
}

int StiffClusters::solve(double threshold)
{
    int steps = 0;
    for (int round = 0; round < strategy_.rounds; ++round)
    {
        const std::vector<std::uint32_t> worst = seeds(threshold);
        if (worst.empty()) break;
        steps += solveRound(worst, threshold);
    }
    return steps;
}

} // namespace nscd
