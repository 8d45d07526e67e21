// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that list grains, read in one go.
#pragma once

#include "sceneError.hpp"

#include "nscd/base/vec3.hpp"

namespace nscdGrains
{

struct TableRow
{
    nscd::Vec3 position;      ///< [m]
    double diameter;          ///< [m]
    std::string material;     ///< empty: that of the source
    int line;
};

/// Positions of a list ( (x y z) (x y z) ... ), as OpenFOAM's kinematicCloudPositions: with or without a FoamFile header and their number.
/// Errors: SceneError with file and line
std::vector<nscd::Vec3> readPositionsFile(const std::string& path, const Place& source);

/// Rows of x y z d [material], separated by blanks or commas; # begins a comment.
/// Errors: SceneError with file and line
std::vector<TableRow> readGrainTable(const std::string& path, const Place& source);

} // namespace nscdGrains
