// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The ranks halved again and again, so that what is for any of them finds its way in log2(size) hops.
#pragma once

#include "parallel/communicator.hpp"

namespace nscd
{

/// A group of successive ranks that this one is in, and its two halves; the low half may have one rank more.
struct RankLevel
{
    Communicator group;
    int lowSize;  ///< ranks 0 .. lowSize - 1 of the group are its low half

    /// Ranks of the group in the other half: the first gets what goes there. Two for the last of the high half if the low one is
    /// larger. Low rank i and high rank min(i, highSize - 1) are partners of each other.
    std::vector<int> partners;

    bool isLow() const { return group.rank() < lowSize; }
};

/// The groups of this rank, from all ranks down to a pair; none for one rank alone.
/// Cost: set-up splits communicators, at which MPI itself keeps a table of a group's ranks; after that O(log size).
class RankTree
{
public:
    explicit RankTree(Communicator all);

    const Communicator& all() const { return all_; }
    const std::vector<RankLevel>& levels() const { return levels_; }

private:
    Communicator all_;
    std::vector<RankLevel> levels_;
};

/// Sends values to the other half, each to one rank of it. Returns those that come from there.
template<class T>
std::vector<T> sendAcross(const RankLevel& level, const std::vector<T>& values)
{
    std::vector<Message> messages;
    for (int partner : level.partners) messages.push_back({partner, {}});
    pack(values.data(), values.size(), messages.front().bytes);
    return valuesOf<T>(level.group.swap(messages));
}

/// Tells a value to the other half, where all ranks of this half tell the same. Returns that half's.
template<class T>
T tellAcross(const RankLevel& level, const T& value)
{
    std::vector<Message> messages;
    for (int partner : level.partners) pack(&value, 1, messages.emplace_back(Message{partner, {}}).bytes);
    return valuesOf<T>(level.group.swap(messages)).front();
}

} // namespace nscd
