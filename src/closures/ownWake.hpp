// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a lone grain sees of itself in the cells it acts on: the flow that its own force makes there, and when that matters.
//
// The force on the fluid is spread over cells and the velocity sampled from the same cells, so a grain meets fluid that it drags along.
// At small Reynolds number the sampled velocity of its own making is, with the weights w_j of its cells and the force F on the fluid,
//     u = 1/mu sum_jk w_j w_k G_jk F,
// G_jk the flow of a unit force on cell k as cell j sees it. The idea of a correction by the flow of the regularized force is that of
// Horwitz & Mani (2016, J. Comput. Phys. 318, 85) and of Evrard, Denner & van Wachem (2020, J. Comput. Phys. X 8, 100078);
// numbers here are for cells (src/closures/method.md).
#pragma once

#include <Eigen/Core>

namespace closures
{

/// Flow of a unit force spread over a cell, sampled from that cell, times the viscosity [1/m].
/// Equation: c/sqrt(V^(2/3) + (c/b)^2 l^2), c = 0.1235 measured for cubes; l^2 the area over which fields are smoothed besides, by a kernel
///           (1 - r^2/a^2)^2 with a = 3 sqrt(2) l, for which b = 0.0204
double flowInOwnCell(double cellVolume, double smoothingArea);

/// Flow of a unit force spread over a cell of side h, sampled from another one at the distance r, times the viscosity [1/m].
/// Equation: ((1 + 0.10 q) I + (1 + 0.29 q) r r/s^2)/(8 pi s), s^2 = r^2 + 3.80 l^2, q = (h/s)^6: Oseen's tensor but for cells that touch
Eigen::Matrix3d flowInOtherCell(const Eigen::Vector3d& distance, double side, double smoothingArea);

/// What the grain's own part of the solid fraction adds to the flow.
/// Equation: 1 + 0.09 fraction, measured at 0.52 and 0.065
double wakeInFraction(double ownFraction);

/// How much of the speed of its wake in its cells a grain takes along: the speed at which the wake stays behind is the grain's against
/// the fluid less 0.63 of that.
constexpr double wakeTakenAlong = 0.63;

/// Share of that flow which inertia leaves; Re_h = rho v h/mu with h^3 the volume that the force is spread over, v the speed at which the
/// wake stays behind.
/// Equation: 1/(1 + 0.20 Re_h + 0.10 Re_h/(Re_h + 0.05)), fitted to falls in cells of 1, 2 and 10 d at Re 0.01 to 100
double wakeInertia(double cellReynolds);

/// Time in which the flow in the cells follows the force [s].
/// Equation: 1/(4 nu/h^2 + slip/h): diffusion over h and passage through h
double wakeTime(double viscosity, double density, double length, double slip);

/// 1 for a grain without others in its cells and those next to them, falling to 0 where others fill a hundredth. Between others the
/// flow is that of all: in a suspension that is the same everywhere nothing of the own wake is left.
double loneliness(double othersFraction);

/// 1 for a parcel of few grains, falling to 0 for those of many, which take the fluid in their cells along: then the flow above, which grows with
/// the force without end, is not theirs, and what is left of the slip does not tell the fluid's own velocity. `crowding`: l^3 d/h, the Stokes
/// drag of all grains of a parcel over that of a sphere as large as what the force is spread over; at most 1 for single grains.
/// Equation: 1 up to 5, where parcels that fall alone are 35 % too slow with the correction and 90 % too fast without; 0 from 10 on
double wakeOfParcel(double crowding);

} // namespace closures
