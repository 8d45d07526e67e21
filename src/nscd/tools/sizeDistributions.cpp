// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The distributions.
#include "nscd/tools/sizeDistributions.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr double leastShare = 1e-3;   // of a distribution between its ends: rejection takes as many numbers as its inverse

void checkShare(double share)
{
    if (!(share >= leastShare)) throw invalidValue("share of a distribution between its smallest and largest size", share, "0.001 or more");
}

/// Box and Muller (1958).
double standardNormal(const RandomNumbers& random)
{
    const double radius = std::sqrt(-2.0*std::log1p(-random()));
    return radius*std::cos(2.0*M_PI*random());
}

double normalShare(double lower, double upper) { return 0.5*(std::erf(upper/std::sqrt(2.0)) - std::erf(lower/std::sqrt(2.0))); }

/// Draws until a value lies between the ends.
SizeDistribution cutOff(double smallest, double largest, const std::function<double(double)>& sizeOfNormal)
{
    return {smallest, largest, [=](const RandomNumbers& random)
    {
        double d = sizeOfNormal(standardNormal(random));
        while (!(d >= smallest && d <= largest)) d = sizeOfNormal(standardNormal(random));
        return d;
    }};
}

void checkRows(const std::vector<std::array<double, 2>>& rows)
{
    if (rows.size() < 2) throw invalidValue("rows of a table of sizes", rows.size(), "2 or more");
    double sum = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        if (k > 0 && !(rows[k][0] > rows[k - 1][0])) throw invalidValue("diameter in a table of sizes", rows[k][0], "more than the one before");
        if (!(rows[k][1] >= 0.0)) throw invalidValue("density in a table of sizes", rows[k][1], ">= 0");
        sum += rows[k][1];
    }
    if (!(sum > 0.0)) throw invalidValue("densities in a table of sizes", "all zero", "some above zero");
}

/// Where the integral of a density that goes from `left` to `right` over a width reaches `area`.
double distanceOf(double area, double left, double right, double width)
{
    const double root = std::sqrt(std::max(0.0, left*left + 2.0*area*(right - left)/width));
    return left + root > 0.0 ? std::min(width, 2.0*area/(left + root)) : 0.0;
}

} // namespace

SizeDistribution oneSize(double diameter)
{
    return {diameter, diameter, [diameter](const RandomNumbers&) { return diameter; }};
}

SizeDistribution scaledSizes(const SizeDistribution& sizes, double factor)
{
    return {factor*sizes.smallest, factor*sizes.largest, [=](const RandomNumbers& random) { return factor*sizes.draw(random); }};
}

SizeDistribution normalSizes(double mean, double deviation, double smallest, double largest)
{
    checkShare(normalShare((smallest - mean)/deviation, (largest - mean)/deviation));
    return cutOff(smallest, largest, [=](double z) { return mean + deviation*z; });
}

SizeDistribution logNormalSizes(double median, double geometricDeviation, double smallest, double largest)
{
    const double deviation = std::log(geometricDeviation);
    checkShare(normalShare(std::log(smallest/median)/deviation, std::log(largest/median)/deviation));
    return cutOff(smallest, largest, [=](double z) { return median*std::exp(deviation*z); });
}

SizeDistribution rosinRammlerSizes(double scale, double exponent, double smallest, double largest)
{
    const double low = std::exp(-std::pow(smallest/scale, exponent)), high = std::exp(-std::pow(largest/scale, exponent));
    checkShare(low - high);
    return {smallest, largest, [=](const RandomNumbers& random)
    {
        const double above = low - random()*(low - high);
        return std::clamp(scale*std::pow(-std::log(above), 1.0/exponent), smallest, largest);
    }};
}

SizeDistribution tabulatedSizes(const std::vector<std::array<double, 2>>& rows)
{
    checkRows(rows);
    std::vector<double> below = {0.0};
    for (std::size_t k = 1; k < rows.size(); ++k) below.push_back(below.back() + 0.5*(rows[k][1] + rows[k - 1][1])*(rows[k][0] - rows[k - 1][0]));
    return {rows.front()[0], rows.back()[0], [rows, below](const RandomNumbers& random)
    {
        const double area = random()*below.back();
        const std::size_t next = std::upper_bound(below.begin(), below.end() - 1, area) - below.begin();
        const auto& left = rows[next - 1];
        const auto& right = rows[next];
        return left[0] + distanceOf(area - below[next - 1], left[1], right[1], right[0] - left[0]);
    }};
}

SizeDistribution numbersOfMasses(const SizeDistribution& masses, int dimensions)
{
    return {masses.smallest, masses.largest, [=](const RandomNumbers& random)
    {
        double d = masses.draw(random);
        while (random() > std::pow(masses.smallest/d, dimensions)) d = masses.draw(random);
        return d;
    }};
}

} // namespace nscd
