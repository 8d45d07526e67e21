// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Implementation of ownWake.hpp.
#include "closures/ownWake.hpp"

#include <algorithm>
#include <cmath>

namespace closures
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double cubeFlow = 0.1235;
/// Flow of a force spread by the smoothing alone, sampled likewise, times l: 1/(3 pi^2) times the integral of the square of the kernel's transform.
constexpr double smoothedFlow = 0.020403;
constexpr double nearAcross = 0.10;
constexpr double nearAlong = 0.29;
constexpr double fractionSlope = 0.09;

/// Others that fill less of the cells do not count; those that fill more leave nothing of the own wake.
constexpr double fewOthers = 0.001;
constexpr double manyOthers = 0.01;

constexpr double fewInParcel = 5, manyInParcel = 10;

} // namespace

double flowInOwnCell(double cellVolume, double smoothingArea)
{
    const double smoothed = cubeFlow/smoothedFlow;
    return cubeFlow/std::sqrt(std::pow(cellVolume, 2.0/3) + smoothed*smoothed*smoothingArea);
}

Eigen::Matrix3d flowInOtherCell(const Eigen::Vector3d& distance, double side, double smoothingArea)
{
    const double smoothed = 1/(8*pi*smoothedFlow);
    const double length = std::sqrt(distance.squaredNorm() + smoothed*smoothed*smoothingArea);
    const double near = std::pow(side/length, 6);
    const Eigen::Vector3d direction = distance/length;
    const Eigen::Matrix3d along = direction*direction.transpose();
    return ((1 + nearAcross*near)*Eigen::Matrix3d::Identity() + (1 + nearAlong*near)*along)/(8*pi*length);
}

double wakeInFraction(double ownFraction)
{
    return 1 + fractionSlope*ownFraction;
}

double wakeInertia(double cellReynolds)
{
    return 1/(1 + 0.20*cellReynolds + 0.10*cellReynolds/(cellReynolds + 0.05));
}

double wakeTime(double viscosity, double density, double length, double slip)
{
    return 1/(4*viscosity/(density*length*length) + slip/length);
}

double loneliness(double othersFraction)
{
    return std::clamp((manyOthers - othersFraction)/(manyOthers - fewOthers), 0.0, 1.0);
}

double wakeOfParcel(double crowding)
{
    return std::clamp((manyInParcel - crowding)/(manyInParcel - fewInParcel), 0.0, 1.0);
}

} // namespace closures
