// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A law of contacts beside Coulomb's and Newton's: what one has to tell, and the table of all there are.
// Tested by tests/unit/nscd/contacts/laws/contactLawsTest.cpp
#pragma once

#include "nscd/kernels/contactBlock.hpp"
#include "nscd/scene/materials.hpp"
#include "nscd/scene/storedImpulse.hpp"

#include <memory>
#include <vector>

namespace nscd
{

struct ContactList;
struct Scene;

/// Sums over contacts: on each body of a list; on each wall patch, forces of all patches and then their torques.
struct ContactSums
{
    std::vector<Vec3>& force;    ///< [N]
    std::vector<Vec3>& torque;   ///< [N m]
    std::vector<Vec3>& wall;     ///< [N], then [N m]
};

/// One object for each law in use belongs to a contact list and keeps what it needs of each slot (a lane of a block). A step asks it in the order
/// of the functions below; what a law does not have it leaves as it is here.
class ContactLaw
{
public:
    virtual ~ContactLaw() = default;

    /// Makes room for all slots of the list; those added are idle.
    virtual void resize(std::size_t slots) = 0;
    /// Coefficients of a slot. `radiusB`: 0 at a wall.
    virtual void set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB) = 0;
    /// Takes all that the same law of another list has of a slot.
    virtual void copy(const ContactLaw& from, std::size_t source, std::size_t target) = 0;

    /// The list is as a step finds it, with the impulses of the last one.
    virtual void beginStep(const ContactList&) {}
    /// Gives the bodies of a list, which have their free velocities, impulses that are known beforehand; gaps, normals and biases are set.
    virtual void giveKnown(ContactList&, double /*deltaT*/, double /*deadBand*/) {}
    /// Gives the bodies, which have the warm impulses of contacts, the law's own impulses of the last step times `scale`, made admissible.
    virtual void startWarm(ContactList&, double /*scale*/) {}

    /// What sweeps solve with the impulses, a block for each of the list; null: nothing. One law in use may have some.
    virtual std::vector<LawBlock>* sweptBlocks() { return nullptr; }

    /// The passes over these blocks, where they are not those over moments.
    virtual void chooseKernels(SweepKernels&) const {}
    /// The list has been solved, for the step's motion or for a trial of it.
    virtual void endSolve() {}
    /// The rebounds come next, from the bodies' free velocities: adds impulses that the motion has given and rebounds do not change.
    virtual void beginShock(ContactList&) {}

    /// Adds what the law made of a step; here, the impulses that known() has.
    virtual void addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const;
    /// Impulse known beforehand of a slot, on A [N s].
    virtual Vec3 known(std::size_t /*slot*/) const { return Vec3::Zero(); }
    /// Moment impulse of a slot on A [N m s].
    virtual Vec3 moment(const ContactList&, std::size_t /*slot*/) const { return Vec3::Zero(); }

    /// The law's own impulse of a slot, on A, of those rows that have one [N s].
    virtual Vec3 impulse(std::size_t /*slot*/) const { return Vec3::Zero(); }
    virtual void setImpulse(std::size_t /*slot*/, const Vec3&) {}
};

/// A law that keeps a struct for each slot.
template<class Slot>
class LawOfSlots : public ContactLaw
{
public:
    void resize(std::size_t slots) override { slots_.resize(slots); }
    void copy(const ContactLaw& from, std::size_t source, std::size_t target) override
    {
        slots_[target] = static_cast<const LawOfSlots&>(from).slots_[source];
    }

protected:
    std::vector<Slot> slots_;
};

/// Copies what a law has of one contact.
inline void copyLane(const LawBlock& from, int lane, LawBlock& to, int place)
{
    for (int k = 0; k < 3; ++k) to.q[k][place] = from.q[k][lane];
    for (int k = 0; k < 4; ++k) to.of[k][place] = from.of[k][lane];
}

struct ContactLawRow
{
    const char* words;           ///< what users call it, for messages and logs
    const char* impulseName;     ///< of the impulse that it keeps of a contact, in files; null: it keeps none
    bool isSwept;                ///< whether it is solved within the sweeps: one such law in a scene, with NLGS alone
    bool isOfClumps;             ///< whether it works where there are clumps
    bool isOfSpins;              ///< whether it acts on spins
    bool isOfStart;              ///< whether what it does in a step follows from the impulses at its start
    bool (*isUsed)(const Materials&);
    double (*range)(const Materials&);             ///< largest gap that it acts across [m]
    std::unique_ptr<ContactLaw> (*make)();
};

/// All laws beside Coulomb's; a new one is a file in contacts/laws, a row there, and its coefficients in ContactPair.
const std::vector<ContactLawRow>& contactLaws();

/// Rows in use between any materials.
std::vector<const ContactLawRow*> lawsInUse(const Materials& materials);

/// Largest gap that any law acts across [m].
double rangeOfLaws(const Materials& materials);

/// Whether anything in contacts acts on spins: without, grains do not turn.
bool actsOnSpins(const Materials& materials);

} // namespace nscd
