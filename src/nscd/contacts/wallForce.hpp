// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The force of a contact on its wall.
// Tested by tests/unit/nscd/scenes/drumTest.cpp, tests/unit/nscd/contacts/movingWallsTest.cpp
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Adds the force of a grain on the wall of a slot, and its torque, to `wall`: forces of the patches [N], then torques [N m].
void addWallForce(const ContactList& list, const Scene& scene, std::size_t slot, const Vec3& onGrain, std::vector<Vec3>& wall);

} // namespace nscd
