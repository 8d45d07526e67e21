// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Settings of contact search and contact solve.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `solver`. With a fluid nothing sleeps.
/// Errors: InputError for values out of range, and for solvers that cannot do what the materials, the ranks or this processor ask for
nscd::ContactSettings readContactSettings(const CheckedEntries& top, const nscd::Materials& materials, const Surroundings& around);

} // namespace input
