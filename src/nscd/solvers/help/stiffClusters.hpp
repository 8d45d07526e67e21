// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Light bodies that stick between heavy ones: clusters of contacts that sweeps come through by the ratio of masses only.
// Tested by tests/unit/nscd/solvers/help/stiffClustersTest.cpp
#pragma once

#include "nscd/scene/solverStrategy.hpp"
#include "nscd/solvers/problem/stopRule.hpp"

#include <cstdint>
#include <vector>

namespace nscd
{

/// Contacts of a problem, on this rank, that may carry impulses, by body.
class StiffClusters
{
public:
    StiffClusters(ContactProblem& problem, const SolverStrategy::Clusters& strategy);

    /// Round after round the contacts with a defect above `threshold` [m/s] at bodies that touch a much heavier or lighter one, the worst first, are solved
    /// each with those around it (ClusterSolve), until none is left, or for as many rounds as the strategy has: other defects sweeps remove
    /// sooner. Returns the Newton steps made.
    int solve(double threshold);

private:
    std::vector<std::uint32_t> seeds(double threshold) const;
    bool isBetweenUnlike(std::uint32_t slot) const;
    bool isAtUnlike(std::uint32_t slot) const;
    bool mayCarry(std::uint32_t slot) const;
    std::vector<std::uint32_t> around(std::uint32_t seed);
    int solveRound(const std::vector<std::uint32_t>& seeds, double threshold);

    ContactProblem& problem_;
    const SolverStrategy::Clusters& strategy_;
    std::vector<std::uint32_t> start_;         ///< per body, into slotsOfBody_
    std::vector<std::uint32_t> slotsOfBody_;
    std::vector<char> isUnlike_;               ///< per body: it touches one whose mass differs by the strategy's ratio
    std::vector<char> isTaken_;                ///< per slot, in this round
};

/// Whether masses differ so much that clusters are looked for.
bool haveStiffClusters(const ContactProblem& problem, const SolverStrategy::Clusters& strategy);

} // namespace nscd
