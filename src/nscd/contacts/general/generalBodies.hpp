// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Bodies with a full Delassus operator in the contact problem, and their contacts.
// Tested by tests/unit/nscd/contacts/generalCandidatesTest.cpp, tests/unit/nscd/contacts/general/generalSweepTest.cpp
#pragma once

#include "nscd/base/vec3.hpp"

#include <vector>

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

/// A sphere or disc of the list that is part of a general body.
struct GeneralMember
{
    int owner;          ///< index of the general body
    int body;           ///< in the list
    Vec3 center;        ///< from the mass center, in the body's axes [m]
    Vec3 arm;           ///< likewise in the world's, at the start of the step [m]
};

/// What a contact of a general body has beyond those of single grains: where it acts, and a full Delassus operator,
/// W = sum over the two bodies of I/m - [c] J^-1 [c], c the arm from the mass center to the contact, [c] x = c cross x.
struct GeneralSlot
{
    int ownerA = -1;              ///< -1: a single grain, or a wall
    int ownerB = -1;
    Vec3 armA = Vec3::Zero();     ///< of the contact [m]
    Vec3 armB = Vec3::Zero();
    Eigen::Matrix3d w = Eigen::Matrix3d::Zero();          ///< [1/kg]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();    ///< [kg]
};

/// The general bodies of a contact list; none in plain scenes. Contacts with a member of one fill blocks of their own, behind all others; what these hold,
/// normals, gaps, impulses, 1/W_nn and 1/W_tt (half the trace of the tangential part), means what it does elsewhere, but lanes of a block may share
/// bodies, and kernels never see them. Members' entries among the list's bodies follow their owners after a solve, for whoever reads velocities there.
struct GeneralBodies
{
    std::vector<GeneralBody> bodies;
    std::vector<GeneralMember> members;
    std::vector<int> memberOf;         ///< of each own body, -1: a single grain
    std::size_t firstBlock = 0;
    std::vector<GeneralSlot> slots;      ///< of blocks from firstBlock on
    bool isFrictionHeld = false;         ///< the friction of a block is the bound itself [N s], while solvers/heldFriction.hpp says so

    bool empty() const { return bodies.empty(); }
    /// One body for all members of a general body, the first of them; others stand for themselves.
    int representative(int body) const;
};

} // namespace nscd
