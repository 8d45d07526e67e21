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

/// Blocks to be kept free for strays, for a number of blocks in use.
std::size_t blocksForStrays(std::size_t used);

/// Makes room for the blocks of an emptied list.
void reserveBlocks(ContactList& list, const Scene& scene, std::size_t needed);

/// Appends blocks without contacts.
void appendFreeBlocks(ContactList& list, const Scene& scene, std::size_t number);

/// Writes candidates into free blocks, from the block `first` on; slotOf is shifted to where they are.
void writeCandidates
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const std::vector<Candidate>& candidates, Batches& batches, std::size_t first
);

/// Appends blocks for `batches`, and writes the candidates into them.
void appendBlocks
(
    ContactList& list, const Scene& scene, const std::vector<int>& material, const std::vector<Candidate>& candidates, Batches& batches
);

} // namespace nscd
