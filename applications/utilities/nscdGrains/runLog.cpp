// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing the log.
#include "runLog.hpp"

#include "nscd/base/formattedText.hpp"
#include "nscd/tools/sceneWork.hpp"

#include <algorithm>

namespace nscdGrains
{

namespace
{

using nscd::clockText;
using nscd::formatted;

constexpr double secondsPerLine = 1.0;

std::string describeGrains(const nscd::Grains& grains)
{
    if (grains.size() == 0) return "none";
    const auto range = std::minmax_element(grains.radius.begin(), grains.radius.end());
    const char* const kind = grains.shape.dimensions == 2 ? "discs" : "spheres";
    return formatted("%zu %s, diameter %.4g to %.4g m, volume %.6g m3", grains.size(), kind, 2**range.first, 2**range.second, totalVolume(grains));
}

std::string describeWalls(const nscd::Walls& walls)
{
    std::string names;
    for (const nscd::WallPatch& patch : walls.patches) names += (names.empty() ? "" : " ") + patch.name;
    return names.empty() ? "none" : formatted("%s, %zu flat regions", names.c_str(), walls.regions.size());
}

/// What moves by itself, and notes of reading; nothing in most scenes.
std::string movingText(const SceneSettings& scene, double startTime)
{
    std::string moving;
    for (const nscd::WallPatch& patch : scene.walls.patches)
    {
        if (patch.hasVelocity()) moving += " " + patch.name + (patch.motion ? "" : " (belt)");
    }
    std::size_t driven = 0;
    for (const input::DrivenGroup& group : scene.driven) driven += group.grains.ids.size();
    std::string text;
    if (!moving.empty()) text += "  moving   " + moving + "\n";
    if (driven > 0) text += formatted("  driven    %zu grains\n", driven);
    if (scene.letsFixedGo() && scene.fixedUntil > startTime) text += formatted("  fixed     until %.6g s\n", scene.fixedUntil);
    for (const std::string& note : scene.notes) text += "  " + note + "\n";
    return text;
}

/// A line for each source that lets grains in.
std::string enteringText(const SceneSettings& scene)
{
    std::string text;
    for (const nscd::EntrySource& entry : scene.entries)
    {
        text += formatted("  entering  %s, diameter %.4g to %.4g m, by %s\n", entry.name.c_str(), entry.sizes.smallest, entry.sizes.largest, entry.isMass ? "mass" : "number");
    }
    return text;
}

std::string describeEntries(const nscd::EntryState& state)
{
    const auto count = [](std::int64_t number) { return static_cast<long long>(number); };
    return formatted("%lld entered, %.6g kg; %lld wait, %.6g kg", count(state.entered), state.enteredMass, count(state.waiting()), state.waitingMass());
}

std::string describePeriods(const nscd::PeriodicBox& box)
{
    std::string text;
    for (int k = 0; k < 3; ++k)
    {
        if (box.isPeriodic(k)) text += formatted("%s%c, %.4g m", text.empty() ? "" : "; ", "xyz"[k], box.length[k]);
    }
    return text.empty() ? "none" : text;
}

} // namespace

RunLog::RunLog(std::ostream& os, double startTime, double endTime)
:
    os_(os),
    startTime_(startTime),
    endTime_(endTime),
    start_(Clock::now())
{}

void RunLog::scene(const SceneSettings& scene, const nscd::Grains& grains, const ResultsFolder& results)
{
    const nscd::ContactSettings& contact = scene.contact;
    os_ << "Scene " << scene.file << '\n'
        << "  grains    " << describeGrains(grains) << '\n'
        << enteringText(scene)
        << "  walls     " << describeWalls(scene.walls) << '\n'
        << movingText(scene, startTime_)
        << "  periodic  " << describePeriods(scene.box) << '\n'
        << formatted("  contacts  %s, tolerance %.3g, at most %d sweeps\n", contact.solver.c_str(), contact.tolerance, contact.maxSweeps)
        << "  work      " << nscd::describeWork(scene.materials.table, scene.shape, contact) << '\n'
        << formatted("  time      %.9g to %.9g s in steps of %.4g s\n", startTime_, endTime_, scene.run.deltaT)
        << formatted("  results   every %.4g s into %s\n\n", scene.run.writeInterval, results.path().c_str()) << std::flush;
}

std::string RunLog::progress(double time) const
{
    const double done = std::min(1.0, (time - startTime_)/(endTime_ - startTime_));
    return formatted("%.1f %% done, %s left", 100*done, clockText(elapsed()*(1 - done)/done).c_str());
}

/// Writes the first warning of each kind, and counts all.
void RunLog::warn(const StepRow& row)
{
    for (const nscd::Warning& one : nscd::warnings(row.report.solve))
    {
        if (warnings_.count(one, row.time)) os_ << formatted("Time = %.9g s: Warning: ", row.time) << one.text << std::endl;
    }
}

void RunLog::step(const StepRow& row, std::int64_t number, bool isWritten)
{
    const nscd::SolveReport& solve = row.report.solve;
    ++steps_;
    atCap_ += solve.atCap;
    atCapSinceLine_ += solve.atCap;
    sweeps_ += solve.sweeps;
    worstOverlap_ = std::max(worstOverlap_, row.report.overlapMax);
    worstUncorrectedOverlap_ = std::max(worstUncorrectedOverlap_, row.report.overlapUncorrected);
    worstForceError_ = std::max(worstForceError_, solve.forceError);
    warn(row);
    if (steps_ > 1 && !isWritten && elapsed() - lastLine_ < secondsPerLine) return;

    lastLine_ = elapsed();
    os_ << formatted
        (
            "Time = %.9g s, step %lld: %zu contacts, %d sweeps, %s, residual %.2g rms %.2g max m/s, force error %.2g, overlap <= %.2g d; ",
            row.time, static_cast<long long>(number), solve.contacts, solve.sweeps, solve.converged ? "converged" : "NOT converged",
            solve.residualRms, solve.residualMax, solve.forceError, row.report.overlapMax
        )
        << progress(row.time) << (isWritten ? ", written" : "");
    if (row.report.asleep > 0) os_ << "; " << row.report.asleep << " asleep";
    if (row.entries.due > 0) os_ << "; " << describeEntries(row.entries);
    if (atCapSinceLine_ > 0) os_ << "; " << atCapSinceLine_ << " steps at the cap since the last line";
    os_ << std::endl;
    atCapSinceLine_ = 0;
}

void RunLog::timing(const char* name, double seconds) const
{
    const double total = elapsed();
    os_ << formatted("  %-16s %12.3f %8.1f %% %12.4f\n", name, seconds, 100*seconds/total, steps_ > 0 ? 1e3*seconds/steps_ : 0.0);
}

void RunLog::finish(const nscd::StepTimes& times, double output, const nscd::GrainEntry& entry)
{
    const double total = elapsed();
    os_ << "\nTiming\n" << formatted("  %-16s %12s %10s %12s\n", "part", "seconds", "share", "ms/step");
    for (std::size_t part = 0; part < nscd::grainPartNames.size(); ++part) timing(nscd::grainPartNames[part], times.parts()[part]);
    timing("output", output);
    timing("other", std::max(0.0, total - times.total() - output));
    timing("sum", total);
    os_ << "\nSummary\n"
        << formatted("  steps                  %ld\n", steps_)
        << formatted("  steps at the cap       %ld\n", atCap_)
        << formatted("  sweeps per step        %.4g\n", steps_ > 0 ? sweeps_/steps_ : 0.0)
        << formatted("  worst overlap          %.3g d, before its correction %.3g d\n", worstOverlap_, worstUncorrectedOverlap_)
        << formatted("  worst force error      %.3g\n", worstForceError_)
        << warnings_.lines();
    for (std::size_t s = 0; s < entry.sources().size(); ++s) os_ << "  " << entry.sources()[s].name << ": " << describeEntries(entry.states()[s]) << '\n';
    os_ << std::flush;
}

} // namespace nscdGrains
