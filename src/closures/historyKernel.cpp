// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Points and weights of the sum.
#include "closures/historyKernel.hpp"

#include <cmath>

namespace closures
{

namespace
{

constexpr double pi = 3.14159265358979323846;

std::array<HistoryTerm, historyTerms> makeKernel()
{
    constexpr double slowest = 1e-5;
    const double step = std::log(10.0)/2.0, factor = std::sqrt(10.0);
    std::array<HistoryTerm, historyTerms> terms;
    double rate = slowest;
    for (HistoryTerm& term : terms)
    {
        term = {rate, step*std::sqrt(rate/pi)};
        rate *= factor;
    }
    // The rule's points below the first one, all as slow as that: a geometric series.
    terms.front().weight /= 1.0 - 1.0/std::sqrt(factor);
    return terms;
}

} // namespace

const std::array<HistoryTerm, historyTerms>& historyKernel()
{
    static const std::array<HistoryTerm, historyTerms> terms = makeKernel();
    return terms;
}

double meanDecay(double x) { return x > 0.0 ? -std::expm1(-x)/x : 1.0; }

double bassetCoefficient(double diameter, double density, double viscosity)
{
    return 1.5*diameter*diameter*std::sqrt(pi*density*viscosity);
}

} // namespace closures
