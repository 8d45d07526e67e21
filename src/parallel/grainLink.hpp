// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Between the ranks that own grains and those that work for them elsewhere: their homes in a mesh, say.
#pragma once

#include "parallel/communicator.hpp"

namespace nscd
{

/// Joins each own grain with a row at its home. Rows are sorted by (rank of the owner, index there). All functions are collective.
/// Cost: connect() one message per home and a barrier; toHomes() and toOwners() one message per pair of ranks that share grains
class GrainLink
{
public:
    /// `all` must live as long as this.
    explicit GrainLink(const Communicator& all) : all_(all) {}

    /// `homes`: a rank for each own grain, or -1 for one without home, which has no row.
    /// Errors: std::invalid_argument for other numbers that are no ranks
    void connect(const std::vector<int>& homes);

    /// Grains that have their home on this rank.
    std::size_t rows() const { return rows_; }

    /// `width` numbers of each own grain to its row, of all grains that have their home here.
    std::vector<double> toHomes(const std::vector<double>& perGrain, int width) const;

    /// `width` numbers of each row to the owner of its grain; zero for own grains without home.
    std::vector<double> toOwners(const std::vector<double>& perRow, int width) const;

private:
    const Communicator& all_;
    std::size_t grains_ = 0;
    std::size_t rows_ = 0;
    std::vector<RankCount> homes_;       ///< of own grains
    std::vector<RankCount> owners_;      ///< of the rows here
    std::vector<std::size_t> byHome_;    ///< own grains in the order of the messages
};

} // namespace nscd
