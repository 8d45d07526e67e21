// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Who owns the grain of an identity: for the few moments, as a restart, when nobody near knows.
#pragma once

#include "parallel/communicator.hpp"

#include <unordered_map>

namespace nscd
{

/// Each rank keeps the entries of the identities that are its rank modulo their number. All functions are collective.
/// Cost: building and asking send a message to any rank, up to all of them: not for the time step.
class IdDirectory
{
public:
    /// `owned`: the identities of this rank's grains. `all` must live as long as this.
    IdDirectory(const Communicator& all, const std::vector<std::int64_t>& owned);

    /// Owner of each identity, -1 where there is none.
    std::vector<int> owners(const std::vector<std::int64_t>& ids) const;

    /// Number of identities, on all ranks, that have more than one owner.
    std::int64_t duplicates() const { return duplicates_; }

private:
    int keeper(std::int64_t id) const;

    const Communicator& all_;
    std::unordered_map<std::int64_t, int> owner_;
    std::int64_t duplicates_ = 0;
};

} // namespace nscd
