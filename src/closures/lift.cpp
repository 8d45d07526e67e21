// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Implementation of lift.hpp.
#include "closures/lift.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace closures
{

namespace
{

/// Where Mei's fit changes its form.
constexpr double meiSwitch = 40;

/// C of Re and sqrt(beta); the sum is that of the paper in another order, which does not cancel where slip is small and beta large.
double meiFactor(double Re, double rootBeta)
{
    if (Re > meiSwitch) return 0.0524*rootBeta*std::sqrt(Re);
    return std::exp(-Re/10) - 0.3314*rootBeta*std::expm1(-Re/10);
}

} // namespace

Eigen::Vector3d saffmanMeiLift(const LiftState& state)
{
    const double slip = state.slip.norm();
    const double shear = state.vorticity.norm();
    if (slip == 0 || shear == 0) return Eigen::Vector3d::Zero();
    const double Re = state.density*slip*state.diameter/state.viscosity;
    const double beta = shear*state.diameter/(2*slip);
    const double size = 1.615*state.diameter*state.diameter*std::sqrt(state.density*state.viscosity/shear);
    return size*meiFactor(Re, std::sqrt(beta))*state.slip.cross(state.vorticity);
}

} // namespace closures
