// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Comparing and describing units and ranges.
#include "input/dictionary/quantity.hpp"

#include <array>
#include <cmath>

namespace input
{

std::string Unit::describe() const
{
    return textOf("[", kg, " ", m, " ", s, " ", K, " 0 0 0]");
}

bool Unit::isSaidBy(const std::vector<Token>& exponents) const
{
    if (exponents.size() != 5 && exponents.size() != 7) return false;
    const std::array<int, 7> own = {kg, m, s, K, 0, 0, 0};
    for (std::size_t k = 0; k < exponents.size(); ++k)
    {
        if (!exponents[k].isNumber() || exponents[k].number != own[k]) return false;
    }
    return true;
}

bool Range::contains(double value) const
{
    return (includesLower ? value >= lower : value > lower) && (includesUpper ? value <= upper : value < upper);
}

std::string Range::describe() const
{
    std::string text = "a finite number";
    if (std::isfinite(lower)) text += textOf(includesLower ? " >= " : " > ", lower);
    if (std::isfinite(lower) && std::isfinite(upper)) text += " and";
    if (std::isfinite(upper)) text += textOf(includesUpper ? " <= " : " < ", upper);
    return text;
}

} // namespace input
