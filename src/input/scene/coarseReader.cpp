// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading coarse grains.
#include "input/scene/coarseReader.hpp"

#include <cmath>

namespace input
{

namespace
{

/// A parcel of more than 1e9 grains is a slip of the pen.
constexpr double largestFactor = 1000.0;

/// Numbers that are whole but for round-off count as whole.
constexpr double roundOff = 1e-12;

} // namespace

double readCoarseGraining(const CheckedEntries& given, const Surroundings& around, Scene& scene)
{
    if (!around.hasCoarseGrains || !given.found("coarseGraining")) return 1.0;
    scene.hasCoarseGrains = true;
    return given.number("coarseGraining", between(1.0, largestFactor));
}

std::int64_t bodiesOf(long realGrains, double coarseGraining, const Surroundings& around, const CheckedEntries& given, const std::string& keyword)
{
    if (coarseGraining == 1.0) return realGrains;
    const double inOne = nscd::grainsInParcel(coarseGraining, around.shape.dimensions);
    const double bodies = std::floor(double(realGrains)/inOne*(1.0 + roundOff));
    if (bodies < 1.0) given.reject(keyword, "is less than one parcel, by coarseGraining", textOf("at least ", inOne));
    return static_cast<std::int64_t>(bodies);
}

} // namespace input
