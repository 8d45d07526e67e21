// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// When the direct method takes over from sweeps.
// Tested by tests/unit/nscd/solvers/direct/directSolveTest.cpp
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

#include <limits>

namespace nscd
{

/// Watches one solve by sweeps, on one rank. The direct method takes over
/// - once the sweeps made have cost as much as it is expected to, so that both together cost at most twice the cheaper one;
///   or at the cap, if it costs no more than ten times the sweeps up to there;
/// - when the stop rule is met and a contact is loaded between bodies whose masses differ by more than 50: the heavy one's
///   velocity is right long before the impulses below it are (their error is its mass times that of its velocity).
/// Where it is too dear, or there are several ranks, sweeps do what they can, and the report says so.
class DirectHelp
{
public:
    DirectHelp(ContactProblem& problem, const ContactSettings& settings) : problem_(problem), settings_(settings) {}

    /// Whether to call solve() after so many sweeps.
    bool isDue(int sweeps);

    void solve(const StopRule& rule);

    /// To be called with a solution that is about to be returned: makes the forces under heavy bodies right, or reports that they may not be.
    /// Returns whether it changed the solution.
    bool complete(SolveReport& report, const StopRule& rule);

private:
    double priceLimit() const;
    void checkHeavyBodies(SolveReport& report, const StopRule& rule);

    ContactProblem& problem_;
    const ContactSettings& settings_;
    int due_ = std::numeric_limits<int>::max();
    bool hasPrice_ = false;
    bool isDone_ = false;
    int newtonSteps_ = 0;
};

} // namespace nscd
