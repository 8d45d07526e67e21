// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packs candidates into blocks whose lanes share no movable body.
#pragma once

#include "contactBlock.hpp"

#include <array>
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
    std::vector<std::size_t> slotOf;   ///< slot of each candidate
};

/// Greedy within windows of 256 candidates, so that the spatial order, and with it convergence and cache use, stays.
/// Ensures: no body but the static one appears twice in a block; every candidate has one slot
Batches batchContacts(const std::vector<Candidate>& candidates, int staticBody);

} // namespace nscd
