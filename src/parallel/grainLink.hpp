// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Between the ranks that own grains and those that work for them elsewhere: their homes in a mesh, say.
#pragma once

#include "parallel/communicator.hpp"

namespace nscd
{

/// Numbers of grains on their way: `width` of each, one grain behind the other. `from` and `to` must not overlap.
struct GrainColumn
{
    const double* from;
    std::size_t grains;   ///< in `from`
    double* to;
    int width;
};

/// Joins each own grain with a row at its home. Rows are sorted by (rank of the owner, index there). All functions are collective.
/// What has its home on the rank that owns it is copied from column to column, only the rest is packed.
/// Cost: connect() one message per other home and a barrier; toHomes() and toOwners() one message per pair of ranks that share grains
class GrainLink
{
public:
    /// `all` must live as long as this.
    explicit GrainLink(const Communicator& all) : all_(all) {}

    /// `homes`: a rank for each own grain, or -1 for one without home, which has no row.
    /// Errors: std::invalid_argument for other numbers that are no ranks
    void connect(const std::vector<int>& homes);

    /// Own grains, with a home or without.
    std::size_t grains() const { return grains_; }

    /// Grains that have their home on this rank.
    std::size_t rows() const { return rows_; }

    /// Columns of own grains into columns of rows.
    /// Errors: std::invalid_argument for a column of another length
    void toHomes(const std::vector<GrainColumn>& columns) const;

    /// Columns of rows into columns of own grains, zero for grains without home.
    /// Errors: std::invalid_argument for a column of another length
    void toOwners(const std::vector<GrainColumn>& columns) const;

private:
    const Communicator& all_;
    std::size_t grains_ = 0;
    std::size_t rows_ = 0;
    std::vector<RankCount> homes_;       ///< of own grains, on other ranks
    std::vector<RankCount> owners_;      ///< of the rows here, other ranks
    std::vector<std::size_t> leaving_;   ///< own grains with these homes, in the order of the messages
    std::vector<std::size_t> arriving_;  ///< rows here of other ranks' grains
    std::vector<std::size_t> staying_;   ///< own grains with their home here
    std::size_t firstStaying_ = 0;       ///< the row of the first of them; the others' follow
};

} // namespace nscd
