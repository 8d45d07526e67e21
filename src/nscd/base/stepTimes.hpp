// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where the time of a step of grains goes.
// Tested by tests/unit/nscd/base/stepTimesTest.cpp
#pragma once

#include <array>
#include <chrono>
#include <numeric>

namespace nscd
{

/// What a step of grains does.
enum class GrainPart
{
    findPairs,          ///< lists of candidates built
    updateGeometry,     ///< normals and gaps of contacts where grains are now
    buildContacts,      ///< free velocities, and what a solve needs of each contact
    packContacts,       ///< those that matter put side by side, and given back
    solveContacts,      ///< sweeps over contacts, and whatever else moves their impulses on
    judgeContacts,      ///< residuals, errors of forces, looks at contacts that carry nothing
    rebound,            ///< the second solve of a step with restitution, whole
    moveGrains,         ///< positions, velocities and forces given to grains
    correctOverlaps,
    sleep               ///< who falls asleep, who wakes, and lists of those awake
};

constexpr std::array<const char*, 10> grainPartNames =
{
    "findPairs", "updateGeometry", "buildContacts", "packContacts", "solveContacts", "judgeContacts", "rebound", "moveGrains",
    "correctOverlaps", "sleep"
};

/// Seconds of steps, part by part. A part within another is taken out of it: no second counts twice.
class StepTimes
{
public:
    /// From its construction to its end time belongs to one part; `times` null: nothing is measured.
    class Timer
    {
    public:
        Timer(StepTimes* times, GrainPart part) : times_(times), outer_(times ? times->enter(static_cast<int>(part)) : none) {}
        ~Timer() { if (times_) times_->enter(outer_); }
        Timer(const Timer&) = delete;
        Timer& operator=(const Timer&) = delete;

    private:
        StepTimes* times_;
        int outer_;
    };

    Timer time(GrainPart part) { return Timer(this, part); }

    double seconds(GrainPart part) const { return seconds_[static_cast<int>(part)]; }
    /// In the order of the names [s].
    const std::array<double, grainPartNames.size()>& parts() const { return seconds_; }
    double total() const { return std::accumulate(seconds_.begin(), seconds_.end(), 0.0); }

    /// What came since an earlier copy of the same.
    StepTimes since(const StepTimes& earlier) const
    {
        StepTimes difference = *this;
        for (std::size_t part = 0; part < seconds_.size(); ++part) difference.seconds_[part] -= earlier.seconds_[part];
        return difference;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr int none = -1;

    /// Returns the part that was timed until now.
    int enter(int part)
    {
        const Clock::time_point now = Clock::now();
        if (part_ != none) seconds_[part_] += std::chrono::duration<double>(now - entered_).count();
        entered_ = now;
        const int left = part_;
        part_ = part;
        return left;
    }

    std::array<double, grainPartNames.size()> seconds_{};
    int part_ = none;
    Clock::time_point entered_;
};

} // namespace nscd
