// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Candidates of general bodies: which there are, and where they go in the list.
#pragma once

#include "nscd/contacts/contactBatching.hpp"
#include "nscd/contacts/contactList.hpp"

#include <vector>

namespace nscd
{

/// Clumps and their members as general bodies, for own bodies in the order `grainOf`.
GeneralBodies listGeneralBodies(const Clumps& clumps, const std::vector<int>& grainOf);

/// Takes out pairs of members of one body, which never meet.
void removeWithinBodies(std::vector<Candidate>& candidates, const GeneralBodies& general);

/// batchNearAndFar() for the others; candidates of general bodies go to blocks behind, in their order: no kernel works on them, so that lanes need
/// not be independent. Sets the list's first general block and makes its slots.
Batches batchWithGeneral(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter);

} // namespace nscd
