// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What the grain library needs from other ranks, by MPI.
#pragma once

#include "nscd/scene/exchange.hpp"
#include "parallel/ghostSearch.hpp"
#include "parallel/rankTree.hpp"

namespace nscd
{

/// The Exchange of a run on several ranks. Nothing on a rank grows with their number, but for one box and partner per halving.
/// Cost: findGhosts() 2 to 4 messages per level of the tree; connect() and deliver() one message per rank concerned and a barrier;
///       toGhosts() and toOwners() exactly one message per neighbor.
class MpiExchange : public Exchange
{
public:
    explicit MpiExchange(MPI_Comm parent = MPI_COMM_WORLD);

    int rank() const override { return tree_.all().rank(); }
    bool isParallel() const override { return tree_.all().size() > 1; }
    void sum(double* values, int count) const override { tree_.all().sum(values, count); }
    void max(double* values, int count) const override { tree_.all().max(values, count); }
    void sumAndMax(double (&sums)[2], double& max) const override { tree_.all().sumAndMax(sums, max); }

    std::vector<GhostGrain> findGhosts(const Grains& owned, const GrainPaths& paths, const PeriodicBox& box) override;
    bool isAwayFromOthers(const Vec3& center, double size) const override { return covered_.isOfThisRankAlone(center, size); }
    std::vector<int> connect(const std::vector<GhostGrain>& ghosts) override;
    void toGhosts(const std::vector<double>& shared, std::vector<double>& ghosts, int width) const override;
    void toOwners(const std::vector<double>& ghosts, std::vector<double>& shared, int width) const override;
    std::vector<ImpulseForOwner> deliver(const std::vector<ImpulseForOwner>& entries) const override;

    const RankTree& tree() const { return tree_; }
    const Traffic& traffic() const { return tree_.all().traffic(); }

private:
    RankTree tree_;
    CoveredBoxes covered_;                ///< at the last search for ghosts
    std::vector<RankCount> owners_;       ///< of this rank's ghosts
    std::vector<RankCount> holders_;      ///< of this rank's grains as ghosts
    std::vector<int> ghostsByOwner_;      ///< in the order of the messages
    std::size_t nShared_ = 0;
    mutable std::vector<double> buffer_;  ///< the ghosts' numbers in the order of the messages
};

} // namespace nscd
