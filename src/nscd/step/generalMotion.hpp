// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step does to general bodies before and after its solve: the clumps of the scene.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/externalForces.hpp"
#include "nscd/step/grainSleep.hpp"

namespace nscd
{

/// Errors: std::invalid_argument for clumps that cannot be (checkClumps), or beside which something stands that does not work with them
void checkGeneralBodies
(
    const Grains& grains, const PeriodicBox& box, const ContactSettings& settings, const Materials& materials
);

/// Free motion of clumps: v + dt f/m, and the spin that L + dt t makes of itself in the step (midpointSpin: Henry 2025, eq. 2.7). Forces
/// on members act at the mass center of their clump, so that weight turns nothing; their torques add up.
/// Members among the list's bodies get the velocities. Sleeping clumps have neither velocity nor mobility.
/// Errors: std::invalid_argument for implicit drag on a member
void setFreeGeneral(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT, const GrainSleep& sleep);

/// Gives members among the list's bodies the velocities of their clumps, to be called after a solve.
void takeGeneralVelocities(ContactList& list, const GrainShape& shape);
/// Gives members among `bodies` the free velocities of the step.
void mirrorFreeGeneral(const ContactList& list, std::vector<Body>& bodies);

/// Moves mass centers and turns clumps by their velocities, and puts members where they then are.
void moveGeneral(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT);

/// Puts members where the clumps are, with their orientation: in the grains, and unwrapped in the list.
void putMembers(ContactList& list, Grains& grains, const PeriodicBox& box);

/// Shifts and turns a clump, by displacements that give no velocity; its members follow with putMembers().
void displace(Grains& grains, std::size_t clump, const Vec3& shift, const Vec3& turn, const PeriodicBox& box);

/// Velocity and angular momentum after the step: L + dt t, and what the contacts' impulses add to it. To be called once the solves are over.
void copyGeneralVelocities(const ContactList& list, Grains& grains);

} // namespace nscd
