// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts of clumps one by one, for solvers that visit contacts so.
#pragma once

#include "nscd/contacts/clumps/clumpContacts.hpp"

namespace nscd
{

inline bool isOfClump(const ClumpList* clumps, std::size_t slot) { return clumps && slot >= clumps->firstBlock*blockLanes; }

/// One body for all members of a clump: the first of them; others stand for themselves.
int bodyForClump(const ClumpList& clumps, int body);

/// Change of the impulse of one slot that solves it with all others held [N s].
struct ClumpChange
{
    Vec3 impulse;
    double defect;   ///< |W dr| [m/s]
};
ClumpChange clumpChange(const Body* bodies, const ContactBlock* blocks, const ClumpList& clumps, std::size_t slot);

/// Changes the impulse of a slot, and the velocities of its two bodies.
void applyClumpChange(Body* bodies, ContactBlock* blocks, ClumpList& clumps, std::size_t slot, const Vec3& change);

} // namespace nscd
