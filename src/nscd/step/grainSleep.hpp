// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which grains are at rest and left alone, until what acts on them changes.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/externalForces.hpp"
#include "nscd/step/clumpLoads.hpp"

#include <vector>

namespace nscd
{

struct ContactForces;

/// What is to be known of a step at its end. `contact`: of the impulses that the list keeps, by grain.
struct RestingStep
{
    const ContactList& list;   ///< of all grains that are awake
    const ExternalForces& external;
    const ContactForces& contact;
    double deltaT;
    double speedScale;         ///< vs [m/s]
    double deadBand;           ///< [m]
};

/// Every `stepsToSleep` steps those grains fall asleep that since the last such step were slower than `restLimit` vs, on which the
/// contact force stayed what it was then to `restLimit` m vs/dt, and which touch no grain that fails in that and nothing that moves by itself. Velocities
/// become zero, impulses stay. A sleeping grain has no mobility; contacts of awake grains with it are solved as with a held one, and it
/// wakes in the step in which what these contacts, or the caller's forces, do to it differs by more than `restLimit` m vs/dt from when it fell
/// asleep. A clump sleeps as one body, with all its members or none: slow are all of them, and what counts of forces is their sum on it and the sum of
/// torques about its mass center.
class GrainSleep
{
public:
    /// Of speeds, in units of a step's speed scale vs, and of forces, in m vs/dt: some times what the residual of the solves leaves in a polished
    /// bed at rest. One number for both, since a grain that is stopped gives its momentum to those around it: with a tenth of it for forces
    /// these wake again, and others after them, for ever.
    static constexpr double restLimit = 1e-3;
    static constexpr int stepsToSleep = 32;
    /// Share of the grains that must be at rest for any to sleep: fewer save less than the next one that wakes costs, as in a flow.
    static constexpr double worthwhile = 0.1;

    /// On all ranks.
    bool any() const { return asleep_ > 0.0; }
    std::size_t count() const { return static_cast<std::size_t>(asleep_); }
    bool isWorthwhile() const { return any() && asleep_ >= worthwhile*grains_; }
    bool isAsleep(int grain) const { return any() && isAsleep_[grain] != 0; }

    /// Sleeping grains on which this step's external forces are others than when they fell asleep; of a clump one member.
    std::vector<int> disturbedBy(const Grains& grains, const ExternalForces& external, double deltaT) const;
    /// The same for contact forces, `onBodies` of the list.
    std::vector<int> disturbedBy(const Grains& grains, const ContactList& list, const ContactForces& onBodies, double deltaT) const;
    /// Sleeping grains that overlap a body of the list by more than `tolerance` [m]. Collective.
    std::vector<int> pressed(const Grains& grains, const ContactList& list, double tolerance) const;
    /// With all members of their clumps. Collective.
    void wake(const std::vector<int>& sleepers, const Halo& halo);

    /// After a step: counts quiet steps, and from time to time puts grains to sleep. Returns whether any fell asleep. Collective.
    bool fallAsleep(const RestingStep& step, Grains& grains);

private:
    bool isMember(std::size_t grain) const { return !clumpOf_.empty() && clumpOf_[grain] >= 0; }
    void makeRoom(const Grains& grains);
    std::vector<ClumpLoad> changes(const ContactList& list, const std::vector<Vec3>& force, const std::vector<Vec3>& torque, bool areOfBodies) const;
    void wakeOne(int grain);
    void countQuietSteps(const RestingStep& step, const Grains& grains);
    void countQuietClumps(const RestingStep& step, const Grains& grains);
    std::vector<std::uint8_t> restlessBodies(const RestingStep& step, const Grains& grains) const;
    void note(const RestingStep& step, int grain);

    std::vector<std::uint8_t> isAsleep_;                 // per grain; also held ones that do not move, which are not counted
    std::vector<int> quietSteps_;
    std::vector<int> clumpOf_;                           // empty where there are no clumps
    std::vector<Vec3> force_, torque_;                   // external, as of falling asleep
    std::vector<Vec3> contactForce_, contactTorque_;     // as of falling asleep, and of awake grains as of the last look
    std::size_t asleepHere_ = 0;
    double asleep_ = 0.0, grains_ = 0.0;                 // on all ranks
    int steps_ = 0;
    double speedScale_ = 0.0;
};

} // namespace nscd
