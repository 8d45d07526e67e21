// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Momentum for Gauss-Seidel sweeps: what shortens cold solves, in which weight has many layers to come down through.
#pragma once

#include "andersonAcceleration.hpp"
#include "contactSolver.hpp"

namespace nscd
{

/// Accelerated sweeps: r_k = F(y_k), F one sweep; y_{k+1} = r_k + theta (r_k - r_{k-1}), theta = min((t - 1)/t', limit),
/// t' = (1 + sqrt(1 + 4 t^2))/2 (Nesterov 1983), with t = 1 again where (y - r).W_nn (r_k - r_{k-1}) > 0 (O'Donoghue & Candes 2015, gradient
/// scheme). Deviations: a sweep takes the place of a gradient step; the limit 1 - 1.2/depth, depth of the grains in d along the way they
/// fall, within [0.9, 0.99]: with more momentum weight swings, with less it comes down slowly.
class SweepMomentum
{
public:
    using Impulses = AndersonAcceleration::Impulses;

    /// For the active blocks of a problem, which must stay as they are; of all ranks.
    explicit SweepMomentum(const ContactProblem& problem);

    /// Turns `y`, which a sweep has led to what the blocks hold, into the next y, before its projection on the friction cones.
    void mix(Impulses& y);

    /// What the blocks held at the last mixing: r_k.
    const Impulses& image() const { return image_; }

    /// Drops r_{k-1}, and with it the direction, not the pace.
    void forget() { hasImage_ = false; }

private:
    double uphill(const Impulses& y) const;

    const ContactProblem& problem_;
    double limit_;
    double pace_ = 1.0;   ///< t
    bool hasImage_ = false;
    Impulses image_;
};

} // namespace nscd
