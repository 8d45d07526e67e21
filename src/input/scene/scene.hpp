// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What nscdGrains and nscdDEMFoam both read, as plain structs.
#pragma once

#include "input/dictionary/checkedEntries.hpp"

#include "nscd/tools/drivenGrains.hpp"
#include "nscd/tools/fillingSource.hpp"
#include "nscd/tools/grainEntry.hpp"
#include "nscd/tools/sceneParts.hpp"

#include <cmath>
#include <limits>
#include <map>

namespace input
{

/// Materials with what the grain library does not keep of them.
struct MaterialTable
{
    nscd::Materials table;
    std::vector<double> density;       ///< [kg/m3], 0 for a material that only walls may use
    std::vector<Place> place;
    Place contactsPlace;

    /// Names of the materials that grains may be made of.
    Words grainMaterials() const;
};

/// Clumps in the places of a source's grains.
struct ClumpSource
{
    std::vector<nscd::Ball> members;   ///< empty: single grains
    bool isRandom = true;              ///< orientation, or that of the members as given
    std::uint64_t seed = 1;
};

/// Where some of the grains come from.
struct GrainSource
{
    Place place;
    std::string type;                  ///< lattice, positionsFile, table, filling, time
    nscd::GrainLattice lattice{};
    nscd::FillingSource filling{};
    Place amountPlace;                 ///< of what says how much a filling is
    std::string file;                  ///< as written; of a written time the folder of its case
    Place filePlace;
    std::string time;                  ///< written time of another case, a number or latestTime
    Place timePlace;
    double diameter = 0.0;             ///< [m] of positionsFile
    double coarseGraining = 1.0;       ///< diameter of a body, a parcel, over that of the real grains it stands for; sizes here are the bodies'
    int material = 0;
    Vec3 velocity = Vec3::Zero();      ///< [m/s]
    Vec3 omega = Vec3::Zero();         ///< [rad/s]
    bool isFixed = false;
    ClumpSource clump;
};

/// Grains that move as told.
struct DrivenGroup
{
    Place place;
    nscd::DrivenGrains grains;
};

/// Grains as another run has written them.
struct WrittenGrains
{
    nscd::Grains grains;
    std::vector<double> coarseGraining = {};   ///< of each; empty: all are real
};

struct Scene
{
    MaterialTable materials;
    int wallMaterial = -1;             ///< of walls that do not say; -1: each must
    nscd::Walls walls;                 ///< of `planes` and `walls`, at the poses that they are given in
    std::vector<Place> wallPlaces;     ///< of their patches
    Words notes;                       ///< what the log should say of them
    std::vector<GrainSource> sources;
    bool hasCoarseGrains = false;      ///< whether a source names `coarseGraining`
    std::vector<nscd::EntrySource> entries;
    std::vector<Place> entryPlaces;    ///< of their regions
    std::vector<DrivenGroup> driven;
    double fixedUntil = std::numeric_limits<double>::infinity();   ///< when held grains that no group drives are let go [s]
    double maxInitialOverlap = 0.01;   ///< in diameters of the smaller grain
    Place overlapPlace;
    nscd::ContactSettings contact;

    bool hasClumps() const;
    bool letsFixedGo() const { return std::isfinite(fixedUntil); }
    bool hasEntries() const { return !entries.empty(); }
    bool hasAnySource() const { return hasEntries() || !sources.empty(); }
};

/// A path as written, as one that can be opened.
using PathOf = std::function<std::string(const std::string&)>;

struct Surroundings;

/// A region that grains enter, for radii [m] up to the one given.
using ReadEntryRegion = std::function<nscd::EntryRegion(const CheckedEntries&, const Surroundings&, double largestRadius)>;

using ReadSizes = std::function<nscd::SizeDistribution(const CheckedEntries&)>;

/// The grains of a written time, in the order of their identities, as they were.
using GrainsOfTime = std::function<WrittenGrains(const GrainSource&, const MaterialTable&)>;

/// What a program tells the readers: of the space that grains live in, and of what it can do.
struct Surroundings
{
    nscd::GrainShape shape;            ///< in 2D with its emptyAxis
    double midPlane = 0.0;             ///< in 2D: coordinate of all centers along emptyAxis, whatever their source gives [m]
    nscd::PeriodicBox box;
    PathOf pathOfGrains = [](const std::string& path) { return path; };
    PathOf pathOfSurface = [](const std::string& path) { return path; };
    int nRanks = 1;
    bool sleepsByDefault = true;       ///< grains at rest, where `sleep` is not given
    bool hasFluid = false;             ///< whether grains may take the velocity of one when they enter
    bool hasCoarseGrains = false;      ///< whether bodies may stand for several real grains

    // What the program alone knows, by the word that stands for it.
    std::map<std::string, ReadEntryRegion> entryRegions = {};
    std::map<std::string, ReadSizes> sizeModels = {};       ///< their numbers are in a dictionary <type>Distribution
    GrainsOfTime grainsOfTime = nullptr;                    ///< null: no times of other cases can be read

    bool isEmpty(int axis) const { return axis == shape.emptyAxis; }
};

} // namespace input
