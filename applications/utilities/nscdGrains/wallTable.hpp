// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// walls.csv: force and torque of the grains on each wall, a row per time step, with the columns that nscdDEMFoam's has.
#pragma once

#include "csvFile.hpp"

#include "nscd/step/grainDynamics.hpp"

namespace nscdGrains
{

class WallTable
{
public:
    /// Errors: std::runtime_error as CsvFile's
    WallTable(const std::string& path, const nscd::Walls& walls, bool goesOn, double keepUpTo);

    /// The row of the last step, at the time of its end [s]. Force [N], torque about the wall's torquePoint [N m].
    void write(double time, const nscd::GrainDynamics& dynamics);

private:
    CsvFile file_;
};

} // namespace nscdGrains
