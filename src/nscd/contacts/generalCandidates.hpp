// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Candidates of general bodies: which there are, and where they go in the list.
#pragma once

#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/scene/exchange.hpp"

#include <vector>

namespace nscd
{

/// Clumps and their members as general bodies, for own bodies in the order `grainOf`.
GeneralBodies listGeneralBodies(const Clumps& clumps, const std::vector<int>& grainOf);

/// Takes out pairs of members of one body, which never meet.
void removeWithinBodies(std::vector<Candidate>& candidates, const GeneralBodies& general);

/// Whether any rank has clumps. Collective, where there may be some.
bool areClumpsAnywhere(const Clumps& clumps, const Exchange& exchange);

/// Adds ghosts and copies of general bodies to a list whose grains are joined with those of other ranks. `interface`: the candidates between ranks.
/// Collective.
void joinGeneralBodies(ContactList& list, const std::vector<Candidate>& interface, Exchange& exchange);

/// Makes the blocks of a list with general bodies. Single grains have theirs as in other lists; candidates of general bodies go to blocks behind, in
/// their order, those between ranks last. Makes the slots of general bodies.
CandidateSlots packWithGeneral(ContactList& list, const Scene& scene, const std::vector<int>& material, const Candidates& candidates, double diameter);

/// Whether the contact of a slot joins two ranks.
bool isBetweenRanks(const ContactList& list, std::size_t slot);

} // namespace nscd
