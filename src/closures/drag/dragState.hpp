// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What the drag on one grain depends on, and the parts that drag laws are made of.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include <algorithm>
#include <cmath>

namespace closures
{

/// Size of a grain as a drag law sees it; made by sphereSize() or discSize().
struct GrainSize
{
    double diameter;     ///< d [m]
    double frontalArea;  ///< seen by the flow [m2]: pi d^2/4 of a sphere, d t of a disc of thickness t
    double volume;       ///< [m3]: pi d^3/6 of a sphere, pi d^2 t/4 of a disc
};

struct DragState
{
    GrainSize size;
    double slip;           ///< |u - v| [m/s], u the interstitial fluid velocity; 0 is allowed
    double fluidFraction;  ///< alpha in (0, 1]
    double density;        ///< of the fluid [kg/m3]
    double viscosity;      ///< of the fluid, dynamic [Pa s]
    double sphericity = 1;            ///< surface of the sphere of the same volume over the grain's own [-]
    double crosswiseSphericity = 1;   ///< frontal area of the sphere of the same volume over what the grain turns to the flow [-]
};

/// Re of the slip velocity, for a grain alone.
inline double slipRe(const DragState& s)
{
    return s.density*s.slip*s.size.diameter/s.viscosity;
}

/// Re_s = rho U_s d/mu of the superficial slip U_s = alpha |u - v|.
inline double superficialRe(const DragState& s)
{
    return s.fluidFraction*slipRe(s);
}

/// phi = 1 - alpha; 0 where round-off has alpha above 1, of which laws take roots.
inline double solidFraction(const DragState& s)
{
    return std::max(0.0, 1 - s.fluidFraction);
}

namespace drag
{

constexpr double pi = 3.14159265358979323846;

// The product Cd Re has a limit at Re = 0 where Cd has none: every law is written with it.

/// Cd Re of a lone grain in creeping flow.
constexpr double stokesCdRe = 24;

/// Above this Reynolds number Schiller and Naumann take Newton's constant drag.
constexpr double newtonRe = 1000;

/// Cd = 24/Re (1 + 0.15 Re^0.687), 0.44 from Re 1000 on (Schiller & Naumann 1933).
inline double schillerNaumannCdRe(double Re)
{
    return Re < newtonRe ? stokesCdRe*(1 + 0.15*std::pow(Re, 0.687)) : 0.44*Re;
}

/// Cd = (0.63 + 4.8/sqrt(Re))^2 (DallaValle 1948).
inline double dallaValleCdRe(double Re)
{
    const double root = 0.63*std::sqrt(Re) + 4.8;
    return root*root;
}

/// F = A/2 rho Cd(Re) |u - v|^2 divided by |u - v|, with Cd = cdRe/Re.
inline double loneGrain(const DragState& s, double cdRe)
{
    return 0.5*s.size.frontalArea*s.viscosity*cdRe/s.size.diameter;
}

/// F = A/2 rho Cd(Re_s) U_s^2 alpha^(-beta) divided by |u - v|.
inline double hindered(const DragState& s, double cdRe, double beta)
{
    return loneGrain(s, cdRe)*std::pow(s.fluidFraction, 1 - beta);
}

/// F over Stokes' drag of a lone grain in the same slip, times |u - v|: 3 pi mu d of a sphere.
inline double timesStokes(const DragState& s, double factor)
{
    return loneGrain(s, stokesCdRe)*factor;
}

} // namespace drag
} // namespace closures
