// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Filling a region with grains: loose at random, or packed.
#pragma once

#include "nscd/tools/fillingSource.hpp"
#include "nscd/tools/randomAddition.hpp"

namespace nscd
{

struct Filling
{
    Spheres grains;                    ///< in the order in which they were drawn, inside the scene's periodic box
    double solidFraction = 0.0;        ///< these grains over the whole region
    double interiorFraction = 0.0;     ///< of its interior, where a packing has one; else 0
    int sweeps = 0;                    ///< of packing
    int rounds = 0;                    ///< packings made until the interior had its fraction
};

/// Grains in a source's region, none of which overlaps another, one of `others` (fixed meanwhile), a wall or a side of the region. Sizes are drawn in
/// turn as long as the amount allows; what follows from seeds is the same on every machine and rank.
/// Method:   loose: addAtRandom(). Packed: the same with diameters made smaller so that they fill a tenth, which then get their size and are spread
///           apart; the number of grains is corrected until the interior, farther than two of the largest diameters from walls and sides, has the
///           solid fraction to 0.5 %, grains of `others` included. A region with less than 1000 grains of interior has the
///           fraction as a whole, without what lies behind planes.
/// Errors:   std::invalid_argument in words where the amount finds no room, or no grain is asked for
Filling fill(const FillingSource& source, const FillingPlace& place, const Spheres& others);

} // namespace nscd
