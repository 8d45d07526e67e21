// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A scene as plain structs: all that its dictionary may say, checked, with defaults. scene.example shows every keyword.
#pragma once

#include "input/scene/scene.hpp"

namespace nscdGrains
{

using nscd::Vec3;

/// Times and output.
struct RunSettings
{
    double deltaT = 0.0;               ///< [s]
    double endTime = 0.0;              ///< [s]
    double writeInterval = 0.0;        ///< [s]
    long purgeWrite = 2;               ///< states kept for a restart; 0: all
    std::string results = "results";   ///< folder, relative to the scene's, or absolute
};

struct SceneSettings : input::Scene
{
    std::string file;
    nscd::GrainShape shape;
    RunSettings run;
    Vec3 gravity = Vec3::Zero();       ///< [m/s2]
    nscd::PeriodicBox box;
    input::Place periodicPlace;

    bool isPlanar() const { return shape.dimensions == 2; }
    /// A path of the dictionary, relative to its folder, as one that can be opened.
    std::string pathOf(const std::string& path) const;
    /// What the readers and the placement of grains ask for.
    input::Surroundings surroundings() const;
};

/// Reads and checks a scene's dictionary.
/// Errors: input::InputError
SceneSettings readScene(const std::string& path);

/// As readScene(), from text that need not be in a file.
SceneSettings parseScene(const std::string& text, const std::string& file);

/// The grains of all sources, discs at z = 0; driven ones are held.
/// Errors: input::InputError for files that are missing or wrong, with their line, and for driven grains that are not there
/// `tell` takes what the log should say of fillings.
nscd::Grains placeGrains(const SceneSettings& scene, const std::function<void(const std::string&)>& tell = [](const std::string&) {});

/// Refuses what no run can start from: pairs of materials without coefficients, periods that are too short, overlaps.
void checkGrains(const SceneSettings& scene, const nscd::Grains& grains);

/// The same of grains of a state, with the walls where they are at its time [s], and overlaps that no run leaves behind.
void checkGrainsOfRestart(const SceneSettings& scene, const nscd::Grains& grains, double time);

} // namespace nscdGrains
