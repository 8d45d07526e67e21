// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What users should know of a solve, in words.
#include "nscd/scene/stepReport.hpp"

#include <cstdio>

namespace nscd
{

namespace
{

std::string massWarning(const SolveReport& report)
{
    char text[600] = "";
    if (report.hiddenMassRatio == 0.0) return text;
    std::snprintf
    (
        text, sizeof(text),
        "masses in contact differ by up to 1:%.3g, and the direct method is too dear for this scene or not to be had on several ranks: "
        "velocities have the accuracy asked for, forces under the heavy bodies may not; ask for a finer tolerance where they matter",
        report.hiddenMassRatio
    );
    return text;
}

std::string energyWarning(const SolveReport& report)
{
    char text[600] = "";
    if (!report.hasGainedEnergy()) return text;
    std::snprintf
    (
        text, sizeof(text),
        "restitution and friction at once would have created %.3g J in a step (Newton's law of impact may): all its rebounds were "
        "multiplied by %.3g, so that none was",
        report.shockWork, report.reboundShare
    );
    return text;
}

std::string capWarning(const SolveReport& report)
{
    constexpr int patience = 5;
    char text[600] = "";
    if (report.stepsAtCap < patience) return text;
    std::snprintf
    (
        text, sizeof(text),
        "step after step ends at the cap of sweeps, after which part of the weight is not carried: grains at rest sink so, and bounce without end; a "
        "larger maxSweeps, a smaller time step or a coarser tolerance would do"
    );
    return text;
}

} // namespace

std::string warning(const SolveReport& report)
{
    std::string all;
    for (const std::string& one : {massWarning(report), energyWarning(report), capWarning(report)})
    {
        if (!one.empty()) all += (all.empty() ? "" : "; and ") + one;
    }
    return all;
}

} // namespace nscd
