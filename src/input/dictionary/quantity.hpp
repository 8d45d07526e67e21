// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Units of numbers, and the numbers a value may have.
#pragma once

#include "input/dictionary/dictionary.hpp"

#include <limits>

namespace input
{

/// Exponents of kg, m, s and K, in which a number counts whether its dictionary says so or not.
struct Unit
{
    int kg = 0;
    int m = 0;
    int s = 0;
    int K = 0;

    /// As OpenFOAM writes it, [1 -3 0 0 0 0 0].
    std::string describe() const;
    /// Whether tokens between square brackets are these exponents, five or seven of them.
    bool isSaidBy(const std::vector<Token>& exponents) const;
};

namespace unit
{

inline constexpr Unit one{0, 0, 0};
inline constexpr Unit time{0, 0, 1};
inline constexpr Unit rate{0, 0, -1};
inline constexpr Unit length{0, 1, 0};
inline constexpr Unit velocity{0, 1, -1};
inline constexpr Unit acceleration{0, 1, -2};
inline constexpr Unit viscosity{0, 2, -1};
inline constexpr Unit dynamicViscosity{1, -1, -1};
inline constexpr Unit density{1, -3, 0};
inline constexpr Unit force{1, 1, -2};
inline constexpr Unit mass{1, 0, 0};
inline constexpr Unit pressure{1, -1, -2};
inline constexpr Unit temperature{0, 0, 0, 1};
inline constexpr Unit perTemperature{0, 0, 0, -1};
inline constexpr Unit heatCapacity{0, 2, -2, -1};     ///< J/(kg K)
inline constexpr Unit conductivity{1, 1, -3, -1};     ///< W/(m K)

} // namespace unit

/// Numbers beyond these cannot be squared and cubed as masses and energies are: products of several of them overflow, quotients divide by 0.
constexpr double largestNumber = 1e30;
constexpr double smallestPositive = 1e-30;

/// Faster ones no wall makes, and integrals over them take ages [1/s].
constexpr double highestFrequency = 2e4;

/// The numbers a value may have.
struct Range
{
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool includesLower = true;
    bool includesUpper = true;
    Unit unit = unit::one;

    bool contains(double value) const;
    std::string describe() const;
};

inline Range anyNumber(const Unit& unit = unit::one)
{
    Range range;
    range.unit = unit;
    return range;
}

inline Range atLeast(double lower, const Unit& unit = unit::one)
{
    Range range = anyNumber(unit);
    range.lower = lower;
    return range;
}

inline Range above(double lower, const Unit& unit = unit::one)
{
    Range range = atLeast(lower, unit);
    range.includesLower = false;
    return range;
}

inline Range between(double lower, double upper, const Unit& unit = unit::one)
{
    Range range = atLeast(lower, unit);
    range.upper = upper;
    return range;
}

/// Without its ends.
inline Range within(double lower, double upper)
{
    Range range = between(lower, upper);
    range.includesLower = range.includesUpper = false;
    return range;
}

} // namespace input
