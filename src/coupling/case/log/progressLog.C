// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing the log.
#include "coupling/case/log/logText.H"
#include "coupling/case/log/progressLog.H"

namespace Foam
{
namespace nscdCoupling
{

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


void ProgressLog::step(const StepRow& row, const FluidSummary& fluid)
{
    ++steps_;
    stepsAtCap_ += !row.converged;
    const std::int64_t exitedNow = row.exited - exited_;
    exited_ = row.exited;
    worstOverlap_ = max(worstOverlap_, row.overlapMax);
    worstVolumeError_ = max(worstVolumeError_, fluid.volumeError);
    worstMomentumError_ = max(worstMomentumError_, row.momentumError);

    const std::string done = progress(row.time);
    os_ << formatted("Time = %.9g s, step %d, dt %.4g s, %s", row.time, int(steps_), row.deltaT, done.c_str()).c_str() << nl;
    if (hasFluid_) writeFluid(fluid, row.courantMax);
    os_ << formatted
        (
            "  advanceGrains: %lld grains, %lld contacts, %d sweeps%s, residual %.2g rms %.2g max m/s, overlap <= %.2g d",
            static_cast<long long>(row.grains), static_cast<long long>(row.contacts), int(row.sweeps),
            row.converged ? "" : " (at the cap)", row.residualRms, row.residualMax, row.overlapMax
        ).c_str() << nl;
    if (row.newtonSteps > 0) os_ << formatted("  direct method: %d Newton steps", int(row.newtonSteps)).c_str() << nl;
    if (row.asleep > 0) os_ << formatted("  %lld grains asleep", static_cast<long long>(row.asleep)).c_str() << nl;
    if (!row.solveWarning.empty() && stepsWarned_++ == 0) os_ << "  Warning: " << row.solveWarning.c_str() << nl;
    if (exitedNow > 0) os_ << formatted("  %lld grains left through exits", static_cast<long long>(exitedNow)).c_str() << nl;
    if (hasFluid_)
    {
        os_ << formatted
            (
                "  depositGrains: alpha.fluid >= %.4g, volume error %.2g; reportStep: momentum error %.2g",
                fluid.fluidFractionMin, fluid.volumeError, row.momentumError
            ).c_str() << nl;
    }
    os_ << endl;
}


void ProgressLog::finish(const TimingTable& timing) const
{
    os_ << "Timing" << nl;
    timing.print(os_, steps_);
    os_ << nl << "Summary" << nl
        << formatted("  worst overlap          %.3g d", worstOverlap_).c_str() << nl
        << formatted("  steps at the cap       %d of %d", int(stepsAtCap_), int(steps_)).c_str() << nl
        << formatted("  steps with a warning   %d", int(stepsWarned_)).c_str() << nl
        << formatted("  grains left by exits   %lld", static_cast<long long>(exited_)).c_str() << nl;
    if (hasFluid_)
    {
        os_ << formatted("  worst volume error     %.3g", worstVolumeError_).c_str() << nl
            << formatted("  worst momentum error   %.3g", worstMomentumError_).c_str() << nl;
    }
    os_ << endl;
}

} // namespace nscdCoupling
} // namespace Foam
