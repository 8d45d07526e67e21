// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws of packed beds, which have the bed's pressure gradient per volume, and what joins them to laws of dilute ones.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include "closures/drag/hinderedDrag.hpp"

namespace closures
{
namespace drag
{

/// Equation: n gamma = 150 phi^2 mu/(alpha d^2) + 1.75 phi rho |u - v|/d (Ergun 1952)
/// Range:    packed beds, Re_s/phi < 2500; its viscous part vanishes with phi
inline double ergun(const DragState& s)
{
    const double d = s.size.diameter, phi = 1 - s.fluidFraction;
    return s.size.volume*(150*phi*s.viscosity/(s.fluidFraction*d*d) + 1.75*s.density*s.slip/d);
}

/// Below this fluid fraction Gidaspow's law is Ergun's.
constexpr double gidaspowSwitch = 0.8;

/// Equation: Ergun below alpha = 0.8, Wen and Yu from there on (Gidaspow 1994)
/// Range:    all alpha. It jumps at 0.8, as published: Ergun is 15 % above Wen-Yu at Re_s -> 0 and 3.75 times Wen-Yu at Re_s 1000.
inline double gidaspow(const DragState& s)
{
    return s.fluidFraction < gidaspowSwitch ? ergun(s) : wenYu(s);
}

/// Equation: psi Wen-Yu + (1 - psi) Ergun, psi = atan(150 1.75 (alpha - 0.8))/pi + 1/2 (Huilin & Gidaspow 2003)
/// Range:    all alpha; psi goes from 0.1 to 0.9 between alpha 0.788 and 0.812, and 0.6 % of Ergun is left at alpha 1
inline double gidaspowSmooth(const DragState& s)
{
    const double psi = std::atan(150*1.75*(s.fluidFraction - gidaspowSwitch))/pi + 0.5;
    return psi*wenYu(s) + (1 - psi)*ergun(s);
}

/// Equation: n gamma = A phi^2 mu/(alpha d^2) + B phi rho |u - v|/d, Ergun's with A = 26.8 alpha^3/(phi^(2/3) (1 - phi^(1/3))
///           (1 - phi^(2/3))^2), B = alpha^2/(1 - phi^(2/3))^2 (Du Plessis & Masliyah 1988; of a cell model of isotropic packings)
/// Range:    A phi and so the viscous part vanish with phi: warned of above alpha 0.9
inline double plessisMasliyah(const DragState& s)
{
    const double alpha = s.fluidFraction, phi = solidFraction(s);
    const double third = std::cbrt(phi), inertial = alpha/(1 - third*third);
    // A phi/alpha, without 0/0 at phi = 0.
    const double viscous = 26.8*third*inertial*inertial/(1 - third), d = s.size.diameter;
    return s.size.volume*(viscous*s.viscosity/(d*d) + inertial*inertial*s.density*s.slip/d);
}

} // namespace drag
} // namespace closures
