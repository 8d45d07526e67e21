// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Passes over contacts of general bodies: scalar code beside the sweep kernels.
#pragma once

#include "nscd/contacts/general/generalBodies.hpp"
#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

/// An impulse without attraction, its tangential part in the tangent plane and the friction disc.
Vec3 admissible(const Vec3& r, const Vec3& n, double friction);

/// Gives the impulses of a block to its bodies, as they are.
void giveGeneralImpulses(Body* bodies, const ContactBlock* blocks, GeneralBodies& general, std::size_t block);

/// One pass over the contacts of a range: each solved exactly with all others held (solveCoulomb). The defect is |W dr|.
DefectSums sweepGeneral(Body* bodies, ContactBlock* blocks, GeneralBodies& general, BlockRange range);

/// The natural map of all general contacts, with the contacts' own W_nn, and half the trace of W_tt for W_tt.
DefectSums evaluateGeneral(const Body* bodies, const std::vector<ContactBlock>& blocks, const GeneralBodies& general);

/// ReplaceFunction for general blocks.
void replaceGeneralImpulses(Body* bodies, ContactBlock* blocks, GeneralBodies& general, BlockRange range, double* target);

/// Whether a contact of a block carries an impulse, or should at the present velocities.
bool isGeneralBlockActive(const Body* bodies, const ContactBlock* blocks, const GeneralBodies& general, std::size_t block);

/// Whether a slot's contact is one of a general body. `general`: null in scenes without.
inline bool isGeneral(const GeneralBodies* general, std::size_t slot) { return general && slot >= general->firstBlock*blockLanes; }

/// Change of the impulse of one slot that solves it with all others held [N s].
struct GeneralChange
{
    Vec3 impulse;
    double defect;   ///< |W dr| [m/s]
};
GeneralChange generalChange(const Body* bodies, const ContactBlock* blocks, const GeneralBodies& general, std::size_t slot);

/// Changes the velocities of the two bodies of a slot by an impulse on A, and its opposite on B, where they touch.
void pushGeneral(Body* bodies, const ContactBlock* blocks, GeneralBodies& general, std::size_t slot, const Vec3& impulse);

/// Changes the impulse of a slot, and the velocities of its two bodies.
void applyGeneralChange(Body* bodies, ContactBlock* blocks, GeneralBodies& general, std::size_t slot, const Vec3& change);

} // namespace nscd
