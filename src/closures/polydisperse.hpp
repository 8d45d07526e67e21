// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spheres of several sizes: what a law for equal spheres is given for one of them.
//
// The whole force of the fluid on sphere i of a bed of mean diameter <d>, the pressure gradient's part in it, is by van der Hoef, Beetstra &
// Kuipers (2005) and Beetstra et al. (2007), with y = d_i/<d> and F the whole force over 3 pi mu d U_s that equal spheres of <d> feel at the
// same alpha and at Re_s of <d>,
//     F_i = 3 pi mu d_i U_s F (alpha y + phi y^2 + 0.064 alpha y^3).
// Without the last term the pressure gradient n F of the bed is that of equal spheres of <d>, if <d> is Sauter's mean, the sum of d^3 over the
// sum of d^2. Form A has the part V_i grad p apart: it is phi y^3 in units of 3 pi mu <d> U_s F, and what is left is alpha y^2,
//     gamma_i = y^2 gamma(<d>).
// The last term is left out, as MFiX has it for form A, whose comment refers to Beetstra's erratum: it gives equal spheres 1 + 0.064 alpha
// times the force that F was fitted to.
#pragma once

#include "closures/drag/dragState.hpp"

namespace closures
{

/// What makes every law that is built on Cd or on a force per volume give y^2 gamma(<d>): the mean diameter with the grain's own frontal area,
/// and y^2 times the mean's volume.
/// Range: meant for beds; between lone spheres of several sizes a small one would feel y times its drag
inline GrainSize polydisperseSize(double diameter, double meanDiameter)
{
    const double square = drag::pi*diameter*diameter;
    return {meanDiameter, square/4, square*meanDiameter/6};
}

} // namespace closures
