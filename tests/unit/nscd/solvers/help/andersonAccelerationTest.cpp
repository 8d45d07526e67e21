// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing of a linear map: solved once there are as many differences as the map has factors.
#include "nscd/solvers/help/andersonAcceleration.hpp"

#include "nscd/kernels/sweepKernels.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace nscd;

namespace
{

using Impulses = AndersonAcceleration::Impulses;

constexpr std::size_t numbers = 3*blockLanes;
constexpr double factors[mixingDepth] = {0.9, 0.5, -0.4};

/// F(r) = A r + c, A diagonal with as many factors as a mixing keeps differences.
double image(std::size_t k, double r) { return factors[k % mixingDepth]*r + 1.0 + 0.1*static_cast<double>(k); }
double fixedPoint(std::size_t k) { return image(k, 0.0)/(1.0 - factors[k % mixingDepth]); }

/// One block that holds what the map made last.
struct LinearMap
{
    std::vector<ContactBlock> blocks = std::vector<ContactBlock>(1);
    Halo alone;
    AndersonAcceleration mixing{{nullptr, 1}, chooseKernels("auto").addDifferences, alone};
    Impulses r = Impulses(numbers, 0.0);

    LinearMap()
    {
        for (int lane = 0; lane < blockLanes; ++lane) blocks[0].invWn[lane] = 0.5 + lane;
    }

    void apply()
    {
        for (std::size_t k = 0; k < numbers; ++k) blocks[0].r[k/blockLanes][k % blockLanes] = image(k, r[k]);
    }

    void mix()
    {
        apply();
        mixing.mix(blocks, r);
    }

    double error() const
    {
        double largest = 0.0;
        for (std::size_t k = 0; k < numbers; ++k) largest = std::max(largest, std::abs(r[k] - fixedPoint(k))/fixedPoint(k));
        return largest;
    }
};

} // namespace

TEST(AndersonAcceleration, solvesALinearMapInOneMixingMoreThanItHasFactors)
{
    LinearMap map;
    for (int k = 0; k < mixingDepth; ++k) map.mix();
    EXPECT_GT(map.error(), 1e-2);
    map.mix();
    EXPECT_LT(map.error(), 1e-5);   // differences are kept in single precision
}

TEST(AndersonAcceleration, withoutAHistoryTheImageIsTheNextIterate)
{
    LinearMap map;
    for (int k = 0; k < 3; ++k)
    {
        map.apply();
        const ContactBlock held = map.blocks[0];
        map.mixing.mix(map.blocks, map.r);
        EXPECT_EQ(map.r, Impulses(&held.r[0][0], &held.r[0][0] + numbers));
        EXPECT_EQ(map.mixing.image(), map.r);
        map.mixing.forget();
    }
}

TEST(AndersonAcceleration, impulsesOfARangeAreGatheredInItsOrder)
{
    std::vector<ContactBlock> blocks(3);
    for (std::size_t k = 0; k < 3; ++k) blocks[k].r[1][4] = 10.0 + static_cast<double>(k);
    const std::vector<std::uint32_t> index = {2, 0};
    Impulses r;
    gatherImpulses(blocks, {index.data(), index.size()}, r);
    ASSERT_EQ(r.size(), 2*numbers);
    EXPECT_EQ(r[blockLanes + 4], 12.0);
    EXPECT_EQ(r[numbers + blockLanes + 4], 10.0);
}
