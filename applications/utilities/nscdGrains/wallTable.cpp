// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing walls.csv.
#include "wallTable.hpp"

#include "nscd/base/numberText.hpp"

namespace nscdGrains
{

namespace
{

std::string headLines(const nscd::Walls& walls)
{
    std::string units = "# units: s", names = "time";
    for (const nscd::WallPatch& patch : walls.patches)
    {
        units += ",N,N,N,N m,N m,N m";
        for (const char* column : {"forceX", "forceY", "forceZ", "torqueX", "torqueY", "torqueZ"}) names += "," + patch.name + "." + column;
    }
    return units + '\n' + names + '\n';
}

std::string textOf(const nscd::Vec3& v) { return "," + nscd::exact(v[0]) + "," + nscd::exact(v[1]) + "," + nscd::exact(v[2]); }

} // namespace

WallTable::WallTable(const std::string& path, const nscd::Walls& walls, bool goesOn, double keepUpTo)
:
    file_(path, headLines(walls), goesOn, keepUpTo)
{}

void WallTable::write(double time, const nscd::GrainDynamics& dynamics)
{
    std::string row = nscd::exact(time);
    for (std::size_t k = 0; k < dynamics.wallForce().size(); ++k) row += textOf(dynamics.wallForce()[k]) + textOf(dynamics.wallTorque()[k]);
    file_.write(row);
}

} // namespace nscdGrains
