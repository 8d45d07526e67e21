// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Interleaved cell indices as keys, sorted by radix.
#include "nscd/base/mortonOrder.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace nscd
{

namespace
{

std::uint64_t spreadBits(std::uint64_t x)
{
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffffULL;
    x = (x | x << 16) & 0x1f0000ff0000ffULL;
    x = (x | x << 8) & 0x100f00f00f00f00fULL;
    x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
    return (x | x << 2) & 0x1249249249249249ULL;
}

/// Stable radix sort of indices by key.
void radixSort(std::vector<std::uint64_t>& keys, std::vector<int>& order)
{
    const std::uint64_t largest = keys.empty() ? 0 : *std::max_element(keys.begin(), keys.end());
    std::vector<std::uint64_t> keysOut(keys.size());
    std::vector<int> orderOut(order.size());
    for (int bit = 0; bit < 63 && (largest >> bit) != 0; bit += 11)
    {
        std::array<std::size_t, 2049> start{};
        for (std::uint64_t key : keys) ++start[((key >> bit) & 2047) + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (std::size_t m = 0; m < keys.size(); ++m)
        {
            const std::size_t place = start[(keys[m] >> bit) & 2047]++;
            keysOut[place] = keys[m];
            orderOut[place] = order[m];
        }
        keys.swap(keysOut);
        order.swap(orderOut);
    }
}

} // namespace

std::vector<int> mortonOrder(const std::vector<Vec3>& position, double cellSize)
{
    Eigen::AlignedBox3d extent;
    for (const Vec3& x : position) extent.extend(x);
    // 21 bits an axis; coarser cells where the scene is larger than that.
    const double width = std::max(cellSize, position.empty() ? 0.0 : extent.sizes().maxCoeff()/2.0e6);

    std::vector<std::uint64_t> keys(position.size());
    std::vector<int> order(position.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = 0; i < position.size(); ++i)
    {
        const Vec3 scaled = (position[i] - extent.min())/width;
        keys[i] = spreadBits(static_cast<std::uint64_t>(scaled[0])) | spreadBits(static_cast<std::uint64_t>(scaled[1])) << 1
            | spreadBits(static_cast<std::uint64_t>(scaled[2])) << 2;
    }
    radixSort(keys, order);
    return order;
}

} // namespace nscd
