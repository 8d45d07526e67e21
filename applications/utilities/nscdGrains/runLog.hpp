// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a run says while it goes on: the scene, progress, and at its end times and a summary.
#pragma once

#include "resultsFolder.hpp"
#include "sceneSettings.hpp"
#include "stepTable.hpp"

#include "nscd/scene/stepWarnings.hpp"

#include <chrono>
#include <ostream>

namespace nscdGrains
{

class RunLog
{
public:
    RunLog(std::ostream& os, double startTime, double endTime);

    void scene(const SceneSettings& scene, const nscd::Grains& grains, const ResultsFolder& results);

    /// A line for the first step, for those written, and otherwise about one a second; counts all.
    void step(const StepRow& row, std::int64_t number, bool isWritten);

    /// Where the time went: parts of the library's steps, output in seconds, and the rest.
    void finish(const nscd::StepTimes& times, double output, const nscd::GrainEntry& entry);

private:
    using Clock = std::chrono::steady_clock;
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void warn(const StepRow& row);
    std::string progress(double time) const;
    void timing(const char* name, double seconds) const;

    std::ostream& os_;
    double startTime_;
    double endTime_;
    Clock::time_point start_;
    double lastLine_ = -1.0;
    long steps_ = 0;
    long atCap_ = 0;
    long atCapSinceLine_ = 0;
    double sweeps_ = 0.0;
    double worstOverlap_ = 0.0;
    double worstUncorrectedOverlap_ = 0.0;
    double worstForceError_ = 0.0;
    nscd::WarningCounts warnings_;
};

} // namespace nscdGrains
