// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The laws beside Coulomb's that a contact list has; none in plain scenes, which pay nothing.
// Tested by tests/unit/nscd/contacts/laws/contactLawsTest.cpp
#pragma once

#include "nscd/contacts/contactLaw.hpp"

namespace nscd
{

/// Asks all laws of a list, in the order of their rows; see ContactLaw.
class ListLaws
{
public:
    /// None.
    ListLaws() = default;
    /// Those in use between the materials.
    explicit ListLaws(const Materials& materials);

    bool empty() const { return laws_.empty(); }
    /// Whether any acts on spins.
    bool areOfSpins() const { return areOfSpins_; }
    /// Whether what any does in a step follows from the impulses at its start.
    bool areOfStart() const { return areOfStart_; }

    void resize(std::size_t slots);
    void set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB);
    void copy(const ListLaws& from, std::size_t source, std::size_t target);

    void beginStep(const ContactList& list);
    void giveKnown(ContactList& list, double deltaT, double deadBand);
    void startWarm(ContactList& list, double scale);
    void endSolve();
    void beginShock(ContactList& list);
    void chooseKernels(SweepKernels& kernels) const;

    /// Of the law that is solved within the sweeps; null where there is none.
    std::vector<LawBlock>* sweptBlocks() const;

    void addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const;
    Vec3 known(std::size_t slot) const;
    Vec3 moment(const ContactList& list, std::size_t slot) const;

    /// Whether any law keeps an impulse of its own.
    bool haveImpulses() const { return !keeping_.empty(); }
    LawImpulses impulses(std::size_t slot) const;
    void setImpulses(std::size_t slot, const LawImpulses& impulses);

private:
    std::vector<std::unique_ptr<ContactLaw>> laws_;
    /// Laws with an impulse of their own, and its place in LawImpulses.
    struct Keeping
    {
        ContactLaw* law;
        std::size_t place;
    };
    std::vector<Keeping> keeping_;
    bool areOfSpins_ = false;
    bool areOfStart_ = false;
};

} // namespace nscd
