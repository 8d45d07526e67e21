// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts of general bodies that bear moments: rolling and spinning friction between two rigid bodies.
#pragma once

#include "nscd/contacts/general/generalBodies.hpp"
#include "nscd/contacts/general/generalContact.hpp"
#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

/// The local problem of one contact with a moment, all others held: u = W r + K q + u_free, w = K^T r + S q + w_free (see GeneralMoment).
struct MomentContact
{
    GeneralContact coulomb;      ///< without moments
    const GeneralMoment& moment;
    double across;               ///< mu_r
    double along;                ///< mu_s
};

/// What a contact gives A [N s]: an impulse, and a moment over R'.
struct BorneByContact
{
    Vec3 r;
    Vec3 q;
};

/// Impulse by Coulomb's law and moment by that of RollingFriction, both at once. Where the moment keeps the bodies from turning on one another it is eliminated, which leaves
/// Coulomb's law with W - K S^-1 K^T, solved exactly, whether it sticks or slides. Where that asks for more than the moment may be, a few rounds of impulse and moment in turn,
/// from the `present` moment: the next sweep goes on from what these make of it.
BorneByContact solveWithMoment(const MomentContact& contact, const Vec3& uFree, const Vec3& wFree, const Vec3& present);

/// A moment cut to at most `across` in the tangent plane, and `along` the normal.
Vec3 admissibleMoment(const Vec3& q, const Vec3& n, double across, double along);

/// Of one contact whose slot has its arms; `rA`: radius of A [m].
GeneralMoment makeMoment(const Body* bodies, const ContactBlock& block, int lane, const LawBlock& law, const GeneralBodies& general, const GeneralSlot& slot, double rA);

/// sweepGeneral() and evaluateGeneral() with moments: passes over both, and over the natural map of the moments alone.
DefectSums sweepGeneralMoments(Body* bodies, ContactBlock* blocks, LawBlock* laws, GeneralBodies& general, BlockRange range);
DefectSums evaluateGeneralMoments(const Body* bodies, const std::vector<ContactBlock>& blocks, const std::vector<LawBlock>& laws, const GeneralBodies& general);

/// Turns the two bodies of a slot by a moment R' q on A, and its opposite on B.
void giveGeneralMoment(Body* bodies, const ContactBlock* blocks, const LawBlock* laws, GeneralBodies& general, std::size_t slot, const Vec3& q);

} // namespace nscd
