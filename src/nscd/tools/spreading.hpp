// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spheres that overlap, moved apart until none does.
// Tested by tests/unit/nscd/tools/fillingTest.cpp
#pragma once

#include "nscd/tools/randomAddition.hpp"

namespace nscd
{

struct SpreadReport
{
    int sweeps = 0;
    bool isDone = false;        ///< whether no overlap is left
    double overlap = 0.0;       ///< the deepest one left, in diameters of the smaller sphere
};

/// Moves spheres apart, and off the obstacles of their space and other spheres, which stay.
/// Equation: sweeps over the pairs that overlap, one after the other: both centers go back along their line by omega/2 times the overlap, off an
///           obstacle by the whole of it, until the deepest overlap of spheres swollen by 1 + 5e-4 is below 5e-4 of the smaller one's diameter
/// Ensures:  isDone: no overlap at all; else after `mostSweeps`: what is left
SpreadReport spreadApart(const FillingSpace& space, const Spheres& others, int mostSweeps, Spheres& spheres);

} // namespace nscd
