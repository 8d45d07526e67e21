// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The small contact list that steps work on while most grains sleep, cut out of the list of all.
#pragma once

#include "nscd/step/contactStep.hpp"

namespace nscd
{

/// Holds the list of all contacts and the forces on all grains as they are between two steps, while a step works on a part: the awake
/// grains, all their candidates, and the sleeping grains among these, which have no mobility. What a step makes of the part is given back.
/// Nothing here costs more than the part does, but for holding a list and for finding who is awake.
/// On several ranks the part has all bodies, in the order of the list of all, so that ghosts and copies keep their places; hold, cut
/// and forcesOn are collective.
class AwakePart
{
public:
    /// Takes the list of all contacts, with geometry and impulses as between two steps.
    void hold(ContactList whole, ContactForceSum& sumForces, const Scene& scene, double deltaT);
    const ContactList& whole() const { return whole_; }
    ContactList& whole() { return whole_; }
    /// Gives the list of all contacts up again.
    ContactList release() { return std::move(whole_); }

    /// The part for those who are awake now; its impulses are those of the last step.
    ContactList cut(ContactForceSum& sumForces, const Scene& scene, const GrainSleep& sleep, double diameter, double deltaT);
    /// Whether nobody is awake, on any rank.
    bool isEmpty() const { return isEmpty_; }
    /// The impulse of a slot of the whole.
    struct Impulse
    {
        std::uint32_t slot;
        Vec3 r;
        LawImpulses ofLaws;
    };
    std::vector<Impulse> impulses(const ContactList& part) const;
    /// Gives these to the part that is in use, or to the whole where it is no longer held.
    void setImpulses(const std::vector<Impulse>& impulses, bool isPart, ContactList& list) const;

    /// Takes over what a step has made of a part.
    void giveBack(const ContactList& part, const ContactForces& onBodies);

    /// Contact forces on the part's bodies and on walls: of the part, and of the contacts outside it.
    const ContactForces& forcesOn(const ContactList& part, BlockRange loaded, ContactForceSum& sumForces, const Scene& scene, double deltaT) const;

    /// Of some sleeping grains and those around them through `rings` closed contacts, all that sleep, ascending.
    std::vector<int> sleepersAround(const std::vector<int>& grains, int rings, const GrainSleep& sleep, double deadBand) const;
    /// Sleeping grains that held grains in motion may meet.
    std::vector<int> sleepersBesideDriven(const Grains& grains, const GrainSleep& sleep) const;

private:
    void findSlotsOfBodies();
    int otherBody(std::size_t slot, int body) const;
    void findAwake(const GrainSleep& sleep);
    void addWholeClumps();
    void addGeneral(ContactList& part);
    template<class Visit> void forEachOfBody(int body, const Visit& visit) const;
    std::vector<std::uint32_t> slotsOfAwake();
    std::vector<std::uint32_t> interfaceSlotsOfAwake() const;
    void addBodies(ContactList& part) const;
    void packSlots(ContactList& part, const Scene& scene, double diameter);
    template<class Visit> void forEachSlot(const ContactList& part, const Visit& visit) const;

    ContactList whole_;
    ContactForces forces_;                           ///< on its bodies and on walls, of its impulses
    std::vector<int> bodyOf_;                        ///< of each grain
    std::vector<std::uint32_t> slotStart_, slots_;   ///< slots of body k: slots_[slotStart_[k] .. slotStart_[k+1])

    std::vector<std::uint8_t> isAwake_;              ///< of each body, ghosts and copies too
    std::vector<int> bodies_;                        ///< of the part, in the whole; own ones first, all members of a clump or none
    std::vector<std::uint32_t> slotInWhole_;         ///< of the part's slots in use
    ContactForces outside_;                          ///< of contacts that are not in the part, on its bodies and on walls
    bool isEmpty_ = false;
};

} // namespace nscd
