// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The queue of the thesis (section 2.3): a contact is solved again only after something near it changed.
#include "contactSolver.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

namespace nscd
{

namespace
{

/// Contacts of each movable body, as slots.
struct ContactsOfBody
{
    std::vector<std::size_t> start;
    std::vector<std::size_t> slots;
};

bool isUsed(const ContactBlock& block, int lane) { return block.invWn[lane] > 0.0; }

ContactsOfBody groupByBody(const ContactProblem& problem)
{
    ContactsOfBody table;
    table.start.assign(problem.bodies.size() + 1, 0);
    const auto forEach = [&](auto&& visit)
    {
        for (std::size_t slot = 0; slot < problem.blocks.size()*blockLanes; ++slot)
        {
            const ContactBlock& block = problem.blocks[slot/blockLanes];
            const int lane = slot % blockLanes;
            if (!isUsed(block, lane)) continue;
            for (std::int32_t body : {block.a[lane], block.b[lane]})
            {
                if (problem.bodies[body].invMass > 0.0) visit(body, slot);
            }
        }
    };
    forEach([&](std::int32_t body, std::size_t) { ++table.start[body + 1]; });
    for (std::size_t body = 0; body < problem.bodies.size(); ++body) table.start[body + 1] += table.start[body];
    table.slots.resize(table.start.back());
    std::vector<std::size_t> next(table.start.begin(), table.start.end() - 1);
    forEach([&](std::int32_t body, std::size_t slot) { table.slots[next[body]++] = slot; });
    return table;
}

/// Relative velocity at the contact, world frame [m/s].
void relativeVelocity(const Body& a, const Body& b, const double n[3], double u[3])
{
    const double s[3] = {a.s[0] + b.s[0], a.s[1] + b.s[1], a.s[2] + b.s[2]};
    u[0] = a.v[0] - b.v[0] - (s[1]*n[2] - s[2]*n[1]);
    u[1] = a.v[1] - b.v[1] - (s[2]*n[0] - s[0]*n[2]);
    u[2] = a.v[2] - b.v[2] - (s[0]*n[1] - s[1]*n[0]);
}

/// Closed-form solution of one contact (grains.md section 1) as a change of its impulse; zero friction included.
void localChange(const ContactBlock& block, int lane, const double u[3], const double n[3], double delta[3])
{
    double rn = 0.0, un = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        rn += block.r[k][lane]*n[k];
        un += u[k]*n[k];
    }
    const double pn = std::max(0.0, rn - (un + block.bias[lane])*block.invWn[lane]);
    double q[3], q2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        q[k] = block.r[k][lane] - rn*n[k] - (u[k] - un*n[k])*block.invWt[lane];
        q2 += q[k]*q[k];
    }
    const double limit = block.friction[lane]*pn;
    const double scale = q2 > limit*limit ? limit/std::sqrt(q2) : 1.0;
    for (int k = 0; k < 3; ++k) delta[k] = pn*n[k] + scale*q[k] - block.r[k][lane];
}

/// Solves one slot; keeps the new impulse and returns true only if it changed u by more than the threshold (the thesis' revert).
bool solveSlot(ContactProblem& problem, std::size_t slot, double threshold)
{
    ContactBlock& block = problem.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    Body& a = problem.bodies[block.a[lane]];
    Body& b = problem.bodies[block.b[lane]];
    const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
    double u[3], delta[3];
    relativeVelocity(a, b, n, u);
    localChange(block, lane, u, n, delta);

    double normalChange = 0.0, size2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        normalChange += delta[k]*n[k];
        size2 += delta[k]*delta[k];
    }
    const double invWt = problem.isFrictional ? block.invWt[lane] : block.invWn[lane];
    const double tangential2 = std::max(0.0, size2 - normalChange*normalChange);
    const double change = std::sqrt(normalChange*normalChange/(block.invWn[lane]*block.invWn[lane]) + tangential2/(invWt*invWt));
    if (!std::isfinite(change)) throw std::runtime_error("contact solve met a velocity that is not finite");
    if (change <= threshold) return false;

    for (int k = 0; k < 3; ++k) block.r[k][lane] += delta[k];
    applyImpulse(a, b, n, delta);
    return true;
}

/// Works the queue off; returns the visits made.
std::size_t workQueue(ContactProblem& problem, const ContactsOfBody& contacts, double threshold, std::size_t maxVisits)
{
    std::deque<std::size_t> queue;
    std::vector<char> isQueued(problem.blocks.size()*blockLanes, 0);
    const auto push = [&](std::size_t slot)
    {
        if (isQueued[slot]) return;
        isQueued[slot] = 1;
        queue.push_back(slot);
    };
    for (std::size_t slot = 0; slot < isQueued.size(); ++slot)
    {
        if (isUsed(problem.blocks[slot/blockLanes], slot % blockLanes)) push(slot);
    }
    std::size_t visits = 0;
    while (!queue.empty() && visits < maxVisits)
    {
        const std::size_t slot = queue.front();
        queue.pop_front();
        isQueued[slot] = 0;
        ++visits;
        if (!solveSlot(problem, slot, threshold)) continue;
        const ContactBlock& block = problem.blocks[slot/blockLanes];
        for (std::int32_t body : {block.a[slot % blockLanes], block.b[slot % blockLanes]})
        {
            if (!(problem.bodies[body].invMass > 0.0)) continue;
            for (std::size_t k = contacts.start[body]; k < contacts.start[body + 1]; ++k) push(contacts.slots[k]);
        }
    }
    return visits;
}

std::size_t countUsed(const ContactProblem& problem)
{
    std::size_t used = 0;
    for (const ContactBlock& block : problem.blocks)
    {
        for (int lane = 0; lane < blockLanes; ++lane) used += isUsed(block, lane);
    }
    return used;
}

} // namespace

SolveReport solveQueue(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    const std::size_t used = countUsed(problem);
    if (used == 0) return report;

    const ContactsOfBody contacts = groupByBody(problem);
    const DefectSums first = residual(problem);
    const StopRule rule = makeStopRule(problem, settings, first);
    const std::size_t maxVisits = used*static_cast<std::size_t>(settings.maxSweeps);
    std::size_t visits = 0;
    // The local threshold bounds each contact, the stop rule all of them; tighten until the rule is met.
    double threshold = std::min(rule.rmsLimit, rule.maxLimit);
    do
    {
        visits += workQueue(problem, contacts, threshold, maxVisits - visits);
        reportResidual(report, rule, residual(problem));
        threshold *= 0.5;
    }
    while (!report.converged && visits < maxVisits);
    report.sweeps = static_cast<int>((visits + used - 1)/used);
    return report;
}

} // namespace nscd
