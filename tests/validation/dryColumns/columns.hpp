// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Columns of discs that collapse on a floor: how they are packed or read, and the figures of their shape.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <string>
#include <vector>

namespace columns
{

using nscd::Vec3;

/// Discs in the plane of x and z.
struct Disc
{
    double x;
    double z;
    double radius;
};

/// Rows `x y r marker` of Gerris' grains-*.dat, without the row of zeros.
/// Errors: std::runtime_error for a file that cannot be read
std::vector<Disc> readGerris(const std::string& file);
/// Rows `x y z d` of tutorials/grains/columnCollapse/constant/column.dat.
std::vector<Disc> readTutorial(const std::string& file);

/// About `number` discs of radius 2 to 3 mm settled between two smooth planes, with friction 0.2 between them: a rectangle of
/// height over half width `aspect`, about x = 0.
std::vector<Disc> pack(int number, double aspect, unsigned seed);

/// Discs on a floor at z = 0 without anything beside them.
scenes::Scene collapseScene(const std::vector<Disc>& discs, double friction, double restitution);

struct Shape
{
    double height;     ///< of the mass center [m]
    double distance;   ///< mean |x| [m]
    double reach;      ///< 99 % of the discs are within [m]
    double top;        ///< highest point [m]
};

/// Each disc counts once, as table A13 does.
Shape shapeOf(const std::vector<Vec3>& position, const std::vector<double>& radius);

/// Half the width of the part of the deposit that is at least one disc deep everywhere: single discs that roll away do not count.
double deposit(const std::vector<Vec3>& position, const std::vector<double>& radius);

} // namespace columns
