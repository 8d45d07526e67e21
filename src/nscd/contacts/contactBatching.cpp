// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Greedy batching with one bit per open block and body; what finds no room in a window goes first in the next one.
#include "nscd/contacts/contactBatching.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int blocksPerWindow = 64;   // bits of the masks
constexpr std::size_t mostWaiting = 512;

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

/// One window of blocks: each candidate goes into the first open block without its bodies.
class Window
{
public:
    Window(OpenBlocks& open, int number) : open_(open), number_(number) {}

    /// The lane among those of the window; -1 if each open block has a body of the candidate.
    int place(const Candidate& c, int staticBody)
    {
        const std::uint64_t blocked = full_ | open_.of(c.a, number_) | (c.b == staticBody ? 0 : open_.of(c.b, number_));
        if (~blocked == 0) return -1;
        const int block = __builtin_ctzll(~blocked), lane = block*blockLanes + filled_[block];
        if (++filled_[block] == blockLanes) full_ |= std::uint64_t(1) << block;
        used_ = std::max(used_, block + 1);
        open_.add(c.a, number_, block);
        if (c.b != staticBody) open_.add(c.b, number_, block);
        return lane;
    }

    bool isFull() const { return ~full_ == 0; }
    int used() const { return used_; }

private:
    OpenBlocks& open_;
    int number_;
    std::uint64_t full_ = 0;
    int used_ = 0;
    std::array<int, blocksPerWindow> filled_{};
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
    std::vector<std::uint32_t> waiting, stillWaiting;
    auto next = order.begin();
    for (int number = 0; next != order.end() || !waiting.empty(); ++number)
    {
        Window window(open, number);
        const auto place = [&](std::uint32_t k)
        {
            const int lane = window.isFull() ? -1 : window.place(candidates[k], staticBody);
            if (lane < 0) stillWaiting.push_back(k);
            else batches.slotOf[k] = static_cast<std::uint32_t>(batches.blocks*blockLanes + lane);
        };
        for (std::uint32_t k : waiting) place(k);
        while (next != order.end() && !window.isFull() && stillWaiting.size() < mostWaiting) place(*next++);
        batches.blocks += window.used();
        waiting.swap(stillWaiting);
        stillWaiting.clear();
    }
    return batches;
}

} // namespace nscd
