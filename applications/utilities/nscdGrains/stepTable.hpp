// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// report.csv: one row of numbers per time step, with the names that nscdDEMFoam's has.
#pragma once

#include "csvFile.hpp"

#include "nscd/base/vec3.hpp"
#include "nscd/scene/stepReport.hpp"
#include "nscd/tools/grainEntry.hpp"

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
    double mass = 0.0;                                  ///< of all grains [kg]
    nscd::EntryState entries = {};                      ///< of all sources that let grains in
};

class StepTable
{
public:
    /// Errors: std::runtime_error as CsvFile's
    StepTable(const std::string& path, bool goesOn, double keepUpTo);

    /// Appends a row, with every digit.
    void write(const StepRow& row);

private:
    CsvFile file_;
};

} // namespace nscdGrains
