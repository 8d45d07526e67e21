// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A table that grows by a row per time step, its first column the time; a file that is being written can be plotted.
#pragma once

#include <fstream>
#include <string>

namespace nscdGrains
{

class CsvFile
{
public:
    /// Begins a file with `head`, whole lines; a run that goes on from `keepUpTo` [s] keeps the rows up to there, of a file that is there.
    /// Errors: std::runtime_error where it cannot be written, or where the file to go on with has another head
    CsvFile(const std::string& path, const std::string& head, bool goesOn, double keepUpTo);

    /// Appends a line and flushes it.
    /// Errors: std::runtime_error where it cannot be written
    void write(const std::string& line);

private:
    std::string path_;
    std::ofstream file_;
};

} // namespace nscdGrains
