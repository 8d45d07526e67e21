// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Bodies with a full Delassus operator in the contact problem, and their contacts.
// Tested by tests/unit/nscd/contacts/generalCandidatesTest.cpp, tests/unit/nscd/contacts/general/generalSweepTest.cpp
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/contacts/general/generalBody.hpp"
#include "nscd/contacts/general/generalHalo.hpp"

#include <utility>
#include <vector>

namespace nscd
{

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

/// What a slot has besides where contacts bear moments, M = R' q on A (see RollingFriction): with u the relative velocity and w = R' (omega_A - omega_B),
/// u = u_free + W r + K q, w = w_free + K^T r + S q, K = -R' sum [c] J^-1, S = R'^2 sum J^-1.
struct GeneralMoment
{
    double reducedRadius = 0.0;                               ///< R' [m]
    Eigen::Matrix3d coupling = Eigen::Matrix3d::Zero();       ///< K [1/kg]
    Eigen::Matrix3d mobility = Eigen::Matrix3d::Zero();       ///< S [1/kg]
};

/// The general bodies of a contact list; none in plain scenes. Contacts with a member of one fill blocks of their own, behind all others; what these hold,
/// normals, gaps, impulses, 1/W_nn and 1/W_tt (half the trace of the tangential part), means what it does elsewhere, but lanes of a block may share
/// bodies, and kernels never see them. Members' entries among the list's bodies follow their owners after a solve, for whoever reads velocities there.
/// Contacts with a member that join two ranks come last; their bodies are kept one as GeneralHalo says.
struct GeneralBodies
{
    bool isThere = false;              ///< whether any rank has a general body: all take part then in what keeps them one
    std::vector<GeneralBody> bodies;   ///< own ones, ghosts and copies, as GeneralHalo numbers them
    std::vector<int> clumpOf;          ///< of each own body; ascending
    std::vector<GeneralMember> members;   ///< of own bodies, then of ghosts; those of an own body in a row
    std::size_t ownMembers = 0;
    std::vector<int> memberOf;         ///< of each own body of the list, and of each ghost there, -1: a single grain
    std::size_t firstBlock = 0;
    std::size_t firstInterface = 0;      ///< from this block on contacts join two ranks
    std::vector<GeneralSlot> slots;      ///< of blocks from firstBlock on
    std::vector<GeneralMoment> moments;  ///< of the same slots; empty where contacts bear no moments
    bool isFrictionHeld = false;         ///< the friction of a block is the bound itself [N s], while solvers/heldFriction.hpp says so
    GeneralHalo halo;

    bool empty() const { return !isThere; }
    std::size_t own() const { return halo.isParallel() ? static_cast<std::size_t>(halo.ownBodies()) : bodies.size(); }
    /// Index into members of a body of the list, or -1.
    int member(int body) const { return body < static_cast<int>(memberOf.size()) ? memberOf[body] : -1; }
    /// First and end, among members, of those of the own body that one of them is part of.
    std::pair<std::size_t, std::size_t> besides(std::size_t number) const;
    /// One body for all members of a general body, the first of them; others stand for themselves.
    int representative(int body) const;

    /// Gives ghosts and copies the owners' free motions and mobilities.
    void giveBodies();
    /// Gives ghosts and copies the owners' velocities, before contacts between ranks are looked at.
    void giveVelocities();
    /// Moves the owners' velocities by what became of the ghosts' and copies' since they were given.
    void takeVelocities();

private:
    GeneralHalo::Motions velocities() const;
    void setVelocities(const GeneralHalo::Motions& velocities);

    GeneralHalo::Motions given_;
};

} // namespace nscd
