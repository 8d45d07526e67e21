// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing candidates into the blocks of a list.
#pragma once

#include "nscd/contacts/contactBatching.hpp"
#include "nscd/contacts/contactList.hpp"

#include <vector>

namespace nscd
{

/// Of own bodies, ghosts and copies.
std::vector<int> materialOfBodies(const ContactList& list, const Scene& scene);

/// Makes room for the blocks of an emptied list, and for those that strays may need later.
void reserveBlocks(ContactList& list, const Scene& scene, std::size_t needed);

/// Appends blocks for `batches`, and writes the candidates into their slots; slotOf is shifted to where they are.
void appendBlocks
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const std::vector<Candidate>& candidates, Batches& batches
);

} // namespace nscd
