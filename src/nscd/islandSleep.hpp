// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Islands of grains at rest, left alone until something changes.
#pragma once

#include "contactList.hpp"
#include "grainDynamics.hpp"

#include <unordered_set>
#include <vector>

namespace nscd
{

/// An island is a set of grains that touch, directly or through one another; walls and held grains join nothing. It falls asleep when
/// all its grains were slower than `restSpeed` vs for `stepsToSleep` steps: velocities become zero, impulses stay. It wakes in the
/// step in which the force or torque on one of its grains differs by more than `disturbance` m vs/dt from what it fell asleep with, or
/// something awake touches it. A sleeping grain has no mobility, so that nothing of it is solved.
class IslandSleep
{
public:
    /// In units of a step's speed scale vs: what grains of a polished bed at rest keep at most of the noise of the solves, a few times
    /// over. A grain whose acceleration is less than a thirtieth of it, 3e-5 g, is taken for one at rest.
    static constexpr double restSpeed = 1e-3;
    /// The same for forces: by so much the contact forces of a sleeping island may be out of date.
    static constexpr double disturbance = 1e-4;
    static constexpr int stepsToSleep = 32;

    bool any() const { return asleep_ > 0; }
    /// Nobody is awake, and no held grain moves.
    bool isEverybodyAsleep() const { return isEverybodyAsleep_; }
    std::size_t count() const { return asleep_; }
    bool isAsleep(int grain) const { return asleep_ > 0 && isAsleep_[grain] != 0; }

    /// As it was made: a run that goes on and one that starts from here do the same.
    void wakeAll() { *this = IslandSleep(); }

    /// Wakes what the forces of this step disturb.
    void wakeByForces(const Grains& grains, const ExternalForces& forces, double deltaT);

    /// Wakes islands that an awake or moving body touches, or will in this step at the bodies' present velocities.
    /// Returns whether there were any.
    bool wakeByContacts(const ContactList& list, double deltaT, double deadBand);

    /// After a step: counts quiet steps, and from time to time puts islands to sleep. `forces` are those of the step.
    void fallAsleep(const ContactList& list, Grains& grains, const ExternalForces& forces, double speedScale, double deadBand);

private:
    void wakeIslands(const std::unordered_set<int>& islands);
    bool isMoving(const ContactList& list, int body) const;
    void countQuietSteps(const Grains& grains, double limit);
    /// Of each body its island: the body that stands for it, or none if one of its grains is not at rest.
    std::vector<int> quietIslands(const ContactList& list, const Grains& grains, double deadBand) const;
    bool isEverythingStill(const Grains& grains) const;

    std::vector<std::uint8_t> isAsleep_;   // per grain
    std::vector<int> quietSteps_;
    std::vector<int> island_;              // of sleeping grains
    std::vector<Vec3> force_, torque_;     // with which they fell asleep
    std::size_t asleep_ = 0;
    bool isEverybodyAsleep_ = false;
    int steps_ = 0;
    int firstIsland_ = 0;                  // of those that fall asleep next
    double speedScale_ = 0.0;
};

} // namespace nscd
