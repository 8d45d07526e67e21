// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// report.csv: one row of numbers per time step, with the names that nscdDEMFoam's has.
#pragma once

#include "stepReport.hpp"
#include "vec3.hpp"

#include <cstdint>
#include <fstream>
#include <string>

namespace nscdGrains
{

/// What a step reports of itself.
struct StepRow
{
    double time = 0.0;         ///< at the end of the step [s]
    double deltaT = 0.0;       ///< [s]
    std::size_t grains = 0;
    nscd::StepReport report;
    double kineticEnergy = 0.0;                         ///< [J]
    nscd::Vec3 massCenter = nscd::Vec3::Zero();         ///< [m]
    nscd::Vec3 wallForce = nscd::Vec3::Zero();          ///< of the grains on all walls [N]
};

/// Writes rows as they come; a file that is being written can be plotted.
class StepTable
{
public:
    /// Begins a file; a run that goes on from `keepUpTo` [s] keeps the rows up to there.
    /// Errors: std::runtime_error where it cannot be written, or where the file to go on with has other columns
    StepTable(const std::string& path, bool goesOn, double keepUpTo);

    /// Appends a row, with every digit, and flushes it.
    void write(const StepRow& row);

private:
    std::string path_;
    std::ofstream file_;
};

} // namespace nscdGrains
