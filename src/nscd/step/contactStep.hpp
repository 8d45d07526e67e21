// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// From grains and forces to a contact problem, and back: free velocities, warm start, contact forces, motion.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/externalForces.hpp"
#include "nscd/step/grainSleep.hpp"

namespace nscd
{

/// Free velocity of every body (Henry 2025, eq. 2.11, with drag implicit in the grain): v = (m v + dt f)/(m + gamma dt), mobilities with it.
/// Held and sleeping grains have none of either mobility.
/// Units:   SI; list.bodies is overwritten
/// Errors:  std::invalid_argument for a force that is not finite, naming the grain
void setFreeVelocities(ContactList& list, const Grains& grains, const ExternalForces& forces, double deltaT, const GrainSleep& sleep);

/// Copies the velocities of the list's own bodies [m/s].
void keepVelocities(const ContactList& list, std::vector<Vec3>& velocity);

/// What forces change a grain's velocity by in a step that contacts let be: the smaller of the changes from `ofGrains`, at its start, to the free velocity
/// of its body and to that which the body has. What rests does not fall; what is hit changes by no more than forces do. Zero where no body of the list is the grain's.
void setFalls(const ContactList& list, const std::vector<Vec3>& ofGrains, const std::vector<Vec3>& freeVelocity, std::vector<double>& fall);

/// Whether, to the bit, no body moves along an axis or turns about another one, and all lie in one plane, on this rank.
bool isInPlane(const ContactList& list, int axis);

/// Sets W, bias and warm start of every slot, and adds the warm-start impulses to the bodies, which hold free velocities before.
/// A block sleeps if none of its contacts carries an impulse, is closed, or closes in the free motion.
/// Bias: (g - e)/dt where g > e, zero where |g| <= e or the gap is smaller (overlap is not corrected through velocity).
/// Warm start: impulses times impulseScale = dt_new/dt_old, tangential part turned into the new tangent plane and friction disc.
void prepareSlots(ContactList& list, const SweepKernels& kernels, double deltaT, double deadBand, double impulseScale);

/// Forces [N] and torques [N m] of contacts on each own body or grain; force of all ranks' grains on each wall patch [N], and its torque
/// about the patch's torquePoint [N m].
struct ContactForces
{
    std::vector<Vec3> force;
    std::vector<Vec3> torque;
    std::vector<Vec3> wall;
    std::vector<Vec3> wallTorque;
};

/// Sums the impulses of the blocks `loaded`, by body. What it returns lasts until the next sum; its memory is used again, since fresh pages in every
/// step cost more than the sums.
class ContactForceSum
{
public:
    ContactForceSum() = default;
    explicit ContactForceSum(const SweepKernels& kernels) : give_(kernels.giveImpulses) {}

    ContactForces& operator()(const ContactList& list, BlockRange loaded, const Scene& scene, double deltaT);

private:
    GiveFunction give_ = nullptr;
    std::vector<Body> impulses_;
    ContactForces sums_;
};

/// Writes forces on bodies to those on grains, whose numbers are given, and the ones on walls.
void giveToGrains(const ContactForces& onBodies, const std::vector<int>& grainOf, ContactForces& onGrains);

/// Whether every body stays within its reach if it moves on with its present velocity for deltaT, and `areWallsCovered` on all ranks.
bool coversMotion(const ContactList& list, double deltaT, bool areWallsCovered);

/// Copies velocities from bodies to grains.
void copyVelocities(const ContactList& list, Grains& grains);

/// Moves positions and turns orientations by the bodies' velocities (explicit in position, exact exponential in rotation).
/// Returns the largest displacement [m].
double moveGrains(ContactList& list, Grains& grains, const PeriodicBox& box, double deltaT, bool isRotating);

/// Depths [m] of overlaps: the deepest of all candidates; largest and mean of the contacts that carry an impulse.
struct OverlapStatistics
{
    double deepest = 0.0;
    double max = 0.0;
    double mean = 0.0;
};
OverlapStatistics measureOverlap(const ContactList& list);

/// Sets the bias of the second velocity solve: u_n + e u_n^- >= 0 for closed contacts whose free speed |u_n^-| exceeds the
/// threshold, u_n >= 0 for the other closed ones; open ones are out of reach. Closed are those of the list's awake blocks alone.
/// `freeBodies` are the velocities before contact. Returns whether any rebounds.
bool setRestitutionBias(ContactList& list, const std::vector<Body>& freeBodies, double threshold, double deadBand);

/// Of the awake blocks leaves those awake in which a contact carries an impulse or is in reach.
void leaveOutIdle(ContactList& list);

} // namespace nscd
