// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws that know of a grain's sphericity; single spheres have 1. Diameter and frontal area are those of the sphere of the same volume.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include "closures/drag/hinderedDrag.hpp"

namespace closures
{
namespace drag
{

/// Cd = 24/Re (1 + A Re^B) + C/(1 + D/Re) with A = exp(2.3288 - 6.4581 f + 2.4486 f^2), B = 0.0964 + 0.5565 f,
/// C = exp(4.905 - 13.8944 f + 18.4222 f^2 - 10.2599 f^3), D = exp(1.4681 + 12.2584 f - 20.7322 f^2 + 15.8855 f^3), f the sphericity
/// (Haider & Levenspiel 1989, Powder Technol. 58, 63, eq. 10 to 14)
inline double haiderLevenspielCdRe(double Re, double f)
{
    const double A = std::exp(2.3288 + f*(-6.4581 + f*2.4486));
    const double B = 0.0964 + 0.5565*f;
    const double C = std::exp(4.905 + f*(-13.8944 + f*(18.4222 - f*10.2599)));
    const double D = std::exp(1.4681 + f*(12.2584 + f*(-20.7322 + f*15.8855)));
    return stokesCdRe*(1 + A*std::pow(Re, B)) + C*Re*Re/(Re + D);
}

/// Cd = 8/(Re sqrt(f_c)) + 16/(Re sqrt(f)) + 3/(sqrt(Re) f^0.75) + 0.42 10^(0.4 (-log10 f)^0.2)/f_c, f the sphericity, f_c the crosswise one,
/// frontal area of the sphere of the same volume over the area that the grain turns to the flow
/// (Hoelzer & Sommerfeld 2008, Powder Technol. 184, 361, eq. 10)
inline double holzerSommerfeldCdRe(double Re, double f, double crosswise)
{
    // Round-off has a sphere's at 1 + 1e-16.
    const double flatness = std::pow(std::max(0.0, -std::log10(f)), 0.2);
    return 8/std::sqrt(crosswise) + 16/std::sqrt(f) + 3*std::sqrt(Re)/std::pow(f, 0.75) + 0.42*std::pow(10, 0.4*flatness)/crosswise*Re;
}

/// Equation: Cd as above at Re_s, beta of Di Felice (1994)
/// Range:    fitted to lone grains of sphericity 0.026 to 1 and Re up to 25000 (spheres 2.6e5); the voidage function is that of spheres
inline double haiderLevenspiel(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, haiderLevenspielCdRe(Re, s.sphericity), diFeliceExponent(Re));
}

/// Equation: Cd as above at Re_s, beta of Di Felice (1994), as Gao et al. (2021, Chem. Eng. J. 420, 127654) join the two
inline double holzerSommerfeld(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, holzerSommerfeldCdRe(Re, s.sphericity, s.crosswiseSphericity), diFeliceExponent(Re));
}

} // namespace drag
} // namespace closures
