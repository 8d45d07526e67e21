// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that would run into others, of other ranks, which stopped on their way.
// Tested by tests/parallel/dynamicsTest.cpp
#pragma once

#include "nscd/step/waysOfStep.hpp"

namespace nscd
{

/// Makes own bodies stop behind those of other ranks, and tells other ranks of theirs, through the contacts between ranks. Returns whether any
/// had to, on any rank: then others may have to stop behind them. On one rank: none.
bool stopBehindOtherRanks(const WaysOfStep& ways, std::vector<Stop>& stops);

} // namespace nscd
