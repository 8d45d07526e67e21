// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The kernel of the Basset force, 1/sqrt(t), as a sum of exponentials: what has been is then known by a few numbers that only decay.
// Tested by tests/unit/closures/historyKernelTest.cpp
#pragma once

#include <array>

namespace closures
{

/// Terms w exp(-r t) of the sum.
constexpr int historyTerms = 25;

struct HistoryTerm
{
    double rate;     ///< r [1/s]
    double weight;   ///< w [1/sqrt(s)]
};

/// 1/sqrt(t) = 1/sqrt(pi) int r^(-1/2) exp(-r t) dr by the trapezoidal rule in ln r, two points a decade from 1e-5 to 1e7/s; all slower
/// rates are in the first point's weight.
/// Range:    within 0.3 % for 2e-6 s <= t <= 100 s. Shorter times than that count for too little, as do longer ones.
const std::array<HistoryTerm, historyTerms>& historyKernel();

/// (1 - exp(-x))/x: mean of exp(-x s) over 0 <= s <= 1.
double meanDecay(double x);

/// Basset's coefficient C of C int ds/dtau/sqrt(t - tau) dtau on a sphere [N sqrt(s)/(m/s)], s its slip.
/// Equation: C = 3/2 d^2 sqrt(pi rho mu) (Basset 1888, A treatise on hydrodynamics 2, ch. 22), for Re << 1
double bassetCoefficient(double diameter, double density, double viscosity);

} // namespace closures
