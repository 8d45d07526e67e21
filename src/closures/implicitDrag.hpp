// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag integrated over one step, with no limit on the step: weights, implicit and explicit parts, gamma at mid-slip.
//
// Over a step of length dt with fluid velocity u, other forces f and gamma frozen, m dv/dt = f + gamma (u - v) gives
//     v1 = v0 + E(k) [dt f/m + k (u - v0)],   k = gamma dt/m,
// with E = (1 - exp(-k))/k exactly and E = 1/(1+k) by backward Euler. Both tend to 1 for k -> 0 and make k E tend to 1
// for k -> infinity, so that v1 tends to u + f/gamma. With k' = 1/E - 1, dividing by E gives
//     (1 + k') v1 = v0 + dt f/m + k u - (k - k') v0,
// which is a drag -gamma' v1 implicit in the new velocity, gamma' = k' m/dt, with the force
//     f + gamma u - (gamma - gamma') v0
// beside it: what a grain solver that knows only implicit coefficients and given forces needs. Backward Euler has
// k' = k and no remainder; the exponential weight has k' = k/2 + O(k^2) and k' = k - 1 + O(k exp(-k)).
#pragma once

#include "closures/dragLaws.hpp"

#include <Eigen/Core>

#include <string>

namespace closures
{

/// k'(k), the implicit part of k = gamma dt/m; see the head of this file.
using DragWeighting = double (*)(double k);

/// k' = k: first order, damps most.
double backwardEuler(double k);

/// k' = k/(1 - exp(-k)) - 1: exact for a gamma that does not change within the step.
/// Ensures: relative error below 1e-14 for every k >= 0
double exponential(double k);

/// The weighting called `backwardEuler` or `exponential`.
/// Errors: std::invalid_argument, listing the names, for another word
DragWeighting findDragWeighting(const std::string& name);

/// gamma split by what it multiplies: the force of the fluid over the step is gamma u - implicit v1 - remainder v0.
struct DragSplit
{
    double implicit;   ///< [kg/s], times the grain's new velocity
    double remainder;  ///< [kg/s], times the grain's velocity at the start of the step
};

/// Splits gamma [kg/s] for a grain of mass [kg] over dt [s].
/// Ensures: implicit + remainder = gamma, both >= 0 up to round-off
DragSplit splitDrag(double gamma, double mass, double dt, DragWeighting weighting);

/// What a free grain moves in during one step.
struct DragStep
{
    Eigen::Vector3d fluidVelocity;  ///< u [m/s], interstitial
    Eigen::Vector3d force;          ///< all forces but drag [N]
    double mass;                    ///< [kg]
    double dt;                      ///< [s]
};

/// Velocity of a free grain at the end of the step [m/s].
/// Equation: v1 = v0 + [dt f/m + k (u - v0)]/(1 + k'), k = gamma dt/m
Eigen::Vector3d velocityAfter
(
    const DragStep& step, const Eigen::Vector3d& velocity, double gamma, DragWeighting weighting
);

/// gamma [kg/s] at mid-slip: gamma at the starting slip predicts v1, and gamma is evaluated again at |u - (v0 + v1)/2|.
/// Raises the order of a nonlinear law from 1 to 2; state.slip is not read.
/// Ensures: the terminal velocity of the law is a fixed point, at any dt
double gammaAtMidSlip
(
    const DragLaw& law, const DragState& state, const DragStep& step, const Eigen::Vector3d& velocity, DragWeighting weighting
);

} // namespace closures
