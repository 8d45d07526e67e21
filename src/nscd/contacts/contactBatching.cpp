// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Greedy batching with one bit per open block and body.
#include "nscd/contacts/contactBatching.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr std::size_t windowSize = 512;
constexpr int blocksPerWindow = 64;  // bits of the masks

/// Which open blocks of the present window hold a body, reset lazily by window number.
class OpenBlocks
{
public:
    explicit OpenBlocks(int bodies)
    :
        bodies_(bodies, {0, -1})
    {}

    std::uint64_t of(int body, int window) const { return bodies_[body].window == window ? bodies_[body].blocks : 0; }

    void add(int body, int window, int block) { bodies_[body] = {of(body, window) | std::uint64_t(1) << block, window}; }

private:
    struct InWindow
    {
        std::uint64_t blocks;
        int window;
    };
    std::vector<InWindow> bodies_;
};

} // namespace

ContactBlock emptyBlock(int staticBody)
{
    ContactBlock block{};
    std::fill(block.a, block.a + blockLanes, staticBody);
    std::fill(block.b, block.b + blockLanes, staticBody);
    return block;
}

Batches batchContacts(const std::vector<Candidate>& candidates, const std::vector<std::uint32_t>& order, int staticBody)
{
    Batches batches;
    batches.slotOf.resize(candidates.size());
    OpenBlocks open(staticBody + 1);

    std::size_t begin = 0;
    for (int window = 0; begin < candidates.size(); ++window)
    {
        const std::size_t end = std::min(begin + windowSize, candidates.size());
        std::uint64_t full = 0;
        int used = 0;
        std::array<int, blocksPerWindow> filled{};
        std::size_t k = begin;
        for (; k < end; ++k)
        {
            const Candidate& c = candidates[order[k]];
            const std::uint64_t blocked = full | open.of(c.a, window) | (c.b == staticBody ? 0 : open.of(c.b, window));
            // A body with more than 64 candidates in a window ends the window early.
            if (~blocked == 0) break;
            const int block = __builtin_ctzll(~blocked);
            batches.slotOf[order[k]] = static_cast<std::uint32_t>((batches.blocks + block)*blockLanes + filled[block]);
            if (++filled[block] == blockLanes) full |= std::uint64_t(1) << block;
            used = std::max(used, block + 1);
            open.add(c.a, window, block);
            if (c.b != staticBody) open.add(c.b, window, block);
        }
        batches.blocks += used;
        begin = k;
    }
    return batches;
}

} // namespace nscd
