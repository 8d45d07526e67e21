// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A direct method for the contact problem: what it costs depends on how bodies hang together, not on depth or ratios of mass.
#pragma once

#include "nscd/solvers/direct/convexContact.hpp"
#include "nscd/solvers/problem/stopRule.hpp"

#include <memory>
#include <vector>

namespace nscd
{

/// Share of the stop rule's limits that a direct solve goes on to: another round costs little, and forces under tall or heavy
/// things need more than velocities tell (in a stack of N the error of the forces is N^2 times that of the velocities).
constexpr double directFineness = 1e-5;

/// Proximal method of multipliers on Coulomb's cones, in the bodies' velocities: repeats
///     x <- argmin of ConvexContact,  r <- p,  s <- |u_t|
/// until r stays. Then p is in the cone K, u + (b + mu s) n in its dual, and they are orthogonal: Coulomb's law in the form of
/// De Saxce & Feng (1998). Holding s makes each problem convex (Acary, Cadoux, Lemarechal & Malick 2011); rho = stiffness/W_nn makes
/// few repetitions enough, and the matrices are positive definite however many contacts a body has.
/// Only contacts that carry or should carry an impulse are in the matrix; others join when the solution asks for them.
class DirectSolve
{
public:
    /// Of a problem of one rank.
    explicit DirectSolve(ContactProblem& problem);

    /// What a solve is expected to cost, in sweeps over the active blocks; infinite if more than `limit`, or than memory may hold.
    double price(double limit) const;

    /// Solves on from the present impulses until the common residual is within `fineness` of the rule, or gets no smaller.
    /// Never leaves a larger residual than it found. Returns the Newton steps made.
    int run(const StopRule& rule, double fineness);

private:
    /// A state to go back to.
    struct Snapshot
    {
        std::vector<Body> bodies;
        std::vector<Vec3> impulses;   ///< of slots_
        double excess;                ///< residual over what the rule allows: up to 1 is within
    };

    bool isWithinReach() const;
    bool collect(double leastApproach);
    JoinedBodies joined(std::size_t slot) const;
    MotionComponents components() const;
    std::unique_ptr<ConvexContact> build() const;
    Eigen::VectorXd motion() const;
    void store(const ConvexContact& solved);
    Snapshot snapshot(const StopRule& rule) const;
    void restore(const Snapshot& taken);

    ContactProblem& problem_;
    std::vector<std::size_t> slots_;      ///< contacts in the matrix
    std::vector<char> isTaken_;           ///< per slot of the problem
    std::vector<int> number_;             ///< of each body in the matrix, or -1
    std::vector<int> bodies_;             ///< those in the matrix
};

} // namespace nscd
