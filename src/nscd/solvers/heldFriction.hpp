// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A step whose contact problem Coulomb's law gives no solution, or none that sweeps find, solved with friction that is held.
// Tested by tests/unit/nscd/solvers/heldFrictionTest.cpp
#pragma once

#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/problem/stopRule.hpp"

#include <vector>

namespace nscd
{

/// The bounds of a held problem, in the place of its blocks' friction coefficients for as long as the object lives.
class FrictionBounds
{
public:
    /// All zero.
    explicit FrictionBounds(ContactProblem& problem);
    ~FrictionBounds();
    FrictionBounds(const FrictionBounds&) = delete;
    FrictionBounds& operator=(const FrictionBounds&) = delete;

    /// Sets P by the present normal impulses.
    void limit(double factor);
    /// tau + share (min(mu r_n, min(mu, 1) P) - tau); where `mayRise` is false no tau becomes larger.
    void follow(double share, bool mayRise);
    /// Makes all bounds smaller.
    void fade(double share);
    /// Coefficients in the place of bounds, and back.
    void swap();
    /// Sum of what friction at its bound is off mu r_n, over the sum of mu r_n [-].
    double off() const;

private:
    double normalImpulse(std::size_t slot) const;

    ContactProblem& problem_;
    std::vector<double> other_;   ///< per slot: coefficients, or, swapped, bounds
    std::vector<double> most_;    ///< P per slot [N s]
};

/// The rounds of solveHeld().
class HeldSolve
{
public:
    HeldSolve(ContactProblem& problem, const ContactSettings& settings);
    SolveReport solve();

private:
    void sweep(int mostSweeps);
    /// Whether the solution is one of Coulomb's law, by the common residual.
    bool isCoulomb();
    /// Returns whether Coulomb's law was met.
    bool follow();
    void fade();

    ContactProblem& problem_;
    const ContactSettings& settings_;
    SweepKernels kernels_;
    ContactProblem convex_;
    FrictionBounds bounds_;
    StopRule rule_;
    SolveReport convexReport_;   ///< of the convex problems
    SolveReport report_;         ///< by Coulomb's law
};

/// Solves a problem with |r_t| <= tau, tau a number for each contact (Tresca's law): min over r_n >= 0, |r_t| <= tau of r.W r/2 + r.(u^- + b) is convex, so it
/// has a solution wherever what is driven leaves room for one, sweeps come to it, and it takes energy: at r = 0 the sum is 0. First tau = 0; then, round after round, tau follows
/// min(mu r_n, min(mu, 1) P), P some times what presses on the same bodies without friction; where that does not come to rest tau may only fall, then it stays. Where
/// sweeps do not solve even that, as between masses far apart, all tau fade, in the end to nothing: without friction sweeps are quick.
/// Equation: this is the fixed-point iteration of Necas, Jarusek & Haslinger (1980) for Coulomb's law; P makes it one of a compact set
/// Ensures:  impulses start from those of the problem, with friction left out (none where the step was solved before); report.converged where tau has come to rest at Coulomb's law (the common
///           residual is met), else report.isHeld, and frictionOff by how much; atCap where not even the convex problem was solved
SolveReport solveHeld(ContactProblem& problem, const ContactSettings& settings);

/// Solves a problem without friction by plain sweeps: where walls leave grains no room it has no solution, and impulses grow for ever, but velocities
/// stay about those of the walls. Momentum makes them swing beyond.
/// Ensures: as solveHeld(); converged in problems without friction alone
SolveReport solvePressed(ContactProblem& problem, const ContactSettings& settings);

} // namespace nscd
