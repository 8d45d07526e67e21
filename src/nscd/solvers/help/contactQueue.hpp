// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The queue of Henry 2025, section 2.3: a contact is solved again only after something near it changed.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

#include <cstdint>
#include <vector>

namespace nscd
{

/// Visits contacts one by one from a queue; neighbors of a contact that changed join it.
class ContactQueue
{
public:
    /// Of the contacts in a range of blocks.
    ContactQueue(ContactProblem& problem, BlockRange range);

    /// Contacts whose velocity defect exceeds the threshold [m/s].
    std::vector<std::uint32_t> defective(double threshold) const;

    /// Works the queue off, starting from `seeds`: a change of u by less than `threshold` [m/s] is not kept (Henry's revert).
    /// Returns the visits made, at most `maxVisits`.
    /// Errors: std::runtime_error for a velocity that is not finite
    std::size_t work(const std::vector<std::uint32_t>& seeds, double threshold, std::size_t maxVisits);

    /// Contacts there are.
    const std::vector<std::uint32_t>& slots() const { return used_; }

private:
    void groupByBody();

    ContactProblem& problem_;
    std::vector<std::uint32_t> blocks_;
    std::vector<std::uint32_t> used_;     ///< slots
    std::vector<std::uint32_t> start_;    ///< per body, into slotsOfBody_
    std::vector<std::uint32_t> slotsOfBody_;
};

} // namespace nscd
