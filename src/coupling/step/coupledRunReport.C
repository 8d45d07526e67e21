// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a run tells: log, report and written times.
// Tested by tests/foam/program/caseProgramTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/runState.H"
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/log/grainTotals.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

label pressureIterations(const fvMesh& mesh)
{
    List<SolverPerformance<scalar>> solves;
    if (!mesh.data::solverPerformanceDict().readIfPresent("p_rgh", solves)) return 0;
    label sum = 0;
    for (const auto& solve : solves) sum += solve.nIterations();
    return sum;
}

} // namespace

StepRow CoupledRun::describeStep() const
{
    const GrainTotals totals = sumGrains(dynamics_->grains(), *ranks_.exchange());
    const ::nscd::StepReport& report = step_.grainReport;
    StepRow row;
    row.time = time_.value();
    row.deltaT = time_.deltaTValue();
    row.grains = totals.number;
    row.contacts = static_cast<std::int64_t>(report.solve.contacts);
    row.sweeps = report.solve.sweeps;
    row.converged = report.solve.converged;
    row.newtonSteps = report.solve.newtonSteps;
    row.solveWarning = ::nscd::warning(report.solve);
    row.asleep = static_cast<std::int64_t>(report.asleep);
    row.residualRms = report.solve.residualRms;
    row.residualMax = report.solve.residualMax;
    row.overlapMax = report.overlapMax;
    row.overlapMean = report.overlapMean;
    row.correctionSweeps = report.correctionSweeps;
    row.kineticEnergy = totals.kineticEnergy;
    row.massCenter = totals.massCenter;
    for (const Vec3& force : dynamics_->wallForce()) row.wallForce += toFoam(force);
    row.grainVolume = hasFluid() && immersion_->mapping ? immersion_->mapping->report().volumeDeposited : totals.volume;
    row.momentumError = step_.momentumError;
    row.exited = exited_;
    row.courantMax = reach_.courant;
    return row;
}

FluidSummary CoupledRun::describeFluid() const
{
    FluidSummary summary;
    if (!hasFluid()) return summary;
    const ::nscd::Grains& grains = dynamics_->grains();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (i < step_.at.velocity.size())
        {
            summary.slipMax = max(summary.slipMax, (step_.at.velocity[i] - grains.velocity[i]).norm());
        }
        summary.fluidForce += toFoam(fluidForce_[i]);
    }
    reduce(summary.slipMax, maxOp<scalar>());
    reduce(summary.fluidForce, sumOp<vector>());
    summary.dragRatioMax = step_.drag.largestStiffness;
    summary.predictorSweeps = step_.predictorSweeps;
    summary.predictorConverged = step_.predictorConverged;
    summary.pressureIterations = pressureIterations(mesh_);
    summary.continuityError = immersion_->fluid->continuityError().largest*time_.deltaTValue();
    summary.fluidFractionMin = gMin(immersion_->sources.fluidFraction.primitiveField());
    if (!immersion_->mapping) return summary;
    const MappingReport& mapped = immersion_->mapping->report();
    if (mapped.grainVolume > 0) summary.volumeError = mag(mapped.volumeDeposited - mapped.grainVolume)/mapped.grainVolume;
    return summary;
}

void CoupledRun::reportStep()
{
    const auto timer = timing_.time(StepPart::reportStep);
    const StepRow row = describeStep();
    report_->write(row);
    if (wallOutput_) wallOutput_->report(row.time, *dynamics_);
    log_.step(row, describeFluid());
    reach_.isKnown = true;
    if (time_.writeTime()) write();
}

/// grainState comes first, as a mark, and last, complete.
void CoupledRun::write()
{
    beginRunState(time_);
    writeOrRefuse(time_.timePath(), [&] { return time_.write(); });
    writeExactTime(time_);
    GrainState state = takeState();
    if (ranks_.isParallel()) writeOnHomes(std::move(state));
    else
    {
        labelList cells(label(state.grains.nOwned), -1);
        if (hasFluid() && hasGrains()) std::copy(immersion_->mapping->cells().begin(), immersion_->mapping->cells().end(), cells.begin());
        writeGrainState(mesh_, state, properties_.materials.table, cells);
    }
    if (!wallOutput_) return;
    dynamics_->setTime(time_.value());  // without grains nobody else does
    wallOutput_->writePictures(time_, dynamics_->walls());
}

void CoupledRun::finish() const { log_.finish(timing_); }

} // namespace nscdCoupling
} // namespace Foam
