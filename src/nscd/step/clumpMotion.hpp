// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step does to clumps before and after its solve.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/externalForces.hpp"

namespace nscd
{

/// Raises `extremes`, of the grains that move the largest mass [kg] and the largest inverse of one [1/kg], to those of the clumps.
void measureClumps(const Clumps& clumps, double (&extremes)[2]);

/// Free motion of clumps: v + dt f/m, and the spin that L + dt t makes of itself in the step (midpointSpin: eq. 2.7 of the method). Forces
/// on members act at the mass center of their clump, so that weight turns nothing; their torques add up.
/// Members among the list's bodies get the velocities.
/// Errors: std::invalid_argument for implicit drag on a member
void setFreeClumps(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT);

/// Gives members among the list's bodies the velocities of their clumps, to be called after a solve.
void takeClumpVelocities(ContactList& list, const GrainShape& shape);
/// Gives members among `bodies` the free velocities of the step.
void mirrorFreeClumps(const ContactList& list, std::vector<Body>& bodies);

/// Moves mass centers and turns clumps by their velocities, and puts members where they then are.
void moveClumps(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT);

/// Puts members where the clumps are, with their orientation: in the grains, and unwrapped in the list.
void putMembers(ContactList& list, Grains& grains, const PeriodicBox& box);

/// Velocity and angular momentum after the step: L + dt t, and what the contacts' impulses add to it. To be called once the solves are over.
void copyClumpVelocities(const ContactList& list, Clumps& clumps);

} // namespace nscd
