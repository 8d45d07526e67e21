// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One contact by itself: closed-form solution and defect, for solvers that visit contacts one by one.
#pragma once

#include "nscd/solvers/problem/stopRule.hpp"

namespace nscd
{

inline bool isUsed(const ContactBlock& block, int lane) { return block.invWn[lane] > 0.0; }

/// Change of a slot's impulse that solves its contact with all others held (src/nscd/method.md, "The contact law"), and its velocity defect.
struct LocalChange
{
    double impulse[3];  ///< on A, world frame [N s]
    double defect;      ///< |W dr| [m/s]
};

LocalChange localChange(const ContactProblem& problem, std::size_t slot);

/// The same with other mobilities than the contact's W_nn and W_tt [1/kg]: larger ones make a step that is shorter.
LocalChange localChange(const ContactProblem& problem, std::size_t slot, double wn, double wt);

/// Slots of blocks of the range whose defect exceeds the limit. Blocks of spheres or discs all of whose contacts are below half of it by the
/// natural map, which differs a little, are passed over at once.
std::vector<std::uint32_t> defectiveSlots(const ContactProblem& problem, BlockRange range, double limit);

/// Changes the slot's impulse and the velocities of its two bodies.
void apply(ContactProblem& problem, std::size_t slot, const LocalChange& change);

} // namespace nscd
