// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlaps of general bodies are removed by displacements and turns.
#pragma once

#include "nscd/step/missedWalls.hpp"

namespace nscd
{

/// correctOverlaps() for scenes with general bodies, which are shifted and turned.
int correctGeneralOverlaps
(
    ContactList& list, Grains& grains, const Scene& scene, const std::vector<WallGap>& missed, double deepest, double tolerance, double deadBand
);

} // namespace nscd
