// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A scene as plain structs: all that its dictionary may say, checked, with defaults. README.md shows every keyword.
#pragma once

#include "checkedEntries.hpp"

#include "nscd/tools/drivenGrains.hpp"
#include "nscd/tools/sceneParts.hpp"

namespace nscdGrains
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
    std::string type;                  ///< lattice, positionsFile, table
    nscd::GrainLattice lattice{};
    std::string file;                  ///< relative to the scene's folder, or absolute
    Place filePlace;
    double diameter = 0.0;             ///< [m] of positionsFile
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

/// Times and output.
struct RunSettings
{
    double deltaT = 0.0;               ///< [s]
    double endTime = 0.0;              ///< [s]
    double writeInterval = 0.0;        ///< [s]
    long purgeWrite = 2;               ///< states kept for a restart; 0: all
    std::string results = "results";   ///< folder, relative to the scene's, or absolute
};

struct SceneSettings
{
    std::string file;
    nscd::GrainShape shape;
    RunSettings run;
    Vec3 gravity = Vec3::Zero();       ///< [m/s2]
    MaterialTable materials;
    int wallMaterial = -1;             ///< of walls that do not say; -1: each must
    nscd::Walls walls;
    Words notes;                       ///< what the log should say of it
    nscd::PeriodicBox box;
    Place periodicPlace;
    std::vector<GrainSource> sources;
    std::vector<DrivenGroup> driven;
    double maxInitialOverlap = 0.01;   ///< in diameters of the smaller grain
    Place overlapPlace;
    nscd::ContactSettings contact;

    bool isPlanar() const { return shape.dimensions == 2; }
    /// A path of the dictionary, relative to its folder, as one that can be opened.
    std::string pathOf(const std::string& path) const;
};

/// Reads and checks a scene's dictionary.
/// Errors: SceneError
SceneSettings readScene(const std::string& path);

/// As readScene(), from text that need not be in a file.
SceneSettings parseScene(const std::string& text, const std::string& file);

} // namespace nscdGrains
