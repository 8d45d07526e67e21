// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Momentum for Gauss-Seidel sweeps: what shortens flows, and solves in which weight has many layers to come down through.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

#include <utility>
#include "nscd/solvers/help/andersonAcceleration.hpp"

namespace nscd
{

/// Accelerated sweeps: r_k = F(y_k), F one sweep; y_{k+1} = r_k + theta (r_k - r_{k-1}), impulses of laws and velocities likewise, since these are linear in both. y may
/// lie outside of the friction cones: a sweep over spheres asks what acts on a contact beside its own impulse, so r_{k+1} does not.
/// falling: theta = min((t - 1)/t', limit), t' = (1 + sqrt(1 + 4 t^2))/2 (Nesterov 1983), with t = 1 again where (y - r).W_nn (r_k - r_{k-1}) > 0
/// (O'Donoghue & Candes 2015, gradient scheme). Deviations: a sweep takes the place of a gradient step; the limit 1 - 1.2/depth, depth of the
/// grains in d along the way they fall, within [0.9, 0.99]: with more momentum weight swings, with less it comes down slowly.
/// flowing: theta = 0.9, near the solution 0.8. What is to be found is near by: impulses that moving grains rearrange, not weight from far above.
class SweepMomentum
{
public:
    using Impulses = AndersonAcceleration::Impulses;
    enum class Kind { falling, flowing };

    /// For the active blocks of a problem, which must stay as they are until forget(); of all ranks.
    SweepMomentum(ContactProblem& problem, Kind kind, const SolverStrategy::Momentum& strategy);

    /// Turns what a sweep has led to, r_k, into the next y, in flows once the next sweep comes by. `isNear`: whether the solution is near.
    void advance(bool isNear = false);

    /// What the next sweep has to move the impulses on by; empty unless advance() was called since the last call.
    SweepOn forNextSweep() { return std::exchange(forNextSweep_, SweepOn()); }

    /// Back to r_k.
    void revert();

    /// Drops r_{k-1}, and with it the direction, not the pace.
    void forget() { hasImage_ = false; }

    /// Takes in active blocks that have come behind the others within this rank, and behind those with other ranks, and carry nothing.
    void grow();

private:
    bool isLinear() const { return !problem_.general; }
    double nextTheta(bool isNear);
    double uphill() const;
    void keepImage();
    void gatherLaw();
    void extrapolateLaw(double theta);
    void extrapolate(double theta);
    void extrapolateImpulsesAlone(double theta);

    ContactProblem& problem_;
    Kind kind_;
    const SolverStrategy::Momentum& strategy_;
    double limit_;        ///< of theta, where grains fall
    double pace_ = 1.0;   ///< t
    bool hasImage_ = false;
    std::size_t inner_ = 0;      ///< active blocks within this rank, when the image was made
    Impulses image_;      ///< r_k
    Impulses ofLaw_;    ///< of r_k, numbered likewise, where contacts bear any
    std::vector<Body> bodies_;   ///< with the velocities of r_k
    Impulses start_;      ///< y, where it is asked for
    SweepOn forNextSweep_;
};

} // namespace nscd
