// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Order along a space-filling curve, so that neighbors in space are neighbors in memory.
#pragma once

#include "nscd/base/vec3.hpp"

#include <vector>

namespace nscd
{

/// Bodies sorted along a Morton curve with cells of the given size; ties keep their order.
std::vector<int> mortonOrder(const std::vector<Vec3>& position, double cellSize);

} // namespace nscd
