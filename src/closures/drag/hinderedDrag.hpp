// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws that multiply the drag of a lone grain in the superficial slip by a power of alpha, and that of Syamlal and O'Brien, which
// divides the slip by what a suspension settles at.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include "closures/drag/dragState.hpp"

namespace closures
{
namespace drag
{

/// exp(-(1.5 - log10 Re)^2/2): how far between viscous and inertial drag, 1 at Re 32.
inline double midwayRe(double Re)
{
    // Below 1e-39 there; log10(0) would trip a run that traps floating-point errors.
    if (Re < 1e-12) return 0;
    const double x = 1.5 - std::log10(Re);
    return std::exp(-0.5*x*x);
}

/// beta = 3.7 - 0.65 exp(-(1.5 - log10 Re_s)^2/2) (Di Felice 1994)
inline double diFeliceExponent(double Re)
{
    return 3.7 - 0.65*midwayRe(Re);
}

/// Equation: Cd = 24/Re_s, beta = 3.8 (Stokes 1851 times alpha^-2.8)
/// Range:    Re_s < 0.1
inline double stokesHindered(const DragState& s)
{
    return hindered(s, stokesCdRe, 3.8);
}

/// Equation: Cd of DallaValle at Re_s, beta = 3.7 - 0.65 exp(-(1.5 - log10 Re_s)^2/2) (Di Felice 1994)
/// Range:    all alpha, Re_s < 1e4
inline double diFelice(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, dallaValleCdRe(Re), diFeliceExponent(Re));
}

/// Equation: the same with beta = 3.8, about what it is at low and at high Re_s
inline double diFeliceConstant(const DragState& s)
{
    return hindered(s, dallaValleCdRe(superficialRe(s)), 3.8);
}

/// Equation: the same with Cd of Schiller and Naumann at Re_s
inline double schillerNaumannDiFelice(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, schillerNaumannCdRe(Re), diFeliceExponent(Re));
}

/// Equation: n gamma = 3/4 Cd(Re_s) alpha phi rho |u - v|/d alpha^(-2.65), Cd of Schiller and Naumann, which is beta = 3.65
///           (Wen & Yu 1966 as in Gidaspow 1994)
/// Range:    alpha > 0.8
inline double wenYu(const DragState& s)
{
    return hindered(s, schillerNaumannCdRe(superficialRe(s)), 3.65);
}

/// Equation: Cd of DallaValle at Re_s, beta = 2.65 (alpha + 1) - (5.3 - 3.5 alpha) alpha^2 exp(-(1.5 - log10 Re_s)^2/2)
///           (Rong, Dong & Yu 2013)
/// Range:    lattice-Boltzmann simulations of packings of alpha 0.37 and looser; warned of below that, and above Re_s 3000
inline double rong(const DragState& s)
{
    const double Re = superficialRe(s);
    const double alpha = s.fluidFraction;
    return hindered(s, dallaValleCdRe(Re), 2.65*(alpha + 1) - (5.3 - 3.5*alpha)*alpha*alpha*midwayRe(Re));
}

/// V_r, settling velocity of a suspension over that of a lone grain, from fits to Richardson and Zaki's data.
/// Equation: V_r = (A - 0.06 Re + sqrt((0.06 Re)^2 + 0.12 Re (2 B - A) + A^2))/2, A = alpha^4.14, B = 0.8 alpha^1.28 up to alpha 0.85,
///           alpha^2.65 above
inline double syamlalOBrienRatio(double Re, double alpha)
{
    const double A = std::pow(alpha, 4.14);
    const double B = alpha <= 0.85 ? 0.8*std::pow(alpha, 1.28) : std::pow(alpha, 2.65);
    const double x = 0.06*Re;
    const double root = std::sqrt((x - A)*(x - A) + 4*x*B);
    // A - x and the root cancel where x is large; the second form is the same number.
    return x < A ? 0.5*(A - x + root) : 2*x*B/(x - A + root);
}

/// Equation: n gamma = 3/4 Cd alpha phi rho |u - v|/(V_r^2 d), Cd = (0.63 + 4.8 sqrt(V_r/Re))^2, Re of the interstitial slip
///           (Syamlal & O'Brien 1987, as MFiX has it, with 0.8 and 2.65 in B)
/// Range:    all alpha; it drops by up to 0.1 % at alpha 0.85, where B changes
inline double syamlalOBrien(const DragState& s)
{
    const double Re = slipRe(s);
    const double ratio = syamlalOBrienRatio(Re, s.fluidFraction);
    return loneGrain(s, dallaValleCdRe(Re/ratio))*s.fluidFraction/ratio;
}

} // namespace drag
} // namespace closures
