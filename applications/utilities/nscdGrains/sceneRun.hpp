// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A scene from its dictionary to its results.
#pragma once

#include <ostream>
#include <string>

namespace nscdGrains
{

struct RunOptions
{
    std::string scene = "scene";   ///< path of the dictionary
    bool goesOn = false;           ///< from the state written last
    bool overwrites = false;       ///< results of an earlier run
    std::string table = "";        ///< path of a table that the first grains are written to, in place of a run
};

/// Options from the command line, without the program's name.
/// Errors: std::invalid_argument for what is not known
RunOptions readOptions(int argc, const char* const* argv);

/// Refuses to be one of several processes that mpirun started.
/// Errors: std::runtime_error
void refuseRanks();

/// Reads and checks everything, then runs the scene and writes its results.
/// Errors: input::InputError for a scene that cannot run; std::runtime_error where results cannot be written, or would be lost
void runScene(const RunOptions& options, std::ostream& log);

} // namespace nscdGrains
