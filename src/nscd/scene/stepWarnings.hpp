// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What users should know of a step beyond its figures, and how often it happened.
#pragma once

#include "nscd/scene/stepReport.hpp"

#include <string>
#include <vector>

namespace nscd
{

struct Warning
{
    std::string kind;       ///< in a few words
    std::string text;       ///< in a sentence
    double measure;         ///< how bad it is
    std::string unit;       ///< of the measure, in words
};

/// What a user should know of a solve beyond its figures; mostly nothing.
std::vector<Warning> warnings(const SolveReport& report);

/// The same as one text; empty: nothing.
std::string warning(const SolveReport& report);

/// Counts the steps of a run with a warning of each kind.
class WarningCounts
{
public:
    /// Of the step that ended at `time` [s]. Returns whether it is the first of its kind.
    bool count(const Warning& warning, double time);

    /// For a summary, a line for each kind that happened: steps, time of the first one, worst measure.
    std::string lines() const;

private:
    struct Kind
    {
        Warning worst;
        long steps;
        double first;   ///< [s]
    };

    std::vector<Kind> kinds_;
};

} // namespace nscd
