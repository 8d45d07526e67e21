// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that list grains, read in one go.
#pragma once

#include "input/dictionary/inputError.hpp"

#include "nscd/base/vec3.hpp"

namespace input
{

struct TableRow
{
    nscd::Vec3 position;      ///< [m]
    double diameter;          ///< [m]
    std::string material;     ///< empty: that of the source
    int line;
};

/// Positions of a list ( (x y z) (x y z) ... ), as OpenFOAM's kinematicCloudPositions: with or without a FoamFile header and their number.
/// Errors: InputError with file and line; with that of `source`, where the file was asked for, for one that is missing or empty
std::vector<nscd::Vec3> readPositionsFile(const std::string& path, const Place& source);

/// The same from the text of such a file.
std::vector<nscd::Vec3> parsePositions(const std::string& text, const std::string& path, const Place& source);

/// Rows of x y z d [material], separated by blanks or commas; # begins a comment.
/// Errors: as above, and for a diameter that is not positive
std::vector<TableRow> readGrainTable(const std::string& path, const Place& source);

} // namespace input
