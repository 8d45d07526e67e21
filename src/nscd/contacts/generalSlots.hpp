// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contacts of general bodies as a step begins.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Sets W and bias of general contacts, as prepareSlots() does for the others.
void setGeneralLaws(ContactList& list, double deltaT, double deadBand, double unreachable);

/// Adds general blocks that matter to list.awake, and gives their bodies the impulses of the last step times `impulseScale`, made admissible.
void startGeneralSlots(ContactList& list, double impulseScale);

} // namespace nscd
