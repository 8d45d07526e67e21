// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws that do not see alpha: for single grains and dilute clouds.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include "closures/drag/dragState.hpp"

namespace closures
{
namespace drag
{

/// Equation: Cd = 24/Re (Stokes 1851)
/// Range:    Re < 0.1, where inertia adds 2 %
inline double stokes(const DragState& s)
{
    return timesStokes(s, 1);
}

/// Equation: Cd = 24/Re (1 + 0.15 Re^0.687), 0.44 from Re 1000 on (Schiller & Naumann 1933); drops by 0.4 % there
/// Range:    Re < 2e5, where the drag of a sphere falls
inline double schillerNaumann(const DragState& s)
{
    return loneGrain(s, schillerNaumannCdRe(slipRe(s)));
}

/// Equation: Cd = (0.63 + 4.8/sqrt(Re))^2 (DallaValle 1948)
/// Range:    Re < 2e5; 4 % below Stokes as Re -> 0
inline double dallaValle(const DragState& s)
{
    return loneGrain(s, dallaValleCdRe(slipRe(s)));
}

} // namespace drag
} // namespace closures
