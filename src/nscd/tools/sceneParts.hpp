// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Small parts that most scenes are made of: a lattice of grains, a box of walls, gravity.
#pragma once

#include "nscd/step/grainDynamics.hpp"

#include <array>
#include <cstdint>
#include <functional>

namespace nscd
{

/// A regular arrangement of grains in a box: count[k] cells along axis k, a grain in the middle of each.
struct GrainLattice
{
    Vec3 lower;                  ///< corners of the box [m]
    Vec3 upper;
    std::array<int, 3> count;
    double diameter;             ///< mean [m]
    double spread = 0.0;         ///< diameters are uniform in diameter (1 +- spread)
    double jitter = 0.0;         ///< random shift: 0 none, 1 up to touching neighbors
    std::uint64_t seed = 1;      ///< of the random numbers, which are the same on every machine
};

/// Numbers uniform in [0, 1), one after the other.
using RandomNumbers = std::function<double()>;

/// Those of a seed, to 53 bits, the same on every machine.
RandomNumbers randomNumbers(std::uint64_t seed);

/// Calls add(center, diameter) for each grain of a lattice, x running fastest. Of the numbers each takes four: its shift along x, y, z, its diameter.
/// Errors: std::invalid_argument for a count below 1, a spread outside [0, 1), a jitter outside [0, 1]
void forEachGrain(const GrainLattice& lattice, const RandomNumbers& random, const std::function<void(const Vec3&, double)>& add);

/// Appends the grains of a lattice, at rest; identities go on from the number of grains there are.
/// Errors: as forEachGrain(), and what Grains::add refuses
void addLattice(Grains& grains, const GrainLattice& lattice, double density, int material);

/// Adds the six sides of a box that holds the grains, as infinite planes of one patch.
/// Errors: std::invalid_argument for a box without volume
void addBox(Walls& walls, int patch, const Vec3& lower, const Vec3& upper);

/// The grains' weight m g as forces for steps of length deltaT [s]; to be made anew when grains or step change.
/// Units:  gravity [m/s2]; speedScale = |g| dt
ExternalForces gravityForces(const Grains& grains, const Vec3& gravity, double deltaT);

} // namespace nscd
