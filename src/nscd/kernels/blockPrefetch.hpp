// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Asks for what a pass over blocks will come to. In an anonymous namespace, as laneBodies.hpp is.
// Tested by tests/unit/nscd/kernels/sweepKernelsTest.cpp
#pragma once

#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{
namespace
{

/// Blocks and bodies that a pass will come to are asked for this many blocks ahead: without, a pass over more than the caches hold
/// takes twice as long.
constexpr std::size_t blocksAhead = 12, bodiesAhead = 6;

/// Always inlined: GCC takes a function that does nothing but prefetch for one that does nothing, and drops its calls.
__attribute__((always_inline)) inline void prefetch(const Body* bodies, const ContactBlock* blocks, BlockRange range, std::size_t k)
{
    if (k + blocksAhead < range.count)
    {
        const char* lines = reinterpret_cast<const char*>(&blocks[range[k + blocksAhead]]);
        for (std::size_t line = 0; line < sizeof(ContactBlock); line += 64) __builtin_prefetch(lines + line);
    }
    if (k + bodiesAhead < range.count)
    {
        const ContactBlock& block = blocks[range[k + bodiesAhead]];
        for (int l = 0; l < blockLanes; ++l) __builtin_prefetch(bodies + block.b[l]);
    }
}

} // namespace
} // namespace nscd
