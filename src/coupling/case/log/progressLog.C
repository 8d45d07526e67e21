// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing the log.
#include "coupling/case/log/progressLog.H"

#include "nscd/base/formattedText.hpp"

namespace Foam
{
namespace nscdCoupling
{

using ::nscd::clockText;
using ::nscd::formatted;

namespace
{

/// What came of a step's solve, where it has not converged.
const char* outcome(const ::nscd::SolveReport& solve)
{
    if (solve.converged) return "";
    if (solve.atCap) return " (at the cap)";
    if (solve.isHeld) return " (friction held)";
    return solve.isReboundOfMotion ? " (rebound of the motion)" : " (forces off)";
}

/// What is done without being asked for, and what fell short; each is explained in method.md.
struct WarningRow
{
    const char* head;   ///< in the log: Note, of what is meant so; Warning
    const char* name;
    const char* text;
    scalar (*measure)(const StepRow&, const FluidSummary&);
    scalar least;       ///< measures up to here are what every iteration leaves
    const char* unit;
};

const WarningRow warningRows[] =
{
    {
        "Note", "no predictor", "weak drag in a light fluid: grains are handed to it with the velocity they have, without a predictor",
        [](const StepRow&, const FluidSummary& f) { return f.isLagged ? f.dragRatioMax : 0; }, 0, "of gamma dt/m"
    },
    {
        "Warning", "predictor at the cap", "the prediction of the grains' velocities did not converge: drag may be off in this step",
        [](const StepRow&, const FluidSummary& f) { return f.predictorConverged ? 0 : scalar(f.predictorSweeps); }, 0, "sweeps"
    },
    {
        "Warning", "drag beyond its Re", "grains slip faster than the drag law is meant for: its range is in src/closures/README.md",
        [](const StepRow&, const FluidSummary& f) { return f.beyondRe; }, 1, "of its highest Re"
    },
    {
        "Warning", "drag beyond its alpha", "grains are in fluid fractions that the drag law is not meant for: its range is in src/closures/README.md",
        [](const StepRow&, const FluidSummary& f) { return f.beyondFraction; }, 1e-6, "beyond its alpha"
    },
    {
        "Warning", "stiff in small cells",
        "drag this stiff can drive waves between grains and fluid in cells below half a diameter: take larger cells, or shorter steps",
        [](const StepRow&, const FluidSummary& f) { return f.stepOverRelaxation; }, 10, "relaxation times a step"
    },
    {
        "Warning", "viscosity across cells",
        "corrections of the pressure do not follow viscosity that reaches across several cells in a step: momentum is lost, and may grow without end "
        "(as in pimpleFoam). Take more nCorrectors (PIMPLE in fvSolution), or a smaller deltaT; nOuterCorrectors do not help",
        [](const StepRow&, const FluidSummary& f) { return f.viscousReach; }, 4, "of 2 nu dt (1/hx^2 + 1/hy^2 + 1/hz^2)"
    },
    {
        "Note", "momentum owed", "grains took other momentum from the fluid than it was told: half of what they owe is repaid in each step",
        [](const StepRow&, const FluidSummary& f) { return f.owedShare; }, 0.01, "of what grains received"
    },
    {
        "Note", "volume moved", "cells are fuller than minFluidFraction allows: what is too much in them is moved to neighboring ones. "
        "Where a bed at rest has that in every step, take a smaller one (voidFraction)",
        [](const StepRow& r, const FluidSummary&) { return r.volumeMoved; }, 0, "m3"
    },
    {
        "Warning", "volume unresolved", "cells stayed fuller than minFluidFraction allows: there is no room near them",
        [](const StepRow& r, const FluidSummary&) { return r.volumeUnresolved; }, 0, "m3"
    },
    {
        "Warning", "grains outside the mesh", "grains are partly outside the mesh: their volume is put into the cells that they do reach",
        [](const StepRow& r, const FluidSummary&) { return r.volumeOutside/max(r.grainVolume, VSMALL); }, 1e-3, "of the grains' volume"
    }
};

std::string describeEntries(const ::nscd::EntryState& state)
{
    const auto count = [](std::int64_t number) { return static_cast<long long>(number); };
    return formatted("%lld grains entered, %.6g kg; %lld wait, %.6g kg", count(state.entered), state.enteredMass, count(state.waiting()), state.waitingMass());
}

} // namespace


ProgressLog::ProgressLog(const Time& time, Ostream& os, bool hasFluid)
:
    os_(os),
    hasFluid_(hasFluid),
    startTime_(time.startTime().value()),
    endTime_(time.endTime().value()),
    start_(std::chrono::steady_clock::now())
{}


std::string ProgressLog::progress(scalar time) const
{
    const scalar done = (time - startTime_)/(endTime_ - startTime_);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!(done > 0)) return "";
    return formatted("%.1f %% done, %s left", 100*done, clockText(elapsed*max(scalar(0), 1 - done)/done).c_str());
}


void ProgressLog::writeFluid(const FluidSummary& fluid, scalar courantMax) const
{
    const std::string predictor = fluid.predictorSweeps < 0
        ? "no predictor"
        : formatted("predictor %d sweeps%s", int(fluid.predictorSweeps), fluid.predictorConverged ? "" : " (at the cap)");
    os_ << formatted
        (
            "  sampleFluid: slip <= %.3g m/s; linearizeDrag: gamma dt/m <= %.3g, %s",
            fluid.slipMax, fluid.dragRatioMax, predictor.c_str()
        ).c_str() << nl;
    os_ << formatted
        (
            "  solveFluid: %d pressure iterations, continuity %.2g, Courant %.3g; fluidForces: (%.4g %.4g %.4g) N",
            int(fluid.pressureIterations), fluid.continuityError, courantMax,
            fluid.fluidForce.x(), fluid.fluidForce.y(), fluid.fluidForce.z()
        ).c_str() << nl;
}


void ProgressLog::say(const char* head, const ::nscd::Warning& warning, scalar time)
{
    if (warnings_.count(warning, time)) os_ << "  " << head << ": " << warning.text.c_str() << nl;
}


/// Writes the first of each kind, and counts all.
void ProgressLog::warn(const StepRow& row, const FluidSummary& fluid)
{
    for (const ::nscd::Warning& one : ::nscd::warnings(row.report.solve)) say("Warning", one, row.time);
    if (!hasFluid_) return;
    for (const WarningRow& kind : warningRows)
    {
        const scalar measure = kind.measure(row, fluid);
        if (measure > kind.least) say(kind.head, {kind.name, kind.text, measure, kind.unit}, row.time);
    }
}


void ProgressLog::step(const StepRow& row, const FluidSummary& fluid)
{
    ++steps_;
    const ::nscd::SolveReport& solve = row.report.solve;
    stepsAtCap_ += solve.atCap;
    const std::int64_t exitedNow = row.exited - exited_;
    exited_ = row.exited;
    worstOverlap_ = max(worstOverlap_, row.report.overlapMax);
    worstUncorrectedOverlap_ = max(worstUncorrectedOverlap_, row.report.overlapUncorrected);
    worstForceError_ = max(worstForceError_, solve.forceError);
    worstVolumeError_ = max(worstVolumeError_, row.volumeError);
    worstMomentumError_ = max(worstMomentumError_, row.momentumError);

    const std::string done = progress(row.time);
    os_ << formatted("Time = %.9g s, step %d, dt %.4g s, %s", row.time, int(steps_), row.deltaT, done.c_str()).c_str() << nl;
    if (hasFluid_) writeFluid(fluid, row.courantMax);
    os_ << formatted
        (
            "  advanceGrains: %lld grains, %zu contacts, %d sweeps%s, residual %.2g rms %.2g max m/s, force error %.2g, overlap <= %.2g d "
            "(%.2g before correction)",
            static_cast<long long>(row.grains), solve.contacts, solve.sweeps, outcome(solve),
            solve.residualRms, solve.residualMax, solve.forceError, row.report.overlapMax, row.report.overlapUncorrected
        ).c_str() << nl;
    if (row.subCycles > 1 || solve.impacts > 0)
    {
        os_ << formatted("  grain steps: %d, impacts with restitution <= %.2g of a grain in each", int(row.subCycles), solve.impacts).c_str() << nl;
    }
    if (solve.newtonSteps > 0) os_ << formatted("  direct method: %d Newton steps", solve.newtonSteps).c_str() << nl;
    if (row.realGrains > 0) os_ << formatted("  %lld parcels of %.12g real grains", static_cast<long long>(row.grains), row.realGrains).c_str() << nl;
    if (row.report.asleep > 0) os_ << formatted("  %zu grains asleep", row.report.asleep).c_str() << nl;
    warn(row, fluid);
    if (exitedNow > 0) os_ << formatted("  %lld grains left through exits", static_cast<long long>(exitedNow)).c_str() << nl;
    if (row.entries.due > 0) os_ << "  " << describeEntries(row.entries).c_str() << nl;
    if (hasFluid_)
    {
        os_ << formatted
            (
                "  depositGrains: alpha.fluid >= %.4g, volume error %.2g; reportStep: momentum error %.2g",
                fluid.fluidFractionMin, row.volumeError, row.momentumError
            ).c_str() << nl;
    }
    os_ << endl;
}


void ProgressLog::finish(const TimingTable& timing, const ::nscd::StepTimes& grains) const
{
    os_ << "Timing" << nl;
    timing.print(os_, steps_, grains);
    os_ << nl << "Summary" << nl
        << formatted("  worst overlap          %.3g d, before its correction %.3g d", worstOverlap_, worstUncorrectedOverlap_).c_str() << nl
        << formatted("  worst force error      %.3g", worstForceError_).c_str() << nl
        << formatted("  steps at the cap       %d of %d", int(stepsAtCap_), int(steps_)).c_str() << nl
        << formatted("  grains left by exits   %lld", static_cast<long long>(exited_)).c_str() << nl;
    if (hasFluid_)
    {
        os_ << formatted("  worst volume error     %.3g", worstVolumeError_).c_str() << nl
            << formatted("  worst momentum error   %.3g", worstMomentumError_).c_str() << nl;
    }
    os_ << warnings_.lines().c_str();
    os_ << endl;
}

} // namespace nscdCoupling
} // namespace Foam
