// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Distributions of sizes against their formulas (Kolmogorov and Smirnov), and numbers that add up to a distribution of mass.
#include "nscd/tools/sizeDistributions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int draws = 20000;

std::vector<double> sorted(const nscd::SizeDistribution& sizes)
{
    const nscd::RandomNumbers random = nscd::randomNumbers(5);
    std::vector<double> d;
    for (int k = 0; k < draws; ++k) d.push_back(sizes.draw(random));
    std::sort(d.begin(), d.end());
    return d;
}

/// The largest distance of drawn and wanted shares, each size weighted by its power, cut off as the sizes are.
double distance(const nscd::SizeDistribution& sizes, const std::function<double(double)>& shareBelow, int power = 0)
{
    const std::vector<double> d = sorted(sizes);
    double sum = 0.0, below = 0.0, worst = 0.0;
    for (const double one : d) sum += std::pow(one, power);
    const double first = shareBelow(sizes.smallest), all = shareBelow(sizes.largest) - first;
    for (const double one : d)
    {
        below += std::pow(one, power)/sum;
        worst = std::max(worst, std::abs(below - (shareBelow(one) - first)/all));
    }
    return worst;
}

/// That one set of draws in a thousand exceeds.
const double limit = 1.95/std::sqrt(draws);

double normalBelow(double z) { return 0.5*std::erfc(-z/std::sqrt(2.0)); }

} // namespace

TEST(SizeDistributions, followTheirFormulas)
{
    EXPECT_LT(distance(nscd::normalSizes(2, 0.5, 1.6, 4), [](double d) { return normalBelow((d - 2)/0.5); }), limit);
    EXPECT_LT(distance(nscd::logNormalSizes(2, 1.5, 1, 5), [](double d) { return normalBelow(std::log(d/2)/std::log(1.5)); }), limit);
    EXPECT_LT(distance(nscd::rosinRammlerSizes(2, 3, 0.5, 4), [](double d) { return -std::exp(-std::pow(d/2, 3)); }), limit);
    EXPECT_LT(distance(nscd::tabulatedSizes({{1, 1}, {3, 1}}), [](double d) { return d; }), limit);
    // Up from 0 to 1, flat, down to 0: triangle, rectangle, triangle.
    const auto trapezoid = [](double d) { return d < 2 ? 0.5*(d - 1)*(d - 1) : d < 3 ? 0.5 + d - 2 : 2.0 - 0.5*(4 - d)*(4 - d); };
    EXPECT_LT(distance(nscd::tabulatedSizes({{1, 0}, {2, 1}, {3, 1}, {4, 0}}), trapezoid), limit);
}

/// The comparison above can fail: by 2 % of the mean.
TEST(SizeDistributions, areToldApart)
{
    EXPECT_GT(distance(nscd::normalSizes(2.04, 0.5, 1.6, 4), [](double d) { return normalBelow((d - 2)/0.5); }), limit);
}

TEST(SizeDistributions, byMassHaveThatShareOfMassBelowEachSize)
{
    for (const int dimensions : {2, 3})
    {
        const nscd::SizeDistribution numbers = nscd::numbersOfMasses(nscd::tabulatedSizes({{1, 1}, {3, 1}}), dimensions);
        // Weights up to 27 make the scatter of 20000 draws that of a few thousand.
        EXPECT_LT(distance(numbers, [](double d) { return d; }, dimensions), 3*limit) << dimensions;
        EXPECT_GT(distance(numbers, [](double d) { return d; }), 0.2) << dimensions;
    }
}

TEST(SizeDistributions, keepToTheirEnds)
{
    EXPECT_EQ(sorted(nscd::oneSize(0.3)).front(), 0.3);
    for (const nscd::SizeDistribution& sizes : {nscd::normalSizes(2, 1, 1.5, 2), nscd::rosinRammlerSizes(2, 3, 1.5, 2), nscd::tabulatedSizes({{1.5, 0}, {2, 0.1}})})
    {
        const std::vector<double> d = sorted(sizes);
        EXPECT_GE(d.front(), 1.5);
        EXPECT_LE(d.back(), 2.0);
    }
}

TEST(SizeDistributions, refuseWhatCannotBeDrawn)
{
    EXPECT_THROW(nscd::normalSizes(2, 0.1, 3, 4), std::invalid_argument);
    EXPECT_THROW(nscd::logNormalSizes(2, 1.1, 3, 4), std::invalid_argument);
    EXPECT_THROW(nscd::rosinRammlerSizes(1, 3, 3, 4), std::invalid_argument);
    EXPECT_THROW(nscd::tabulatedSizes({{1, 1}}), std::invalid_argument);
    EXPECT_THROW(nscd::tabulatedSizes({{1, 1}, {1, 1}}), std::invalid_argument);
    EXPECT_THROW(nscd::tabulatedSizes({{1, 0}, {2, 0}}), std::invalid_argument);
    EXPECT_THROW(nscd::tabulatedSizes({{1, 1}, {2, -1}}), std::invalid_argument);
}

TEST(SizeDistributions, areScaledAsAWhole)
{
    const nscd::SizeDistribution sizes = nscd::normalSizes(2.0, 0.3, 1.5, 2.6), scaled = nscd::scaledSizes(sizes, 3.0);
    EXPECT_EQ(scaled.smallest, 4.5);
    EXPECT_DOUBLE_EQ(scaled.largest, 7.8);
    const std::vector<double> one = sorted(sizes), three = sorted(scaled);
    for (std::size_t k = 0; k < one.size(); k += 1000) EXPECT_DOUBLE_EQ(three[k], 3.0*one[k]);
    EXPECT_EQ(nscd::grainsInParcel(5.0, 3), 125.0);
    EXPECT_EQ(nscd::grainsInParcel(5.0, 2), 25.0);
}
