// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of all candidates at the present positions.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Recomputes normals and gaps at the present positions.
/// Errors: std::invalid_argument for coincident centers, naming the grains
void updateGeometry(ContactList& list, const Scene& scene);

/// The same, of pairs of grains alone, in the blocks first .. end - 1.
void updatePairs(ContactList& list, const Scene& scene, std::size_t first, std::size_t end);

/// From b to a, the bodies of a slot of two grains, through the periodic side that it is about [m].
Vec3 distanceOfPair(const ContactList& list, const PeriodicBox& box, std::size_t slot);

/// A contact's normal, kept.
struct KeptNormal
{
    std::size_t slot;
    Vec3 n;
};

/// Turns the normals of awake contacts of two grains that are closed to where the motion of the step has brought these, and their impulses, made admissible;
/// velocities become those that the impulses give there. Gaps stay those at the step's start. Pairs that were aimed (see aimFastPairs) have the normal of
/// their impact already; walls, and members of general bodies, keep that of the step's start.
/// Returns the normals before.
std::vector<KeptNormal> turnClosedNormals(ContactList& list, const PeriodicBox& box, double deadBand);

void setNormals(ContactList& list, const std::vector<KeptNormal>& normals);

} // namespace nscd
