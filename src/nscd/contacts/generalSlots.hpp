// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contacts of general bodies as a step begins.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Sets W, bias and warm start of general contacts, as prepareSlots() does for the others, and adds blocks that matter to list.awake.
void prepareGeneralSlots(ContactList& list, double deltaT, double deadBand, double unreachable, double impulseScale);

} // namespace nscd
