// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Normals and gaps of all candidates at the present positions.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Recomputes normals and gaps at the present positions.
/// Errors: std::invalid_argument for coincident centers, naming the grains
void updateGeometry(ContactList& list, const Scene& scene);

/// The same, of pairs of grains alone, in the blocks first .. end - 1.
void updatePairs(ContactList& list, const Scene& scene, std::size_t first, std::size_t end);

} // namespace nscd
