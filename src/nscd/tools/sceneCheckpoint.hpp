// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A scene on disk between two steps: all that a later run needs to go on to the bit as if never stopped.
#pragma once

#include "nscd/step/grainDynamics.hpp"
#include "nscd/tools/grainEntry.hpp"

#include <string>
#include <vector>

namespace nscd
{

/// What changes while a scene runs. Materials, walls, periods and settings are the caller's to make again.
struct SceneState
{
    Grains grains;
    std::vector<StoredImpulse> impulses;     ///< see GrainDynamics::restore
    double lastDeltaT = 0.0;                 ///< of the step the impulses belong to [s]
    double time = 0.0;                       ///< [s]
    std::int64_t step = 0;                   ///< steps made since the scene began
    std::vector<std::string> materials;      ///< names, for whoever reads them in another order
    std::int64_t nextId = 0;                 ///< identity of the next grain that enters
    std::vector<std::string> entryNames;     ///< of sources that let grains in
    std::vector<EntryState> entries;         ///< what each has done
};

/// The state of a scene after a step. Calls dynamics.checkpoint(): a run that writes and goes on does as one that reads and goes on.
/// The caller adds names of materials, where it has any. With several ranks: this rank's grains and impulses.
SceneState takeState(GrainDynamics& dynamics, double time, std::int64_t step);

/// Writes the file whole or not at all, in the byte order of this machine.
/// Errors: std::runtime_error where it cannot be written
void writeCheckpoint(const std::string& path, const SceneState& state);

/// Reads it back, each bit.
/// Errors: std::invalid_argument, saying what is wrong, for a file that is missing, foreign, of another version or byte order, cut
///         short, too long, or changed (by its checksum), or whose parts do not fit together
SceneState readCheckpoint(const std::string& path);

} // namespace nscd
