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

constexpr double pi = 3.14159265358979323846;

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

Eigen::Vector3d magnusLift(const LiftState& state)
{
    const Eigen::Vector3d relativeSpin = 0.5*state.vorticity - state.spin;
    const double slip = state.slip.norm();
    const double turn = relativeSpin.norm();
    if (slip == 0 || turn == 0) return Eigen::Vector3d::Zero();
    const double d = state.diameter;
    const double Re = state.density*slip*d/state.viscosity;
    const double ReW = state.density*turn*d*d/state.viscosity;
    // C |us|/|W| as d exp(-x) + 0.45 (1 - exp(-x)) |us|/|W|, which has a limit where the paper's quotient Re_W/Re has none.
    const double x = 0.05684*std::pow(ReW, 0.4)*std::pow(Re, 0.3);
    const double length = d*std::exp(-x) - 0.45*std::expm1(-x)*slip/turn;
    return pi/8*state.density*d*d*length*relativeSpin.cross(state.slip);
}

} // namespace closures
