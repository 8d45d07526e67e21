// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson acceleration of a fixed-point map of contact impulses.
#pragma once

#include "nscd/kernels/contactBlock.hpp"
#include "nscd/kernels/halo.hpp"

#include <Eigen/Core>

#include <vector>

namespace nscd
{

/// Anderson mixing for r -> F(r), r the impulses of some blocks (Walker & Ni 2011, eq. 2.2, difference form):
/// with f = F(r) - r, r_new = F(r) - dF gamma, gamma = argmin |f - df gamma| over the last differences df of f and dF of F(r).
/// The norm is that of velocities in contacts, |f|^2 = sum of W_nn f_k^2.
class AndersonAcceleration
{
public:
    /// Impulses as one vector: x, y, z of eight lanes for each block.
    using Impulses = std::vector<double>;

    /// For the blocks of a range, which must stay as it is; of all ranks, one gamma for all.
    AndersonAcceleration(BlockRange range, DifferenceFunction addDifferences, const Halo& halo);

    /// Turns `r` into the next iterate of the map whose last application led from `r` to what the blocks hold, before
    /// its projection on the friction cones; to the blocks' impulses themselves until there are differences to mix.
    void mix(const std::vector<ContactBlock>& blocks, Impulses& r);

    /// What the blocks held at the last mixing.
    const Impulses& image() const { return previousImage_; }

    /// Drops the differences: the next iterate has no history.
    void forget();

private:
    using Gamma = Eigen::Matrix<double, mixingDepth, 1>;

    void remember(const std::vector<ContactBlock>& blocks, Impulses& r);
    MixingHistory history();
    Gamma solveLeastSquares() const;
    void combine(const Gamma& gamma, Impulses& r) const;

    BlockRange range_;
    DifferenceFunction addDifferences_;
    const Halo& halo_;
    int column_ = 0;      ///< of the newest difference
    int stored_ = 0;
    bool hasPrevious_ = false;
    Impulses previousImage_;
    std::vector<float> previousDefect_;
    std::vector<float> imageDifference_[mixingDepth];
    std::vector<float> defectDifference_[mixingDepth];
    Eigen::Matrix<double, mixingDepth, mixingDepth> gram_;  ///< df^T W df
    Gamma projection_;                          ///< df^T W f
};

/// The impulses the blocks hold.
void gatherImpulses(const std::vector<ContactBlock>& blocks, BlockRange range, AndersonAcceleration::Impulses& r);

} // namespace nscd
