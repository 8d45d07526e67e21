// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A first-in first-out queue of contacts with their neighbors by body.
#include "nscd/solvers/help/contactQueue.hpp"

#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/solvers/problem/localContact.hpp"

#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <stdexcept>

namespace nscd
{

namespace
{

std::array<std::int32_t, 2> bodiesOf(const ContactProblem& problem, std::size_t slot)
{
    const ContactBlock& block = problem.blocks[slot/blockLanes];
    const std::int32_t a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
    if (!problem.general) return {a, b};
    return {problem.general->representative(a), problem.general->representative(b)};
}

bool isMovable(const ContactProblem& problem, std::int32_t body) { return problem.bodies[body].invMass > 0.0; }

} // namespace

ContactQueue::ContactQueue(ContactProblem& problem, BlockRange range)
:
    problem_(problem)
{
    blocks_.reserve(range.count);
    used_.reserve(range.count*blockLanes);
    for (std::size_t k = 0; k < range.count; ++k)
    {
        blocks_.push_back(range[k]);
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (isUsed(problem.blocks[range[k]], lane)) used_.push_back(range[k]*blockLanes + lane);
        }
    }
    groupByBody();
}

void ContactQueue::groupByBody()
{
    start_.assign(problem_.bodies.size() + 1, 0);
    const auto forEach = [&](auto&& visit)
    {
        for (std::uint32_t slot : used_)
        {
            for (std::int32_t body : bodiesOf(problem_, slot))
            {
                if (isMovable(problem_, body)) visit(body, slot);
            }
        }
    };
    forEach([&](std::int32_t body, std::uint32_t) { ++start_[body + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    slotsOfBody_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    forEach([&](std::int32_t body, std::uint32_t slot) { slotsOfBody_[next[body]++] = slot; });
}

std::vector<std::uint32_t> ContactQueue::defective(double threshold) const
{
    return defectiveSlots(problem_, {blocks_.data(), blocks_.size()}, threshold);
}

std::size_t ContactQueue::work(const std::vector<std::uint32_t>& seeds, double threshold, std::size_t maxVisits)
{
    std::deque<std::uint32_t> queue(seeds.begin(), seeds.end());
    std::vector<char> isQueued(problem_.blocks.size()*blockLanes, 0);
    for (std::uint32_t slot : seeds) isQueued[slot] = 1;

    std::size_t visits = 0;
    while (!queue.empty() && visits < maxVisits)
    {
        const std::uint32_t slot = queue.front();
        queue.pop_front();
        isQueued[slot] = 0;
        ++visits;
        const LocalChange change = localChange(problem_, slot);
        if (!std::isfinite(change.defect)) throw std::runtime_error("contact solve met a velocity that is not finite");
        if (change.defect <= threshold) continue;
        apply(problem_, slot, change);
        for (std::int32_t body : bodiesOf(problem_, slot))
        {
            if (!isMovable(problem_, body)) continue;
            for (std::uint32_t k = start_[body]; k < start_[body + 1]; ++k)
            {
                const std::uint32_t neighbor = slotsOfBody_[k];
                if (neighbor == slot || isQueued[neighbor]) continue;
                isQueued[neighbor] = 1;
                queue.push_back(neighbor);
            }
        }
    }
    return visits;
}

} // namespace nscd
