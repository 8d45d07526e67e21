// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains put where the sources of a scene say.
#pragma once

#include "input/scene/scene.hpp"
#include "input/lists/grainFiles.hpp"

#include <limits>

namespace input
{

/// The coarse-graining factors of grains that are numbered one after the other.
class PlacedFactors
{
public:
    /// All grains from a number on, which is not below those before.
    void setFrom(std::int64_t number, double factor);

    double of(std::int64_t number) const;
    bool areAllOne() const { return steps_.empty(); }

private:
    struct Step
    {
        std::int64_t first;
        double factor;
    };

    std::vector<Step> steps_;   ///< where the factor changes, from 1
};

/// What differs between programs that place grains.
struct PlacementTools
{
    std::function<nscd::RandomNumbers(std::uint64_t seed)> randomNumbers = nscd::randomNumbers;   ///< of lattices
    std::function<std::vector<Vec3>(const std::string& path, const Place& source)> readPositions = readPositionsFile;
    std::size_t grainsInBatch = std::numeric_limits<std::size_t>::max();   ///< clumps need all grains in one
    const nscd::Walls* walls = nullptr;   ///< that fillings keep off; left out: those of the scene
    std::function<void(const std::string&)> tell = [](const std::string&) {};   ///< what the log should say of fillings
    PlacedFactors* factors = nullptr;     ///< of coarse grains; left out: there are none
};

/// Takes the next grains of a scene.
using GrainTaker = std::function<void(nscd::Grains&)>;

/// Hands over the grains of all sources, numbered from 0 in the order of the sources, inside the periodic box; so many at a time: whoever keeps few
/// of them needs no memory for all.
/// Memory: a file that lists grains is read as a whole
/// Errors: InputError for files that are missing or wrong, with their line, and unknown materials in them
void placeGrains(const Scene& scene, const Surroundings& around, const PlacementTools& tools, const GrainTaker& take);

} // namespace input
