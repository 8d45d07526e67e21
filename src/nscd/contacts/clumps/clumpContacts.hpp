// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts of clumps in the contact problem: scalar code beside the sweep kernels, as clumps are beside the bodies.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/kernels/contactBlock.hpp"

#include <vector>

namespace nscd
{

struct Clumps;
struct ContactList;

/// A clump as the contact problem sees it, at the orientation that the step started with.
struct ClumpBody
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

struct ClumpMember
{
    int clump;
    int body;           ///< in the list
    Vec3 center;        ///< from the mass center, in the clump's axes [m]
    Vec3 arm;           ///< likewise in the world's, at the start of the step [m]
};

/// What a contact of a clump has beyond those of single grains: where it acts, and a full Delassus operator,
/// W = sum over the two bodies of I/m - [c] J^-1 [c], c the arm from the mass center to the contact, [c] x = c cross x.
struct ClumpSlot
{
    int clumpA = -1;              ///< -1: a single grain, or a wall
    int clumpB = -1;
    Vec3 armA = Vec3::Zero();     ///< of the contact [m]
    Vec3 armB = Vec3::Zero();
    Eigen::Matrix3d w = Eigen::Matrix3d::Zero();          ///< [1/kg]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();    ///< [kg]
};

/// The clumps of a contact list. Contacts with a member of a clump fill blocks of their own, behind all others; what these hold, normals, gaps, impulses,
/// 1/W_nn and 1/W_tt (half the trace of the tangential part), means what it does elsewhere, but lanes of a block may share bodies, and
/// kernels never see them. Members' entries among the list's bodies follow their clumps after a solve, for whoever reads velocities there.
struct ClumpList
{
    std::vector<ClumpBody> bodies;
    std::vector<ClumpMember> members;
    std::vector<int> memberOf;         ///< of each own body, -1: a single grain
    std::size_t firstBlock = 0;
    std::vector<ClumpSlot> slots;      ///< of blocks from firstBlock on

    bool empty() const { return bodies.empty(); }
};

/// Clumps and members, for own bodies in the order `grainOf`.
ClumpList listClumps(const Clumps& clumps, const std::vector<int>& grainOf);

/// Sets W, bias and warm start of the contacts of clumps, as prepareSlots() does for the others, and adds blocks that matter to list.awake.
void prepareClumpSlots(ContactList& list, double deltaT, double deadBand, double unreachable, double impulseScale);

/// One pass over the contacts of a range: each solved exactly with all others held (solveCoulomb). The defect is |W dr|.
DefectSums sweepClumps(Body* bodies, ContactBlock* blocks, ClumpList& clumps, BlockRange range);

/// The natural map of all contacts of clumps, with the contacts' own W_nn, and half the trace of W_tt for W_tt.
DefectSums evaluateClumps(const Body* bodies, const std::vector<ContactBlock>& blocks, const ClumpList& clumps);

/// ReplaceFunction for blocks of clumps.
void replaceClumpImpulses(Body* bodies, ContactBlock* blocks, ClumpList& clumps, BlockRange range, double* target);

/// Whether a contact of a block carries an impulse, or should at the present velocities.
bool isClumpBlockActive(const Body* bodies, const ContactBlock* blocks, const ClumpList& clumps, std::size_t block);

} // namespace nscd
