// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heat transfer between the fluid and one sphere: Nusselt numbers by name, and what a sphere takes up in a step.
#pragma once

#include <string>
#include <vector>

namespace closures
{

/// A sphere in a fluid, in numbers without units.
struct NusseltState
{
    double Re;             ///< rho |u - v| d/mu of the interstitial slip; 0 is allowed
    double Pr;             ///< mu cp/k of the fluid
    double fluidFraction;  ///< alpha, in (0, 1]
};

/// One row of the table of laws.
struct NusseltLawRow
{
    const char* name;
    double (*law)(const NusseltState&);  ///< Nu = h d/k
    const char* source;
};

/// All laws, in the order of the table.
const std::vector<NusseltLawRow>& nusseltLaws();

/// The row of this name.
/// Errors: std::invalid_argument, listing the names, for another word
const NusseltLawRow& findNusseltLaw(const std::string& name);

/// Conductance [W/K] that a sphere of one temperature has over a step: it takes up dt times this, times (Tf - Ts^n), from a fluid whose
/// temperature Tf of the step's end holds throughout.
/// Equation: C (1 - exp(-h A dt/C))/dt, the exact integral of C dTs/dt = h A (Tf - Ts)
/// Units:    conductance h A [W/K], heat capacity C = m c [J/K], deltaT [s]
/// Ensures:  Ts^{n+1} lies between Ts^n and Tf for any dt; h A for dt -> 0
double conductanceOverStep(double conductance, double heatCapacity, double deltaT);

} // namespace closures
