// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Triangulated surfaces from STL files.
#pragma once

#include "nscd/scene/walls.hpp"

namespace nscd
{

/// Triangles of all solids of an STL file, ASCII or binary, vertices times `scale`. Normals in the file are not used: they follow
/// from the order of the vertices. Names of solids are not kept.
/// Errors: std::invalid_argument that names the file and the line (ASCII) or triangle (binary), for a file that cannot be read, is no STL
///         file, is truncated, has no triangle or a coordinate that is not finite; for a scale that is not finite and positive
std::vector<Triangle> readStl(const std::string& path, double scale = 1.0);

} // namespace nscd
