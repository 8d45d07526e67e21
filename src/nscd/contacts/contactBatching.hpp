// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packs candidates into blocks whose lanes share no movable body.
#pragma once

#include "nscd/kernels/contactBlock.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace nscd
{

/// A candidate contact of body a with body b, or with a wall region (b is then the static body).
struct Candidate
{
    int a;
    int b;
    int wall;                          ///< wall region, or -1
    std::array<signed char, 3> image;
};

struct Batches
{
    std::size_t blocks = 0;
    std::vector<std::uint32_t> slotOf;   ///< slot of each candidate
};

/// A block whose lanes all join the static body to itself.
ContactBlock emptyBlock(int staticBody);

/// Greedy within windows of 512 candidates, so that the spatial order, and with it convergence and cache use, stays. `order`: the
/// candidates in the order they are packed.
/// Ensures: no body but the static one appears twice in a block; every candidate has one slot
Batches batchContacts(const std::vector<Candidate>& candidates, const std::vector<std::uint32_t>& order, int staticBody);

} // namespace nscd
