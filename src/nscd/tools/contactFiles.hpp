// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts as they are shown: points of contact and force chains, in files that ParaView opens as they are.
// Tested by tests/unit/nscd/tools/contactFilesTest.cpp
#pragma once

#include "nscd/step/grainDynamics.hpp"

#include <string>
#include <vector>

namespace nscd
{

/// What a contact does: attract across a gap alone, hold its point, or slide.
enum class ContactState : int { open, stick, slip };

/// A loaded contact with all that a picture or a stress needs of its grains. Of two grains, A is the one with the lower identity.
struct ShownContact
{
    std::int64_t idA;
    std::int64_t idB;     ///< of a wall -1 - its region
    Vec3 centerA;         ///< [m]
    Vec3 centerB;         ///< of the image of B that is touched; the point on a wall [m]
    Vec3 point;           ///< half way between the two surfaces; the point on a wall [m]
    Vec3 normal;          ///< unit, from B to A
    double gap;           ///< [m]
    Vec3 impulse;         ///< on A, of the whole step [N s]
    Vec3 force;           ///< on A, its mean over the step [N]
    ContactState state;

    bool isWithWall() const { return idB < 0; }
};

/// Contacts of the last step, of length deltaT [s], on their grains where these are now.
/// Slip: |r_t| >= mu r_n, but for 1e-6 of it, with the impulse r without attraction and the normal at the end of the step; what a normal turns by in the
/// step, [rad], is how exactly both can be told apart.
std::vector<ShownContact> shownContacts(const Grains& grains, const std::vector<LoadedContact>& contacts, double deltaT);

/// An order that depends on the contacts alone: by identities, and by place where two grains touch twice in a periodic box.
void sortByIdentity(std::vector<ShownContact>& contacts);

/// Points of contact: normal, force [N], normalForce, tangentialForce, impulse [N s], normalImpulse, gap [m], state (0 open, 1 stick,
/// 2 slip), kind (0 of two grains, 1 with a wall), idA, idB.
/// Errors: std::runtime_error where the file cannot be written
void writeContactPoints(const std::string& path, double time, const std::vector<ShownContact>& contacts);

/// The same contacts as lines from center to center, or to the wall: forceMagnitude [N], and all of the above but the normal.
void writeForceChains(const std::string& path, double time, const std::vector<ShownContact>& contacts);

} // namespace nscd
