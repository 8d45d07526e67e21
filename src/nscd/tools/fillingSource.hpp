// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a region is to be filled with before the first step.
// Tested by tests/unit/nscd/tools/fillingTest.cpp
#pragma once

#include "nscd/tools/regions.hpp"
#include "nscd/tools/sizeDistributions.hpp"

namespace nscd
{

enum class FillingAmount { number, mass, solidFraction };

struct FillingSource
{
    Region region;                                   ///< that grains lie in whole
    SizeDistribution sizes;
    double density = 0.0;                            ///< [kg/m3]
    FillingAmount measure = FillingAmount::number;
    double amount = 0.0;                             ///< number [-], mass [kg] or solid fraction of the region [-]
    bool isPacked = false;                           ///< dense: the solid fraction is that of the region's interior
    std::uint64_t seed = 1;
};

/// Of a region; in a plane its area times the length of discs there [m3].
inline double volumeOf(const Region& region, const GrainShape& shape) { return region.volume*(shape.emptyAxis >= 0 ? shape.thickness : 1.0); }

/// Solid fractions that no packing at random exceeds: 0.64 of equal spheres in space (Scott and Kilgour 1969, doi 10.1088/0022-3727/2/6/311), 0.84 of
/// equal discs in a plane.
inline double densestPacking(int dimensions) { return dimensions == 2 ? 0.84 : 0.64; }

/// Solid fractions at which addition at random ends for equal grains: 0.384 of spheres in space, 0.547 of discs (Torquato et al. 2006,
/// doi 10.1103/PhysRevE.74.061308); it gets slow before.
inline double densestAddition(int dimensions) { return dimensions == 2 ? 0.547 : 0.384; }

} // namespace nscd
