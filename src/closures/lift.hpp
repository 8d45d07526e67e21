// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lift on one sphere: the forces across its slip that a shear of the fluid and its own spin make.
#pragma once

#include <Eigen/Core>

namespace closures
{

/// A sphere in a flow that would have these values at its center if it were not there.
struct LiftState
{
    double diameter;             ///< d [m]
    Eigen::Vector3d slip;        ///< us = u - v, fluid less sphere [m/s]; 0 is allowed
    Eigen::Vector3d vorticity;   ///< w = curl u [1/s]; 0 is allowed
    Eigen::Vector3d spin;        ///< omega of the sphere [rad/s]
    double density;              ///< rho of the fluid [kg/m3]
    double viscosity;            ///< mu of the fluid, dynamic [Pa s]
};

/// Lift of a sphere that slips along a shear flow [N]: towards the faster fluid where the sphere lags behind, away from it where it leads.
/// Equation: 1.615 d^2 sqrt(rho mu/|w|) C (us x w) (Saffman 1965, doi 10.1017/S0022112065000824, corrected in J. Fluid Mech. 31, 624),
///           with Re = rho |us| d/mu, beta = |w| d/(2 |us|): C = (1 - 0.3314 sqrt(beta)) exp(-Re/10) + 0.3314 sqrt(beta) up to Re 40,
///           0.0524 sqrt(beta Re) above (Mei 1992, doi 10.1016/0301-9322(92)90012-6)
/// Range:    Mei fitted C to 0.1 <= Re <= 100, 0.005 <= beta <= 0.4. Outside, the same expressions hold as they stand: for Re -> 0 they
///           are Saffman's law, which is meant for Re << sqrt(Re_k) << 1, Re_k = a^2 |w|/nu, a = d/2; elsewhere they extrapolate.
///           At Re 40 C drops by (1 - 0.3314 sqrt(beta)) exp(-4), as published: by 14 % at beta 0.1, 6 % at 0.4.
/// Limits:   6.46 mu a^2 |us| sqrt(k/nu) in a simple shear k for Re -> 0, whatever the spin, which comes in with the next order alone.
///           That order is left out: -pi rho a^3 |us| (11/8 k + s), s the spin against the vorticity (Saffman 1965; the reciprocal theorem
///           over the Stokes flows around the sphere gives the same). A torque-free sphere turns with the fluid, s = -k/2: -7/8 pi rho a^3
///           |us| k, 0.43 sqrt(Re_k) of the lift, below 5 % up to Re_k 0.014. A held one has s = 0: -11/8, 0.67 sqrt(Re_k), 0.0056.
///           What a spin other than the fluid's adds, pi rho a^3 |us| times it, is magnusLift().
/// Ensures:  0 without slip and without vorticity, where nothing is divided by zero
Eigen::Vector3d saffmanMeiLift(const LiftState& state);

/// Lift of a sphere that spins otherwise than the fluid around it [N], the Magnus force.
/// Equation: C/2 rho pi/4 d^2 |us| (W x us)/|W|, W = w/2 - omega the fluid's spin less the sphere's, with Re = rho |us| d/mu,
///           Re_W = rho d^2 |W|/mu: C = 0.45 + (Re_W/Re - 0.45) exp(-0.05684 Re_W^0.4 Re^0.3) (Oesterle & Bui Dinh 1998,
///           doi 10.1007/s003480050203)
/// Range:    measured for 10 < Re < 140, 2 < Re_W/Re < 12. Outside, the same expression holds as it stands: beyond Re 140 it extrapolates.
/// Limits:   pi/8 rho d^3 W x us for Re -> 0 (Rubinow & Keller 1961, doi 10.1017/S0022112061000640), which the expression was made to have.
///           So it is taken below Re 1 too, and nothing is switched there: it starts from Rubinow and Keller's force and is 6 % below it
///           at Re 1 for Re_W/Re = 2, 14 % for 12.
/// Ensures:  0 without slip and without relative spin, where nothing is divided by zero
Eigen::Vector3d magnusLift(const LiftState& state);

} // namespace closures
