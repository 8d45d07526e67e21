// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The folder of a scene's results: names of its files, what an earlier run left, where to go on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nscdGrains
{

class ResultsFolder
{
public:
    explicit ResultsFolder(const std::string& path) : path_(path) {}

    const std::string& path() const { return path_; }
    std::string report() const { return path_ + "/report.csv"; }
    std::string walls() const { return path_ + "/walls.csv"; }
    std::string grainSeries() const { return path_ + "/grains.pvd"; }
    std::string contactSeries() const { return path_ + "/contacts.pvd"; }
    /// Relative to the folder, as a series names it.
    std::string grains(std::int64_t step) const;
    std::string contacts(std::int64_t step) const;
    std::string state(std::int64_t step) const;
    std::string full(const std::string& name) const { return path_ + "/" + name; }

    /// Whether a run has written here.
    bool hasResults() const;
    /// The state written last; empty where there is none.
    std::string latestState() const;

    /// Makes the folder and those inside. Errors: std::runtime_error where they cannot be made
    void create() const;
    /// Removes what nscdGrains writes, and nothing else.
    void clear() const;
    /// Removes the oldest states but so many.
    void purgeStates(std::size_t kept) const;

private:
    std::vector<std::string> filesOf(const std::string& kind) const;

    std::string path_;
};

} // namespace nscdGrains
