// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Candidates of clumps: which there are, and where they go in the list.
#pragma once

#include "nscd/contacts/contactBatching.hpp"
#include "nscd/contacts/contactList.hpp"

#include <vector>

namespace nscd
{

/// Takes out pairs within one clump, which never meet.
void removeWithinClumps(std::vector<Candidate>& candidates, const ClumpList& clumps);

/// batchNearAndFar() for the others; candidates of clumps go to blocks behind, in their order: no kernel works on them, so that lanes need
/// not be independent. Sets the list's first block of clumps and makes their slots.
Batches batchWithClumps(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates, double diameter);

} // namespace nscd
