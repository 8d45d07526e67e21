// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The neighborhood of large defects, and sweeps over it.
#include "nscd/solvers/help/loneDefects.hpp"

#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/solvers/problem/localContact.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

class Neighborhood
{
public:
    explicit Neighborhood(const ContactProblem& problem)
    :
        problem_(problem),
        isNear_(problem.bodies.size(), 0)
    {}

    /// Bodies of contacts with a larger defect are near.
    void addDefective(double limit)
    {
        for (std::uint32_t slot : defectiveSlots(problem_, problem_.active(), limit))
        {
            if (!isGeneral(problem_.general, slot)) addBodies(slot/blockLanes, slot % blockLanes);
        }
    }

    /// Active blocks with a contact of a near body, in their order; all bodies of those contacts then are near.
    std::vector<std::uint32_t> grow()
    {
        const std::vector<char> before = isNear_;
        std::vector<std::uint32_t> found;
        const BlockRange active = problem_.active();
        for (std::size_t k = 0; k < active.count; ++k)
        {
            const ContactBlock& block = blockAt(active[k]);
            bool isFound = false;
            for (int lane = 0; lane < blockLanes; ++lane)
            {
                if (!before[block.a[lane]] && !before[block.b[lane]]) continue;
                isFound = true;
                addBodies(active[k], lane);
            }
            if (isFound) found.push_back(active[k]);
        }
        return found;
    }

private:
    ContactBlock& blockAt(std::size_t k) const { return problem_.blocks[k]; }

    void addBodies(std::size_t block, int lane)
    {
        for (const std::int32_t body : {blockAt(block).a[lane], blockAt(block).b[lane]})
        {
            if (problem_.bodies[body].invMass > 0.0) isNear_[body] = 1;
        }
    }

    const ContactProblem& problem_;
    std::vector<char> isNear_;
};

} // namespace

bool polishLoneDefects(ContactProblem& problem, const StopRule& rule, const SolverStrategy::LoneDefects& strategy)
{
    const double limit = rule.polishedMax;
    Neighborhood neighborhood(problem);
    neighborhood.addDefective(0.5*limit);
    std::vector<std::uint32_t> chosen;
    for (int k = 0; k < strategy.contactsAway; ++k) chosen = neighborhood.grow();

    const double share = static_cast<double>(chosen.size())/std::max<std::size_t>(1, problem.awake.size());
    const double sweeps = std::min(strategy.mostSweeps, strategy.mostWork/problem.halo.max(std::max(share, 1e-3)));
    problem.awake.swap(chosen);
    bool isPolished = false;
    for (int sweep = 0; sweep < sweeps && !isPolished; ++sweep) isPolished = sweepActive(problem).maxSquare <= 0.5*limit*limit;
    problem.awake.swap(chosen);
    return isPolished;
}

} // namespace nscd
