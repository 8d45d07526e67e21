// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Columns of a benchmark's CSV with what each part of a step of grains took.
#pragma once

#include "nscd/base/formattedText.hpp"
#include "nscd/base/stepTimes.hpp"

#include <string>

/// "findPairsMs,..."
inline std::string partHead()
{
    std::string head;
    for (const char* name : nscd::grainPartNames) head += (head.empty() ? "" : ",") + std::string(name) + "Ms";
    return head;
}

/// Milliseconds a step of each part.
inline std::string partColumns(const nscd::StepTimes& spent, double steps)
{
    std::string row;
    for (double seconds : spent.parts()) row += (row.empty() ? "" : ",") + nscd::formatted("%.3f", 1e3*seconds/steps);
    return row;
}
