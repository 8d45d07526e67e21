// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Impulses by the identities of grains, which outlive indices.
#pragma once

#include "contactList.hpp"
#include "grainDynamics.hpp"

namespace nscd
{

std::vector<StoredImpulse> byIdentity(const std::vector<PairImpulse>& impulses, const Grains& grains);

/// Impulses whose grains are not there any more are left out.
std::vector<PairImpulse> byIndex(const std::vector<StoredImpulse>& impulses, const Grains& grains);

} // namespace nscd
