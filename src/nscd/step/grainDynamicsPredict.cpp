// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step would end with: solves that move nothing.
// Tested by tests/unit/nscd/step/predictionTest.cpp, tests/unit/nscd/step/grainSleepTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include <limits>

namespace nscd
{

namespace
{

/// Of every slot of a list, in their order.
struct SlotImpulses
{
    std::vector<Vec3> r;               ///< [N s]
    std::vector<LawImpulses> ofLaws;   ///< empty where no law has any
};

SlotImpulses impulsesOf(const ContactList& list)
{
    SlotImpulses kept;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        kept.r.push_back(impulse(list, slot));
        if (list.laws.haveImpulses()) kept.ofLaws.push_back(list.laws.impulses(slot));
    }
    return kept;
}

void setImpulses(ContactList& list, const SlotImpulses& kept)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        setImpulse(list, slot, kept.r[slot]);
        if (list.laws.haveImpulses()) list.laws.setImpulses(slot, kept.ofLaws[slot]);
    }
}

/// A guess: what the last trial changed, on top of the impulses there are. Nothing pulls.
void addTrialChange(ContactList& list)
{
    for (std::size_t slot = 0; slot < list.trialChange.size(); ++slot)
    {
        const Vec3 guess = impulse(list, slot) + list.trialChange[slot];
        setImpulse(list, slot, guess.dot(normal(list, slot)) > 0.0 ? guess : Vec3(Vec3::Zero()));
    }
}

void noteTrialChange(ContactList& list, const SlotImpulses& before)
{
    list.trialChange.resize(list.slots());
    for (std::size_t slot = 0; slot < list.slots(); ++slot) list.trialChange[slot] = impulse(list, slot) - before.r[slot];
}

} // namespace

/// Of the solve that was made last. What sleeps outside the list has its forces of before. Members have the velocity of their clump's mass center:
/// what answers a force on any of them.
Prediction GrainDynamics::Implementation::predicted(SolveReport solve)
{
    Prediction prediction;
    prediction.solve = std::move(solve);
    prediction.velocity.assign(grains.size(), Vec3::Zero());
    for (int body = 0; body < list.owned(); ++body) prediction.velocity[list.grainOf[body]] = Vec3(list.bodies[body].v);
    for (std::size_t k = 0; k < list.general.ownMembers; ++k)
    {
        const GeneralMember& member = list.general.members[k];
        prediction.velocity[list.grainOf[member.body]] = list.general.bodies[member.owner].v;
    }
    ContactForces onGrains = forces;
    giveToGrains(forcesOnBodies(), list.grainOf, onGrains);
    prediction.contactForce = std::move(onGrains.force);
    return prediction;
}

/// Nobody is awake: nothing is solved.
Prediction GrainDynamics::Implementation::predictedRest() const
{
    return {std::vector<Vec3>(grains.size(), Vec3::Zero()), forces.force, restingReport().solve};
}

Prediction GrainDynamics::predict(const ExternalForces& external)
{
    Implementation& self = *self_;
    const auto timer = self.times.time(GrainPart::moveGrains);
    self.checkReady(external);
    self.wakeDisturbed(external);
    if (self.isEverybodyAsleep()) return self.predictedRest();
    if (!self.isStepBegun) self.beginAwakeStep(false);
    return self.predicted(self.solveVelocities(external));
}

/// A trial asks how velocities answer, to a tenth: neither for forces, nor for rest.
ContactSettings GrainDynamics::Implementation::ofTrial() const
{
    ContactSettings asked = settings;
    asked.polishSweeps = 0;
    asked.forceTolerance = std::numeric_limits<double>::infinity();
    return asked;
}

Prediction GrainDynamics::tryForces(const ExternalForces& external)
{
    Implementation& self = *self_;
    const auto timer = self.times.time(GrainPart::moveGrains);
    self.checkReady(external);
    if (self.isEverybodyAsleep()) return self.predictedRest();
    if (!self.isStepBegun) self.beginAwakeStep(false);
    // On the list as it is: nothing moves, so nothing can get past what is not listed.
    const SlotImpulses before = impulsesOf(self.list);
    addTrialChange(self.list);
    Prediction prediction = self.predicted(self.solveOnce(external, self.ofTrial()));
    noteTrialChange(self.list, before);
    setImpulses(self.list, before);
    return prediction;
}

} // namespace nscd
