// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Settings of contact search and contact solve.
#pragma once

#include "input/scene/scene.hpp"

namespace input
{

/// `solver` into scene.contact; materials and sources have been read. Where grains at rest cannot sleep, scene.notes says so.
/// Errors: InputError for values out of range, for solvers that cannot do what the materials, the ranks or this processor ask for, and for
///         laws beside Coulomb's between clumps
void readContactSettings(const CheckedEntries& top, const Surroundings& around, Scene& scene);

} // namespace input
