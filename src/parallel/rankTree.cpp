// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Halving of the ranks.
#include "parallel/rankTree.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

std::vector<int> partnersOf(int rank, int size, int lowSize)
{
    if (rank < lowSize) return {std::min(lowSize + rank, size - 1)};
    const int low = rank - lowSize;
    const bool hasSecond = rank == size - 1 && low + 1 < lowSize;
    return hasSecond ? std::vector<int>{low, low + 1} : std::vector<int>{low};
}

RankLevel levelOf(Communicator group)
{
    const int lowSize = (group.size() + 1)/2;
    std::vector<int> partners = partnersOf(group.rank(), group.size(), lowSize);
    return {std::move(group), lowSize, std::move(partners)};
}

} // namespace

RankTree::RankTree(Communicator all)
:
    all_(std::move(all))
{
    Communicator group = all_.split(0);
    while (group.size() > 1)
    {
        const RankLevel& level = levels_.emplace_back(levelOf(std::move(group)));
        group = level.group.split(level.isLow() ? 0 : 1);
    }
}

} // namespace nscd
