// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Closed surfaces for the tests of regions and of what fills them.
#pragma once

#include "nscd/scene/walls.hpp"

namespace closedSurfaces
{

/// The twelve triangles of the box (0 0 0) (1 2 3), turned outwards.
inline std::vector<nscd::Triangle> boxOfTriangles()
{
    const auto corner = [](int k) { return nscd::Vec3(k & 1, 2*((k >> 1) & 1), 3*(k >> 2)); };
    const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::vector<nscd::Triangle> triangles;
    for (const auto& side : sides)
    {
        triangles.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
        triangles.push_back({corner(side[0]), corner(side[2]), corner(side[3])});
    }
    return triangles;
}

} // namespace closedSurfaces
