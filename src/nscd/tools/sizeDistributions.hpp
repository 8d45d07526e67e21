// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Distributions that diameters are drawn from, each cut off at a smallest and a largest one.
#pragma once

#include "nscd/tools/sceneParts.hpp"

namespace nscd
{

struct SizeDistribution
{
    double smallest;                                       ///< [m]
    double largest;                                        ///< [m]
    std::function<double(const RandomNumbers&)> draw;      ///< a diameter [m]
};

SizeDistribution oneSize(double diameter);

/// The same with all diameters multiplied by a factor.
SizeDistribution scaledSizes(const SizeDistribution& sizes, double factor);

/// Real grains that a parcel stands for whose diameter is `factor` times theirs: those of its volume, factor^3 spheres or factor^2 discs.
inline double grainsInParcel(double factor, int dimensions) { return dimensions == 2 ? factor*factor : factor*factor*factor; }

/// Equation: density ~ exp(-(d - mean)^2/(2 deviation^2)) between smallest and largest
/// Errors:   std::invalid_argument where fewer than one in a thousand lie between them
SizeDistribution normalSizes(double mean, double deviation, double smallest, double largest);

/// Equation: ln d is normal about ln median with deviation ln geometricDeviation (> 1)
/// Errors:   as normalSizes()
SizeDistribution logNormalSizes(double median, double geometricDeviation, double smallest, double largest);

/// Equation: share above d = exp(-(d/scale)^exponent) (Rosin and Rammler 1933), cut off at both ends
/// Errors:   as normalSizes()
SizeDistribution rosinRammlerSizes(double scale, double exponent, double smallest, double largest);

/// Density linear between rows (diameter, density of any unit), zero outside.
/// Errors: std::invalid_argument for fewer than two rows, diameters that do not increase, densities below zero or all zero
SizeDistribution tabulatedSizes(const std::vector<std::array<double, 2>>& rows);

/// From a distribution of mass over diameters, that of numbers: density ~ density of mass/d^dimensions, by rejection.
SizeDistribution numbersOfMasses(const SizeDistribution& masses, int dimensions);

} // namespace nscd
