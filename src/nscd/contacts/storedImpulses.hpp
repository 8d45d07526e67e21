// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Impulses that outlive their list: taken from one, given to the next.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/scene/storedImpulse.hpp"

namespace nscd
{

/// A contact's impulse by the grains' indices; `b` < 0 means wall region -1 - b.
struct PairImpulse
{
    int a;
    int b;
    Vec3 impulse;  ///< on a [N s]
};

/// A contact's impulse where one grain is another rank's.
struct InterfaceImpulse
{
    int own;           ///< index of the own grain
    std::int64_t id;   ///< of the other
    Vec3 impulse;      ///< on the own one [N s]
};

struct ImpulseRecord
{
    std::vector<PairImpulse> inner;
    std::vector<InterfaceImpulse> interface;
    /// Impulses that laws keep of the same entries, on the same bodies; empty in scenes without.
    std::vector<LawImpulses> innerOfLaws;
    std::vector<LawImpulses> interfaceOfLaws;

    bool isEmpty() const { return inner.empty() && interface.empty(); }
};

/// A slot that carries an impulse.
struct SlotImpulse
{
    std::size_t slot;
    PairImpulse pair;   ///< ghosts by ContactList::grain
};

/// Contacts whose impulse is not zero, or that attract; impulses without attraction.
std::vector<SlotImpulse> loadedSlots(const ContactList& list);
/// Impulses that are not zero.
ImpulseRecord collectImpulses(const ContactList& list);

/// Gives each candidate the impulse its pair had; of several images of a pair, the one best aligned with the impulse gets it.
/// What another rank solves now is handed to it (collective).
void assignImpulses(ContactList& list, ImpulseRecord record, Exchange& exchange);

std::vector<StoredImpulse> byIdentity(const ImpulseRecord& record, const Grains& grains);

/// Each entry's grains, one at least, are own ones; of other entries nothing is kept.
ImpulseRecord byIndex(const std::vector<StoredImpulse>& impulses, const Grains& grains);

} // namespace nscd
