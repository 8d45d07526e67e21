// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A body with a full Delassus operator in the contact problem.
// Tested by tests/unit/nscd/contacts/general/generalSweepTest.cpp
#pragma once

#include "nscd/base/vec3.hpp"

namespace nscd
{

/// A rigid body that is touched anywhere, not at the end of a radius from its center as a grain of one sphere is: the second kind of body. At the
/// orientation that the step started with.
struct GeneralBody
{
    Vec3 v;                        ///< [m/s]
    Vec3 omega;                    ///< world frame [rad/s]
    double invMass;                ///< [1/kg]
    Eigen::Matrix3d inertia;       ///< world frame [kg m2]
    Eigen::Matrix3d invInertia;    ///< [1/(kg m2)]
    Vec3 freeMomentum;             ///< angular momentum without contacts [kg m2/s]
    Vec3 freeV;                    ///< without contacts [m/s]
    Vec3 freeOmega;                ///< [rad/s]
};

} // namespace nscd
