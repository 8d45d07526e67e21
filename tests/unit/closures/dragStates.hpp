// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// States to evaluate drag laws at, for their tests.
#pragma once

#include "closures/dragLaws.hpp"

#include <cmath>
#include <string>

namespace dragStates
{

using closures::DragLawRow;
using closures::DragState;
using closures::sphereSize;

inline const double pi = std::acos(-1.0);

inline double gammaOf(const std::string& law, const DragState& state)
{
    return closures::findDragLaw(law).law(state);
}

/// A 1 mm sphere in a fluid of 1000 kg/m3 and 1 mPa s, whose slip gives this Reynolds number of the interstitial slip.
inline DragState stateAt(double Re, double alpha)
{
    return {sphereSize(1e-3), Re*1e-3, alpha, 1000, 1e-3};
}

/// gamma/(3 pi mu d) in that state.
inline double relativeToStokes(const DragLawRow& row, double Re, double alpha)
{
    return row.law(stateAt(Re, alpha))/(3*pi*1e-3*1e-3);
}

} // namespace dragStates
