// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What steps took of the processor, and the worst of what they reported.
#pragma once

#include "nscd/scene/stepReport.hpp"

#include <algorithm>
#include <ctime>

/// Of this process [s].
inline double processorTime()
{
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9*static_cast<double>(time.tv_nsec);
}

struct TimedSteps
{
    int steps = 0, capped = 0;   ///< capped: not converged
    double seconds = 0.0, sweeps = 0.0, contacts = 0.0, overlapMax = 0.0, overlapMean = 0.0;

    void add(const nscd::StepReport& report, double took)
    {
        seconds += took;
        ++steps;
        capped += !report.solve.converged;
        sweeps += report.solve.sweeps;
        contacts += static_cast<double>(report.solve.contacts);
        overlapMax = std::max(overlapMax, report.overlapMax);
        overlapMean = std::max(overlapMean, report.overlapMean);
    }
};
