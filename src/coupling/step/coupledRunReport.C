// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a run tells: log, report and written times.
// Tested by tests/foam/program/caseProgramTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/base/openFoamVersions.H"
#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/runState.H"
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/log/grainTotals.H"

#include "parallel/idDirectory.hpp"
#include "parallel/rankTree.hpp"

#include "fvcSurfaceIntegrate.H"

#include <algorithm>
#include <unordered_set>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Mean cell over mean diameter, below which a stiff exchange of momentum was seen to grow (tests/benchmark/run coupledMap): not at 0.43,
/// at 0.3.
constexpr scalar smallCells = 0.43;

/// Share of the momentum exchanged, above which the balance is looked into: runs that blew up began with 0.35 and more, ones with enough
/// corrections with up to 0.15 (measured.md, "Viscosity across cells").
constexpr scalar balanceIsOff = 0.2;

/// How far viscosity reaches in a step, largest: the rest of a momentum equation's diagonal over its inertia. Collective.
/// Equation: nu dt sum |Sf|/(delta V) = 2 nu dt (1/hx^2 + 1/hy^2 + 1/hz^2)
scalar viscousReach(const FluidSolver& fluid)
{
    const fvMesh& mesh = fluid.U().mesh();
    const volScalarField links(fvc::surfaceSum(mesh.magSf()*mesh.deltaCoeffs()));
    const scalarField viscosity(fluid.nu()().primitiveField() + fluid.nut()().primitiveField());
    return mesh.time().deltaTValue()*gMax((viscosity*links.primitiveField()/mesh.V().field())());
}

label pressureIterations(const fvMesh& mesh)
{
    List<SolverPerformance<scalar>> solves;
    if (!performanceOfSolvers(mesh).readIfPresent("p_rgh", solves)) return 0;
    label sum = 0;
    for (const auto& solve : solves) sum += solve.nIterations();
    return sum;
}

/// Whether the grain of each identity is there, on any rank. Collective.
std::vector<bool> areThere(const std::vector<std::int64_t>& ids, const ::nscd::Grains& grains, const GrainRanks& ranks)
{
    std::vector<bool> found;
    if (ranks.isParallel())
    {
        for (const int owner : ::nscd::IdDirectory(ranks.tree().all(), grains.id).owners(ids)) found.push_back(owner >= 0);
        return found;
    }
    const std::unordered_set<std::int64_t> known(grains.id.begin(), grains.id.end());
    for (const std::int64_t id : ids) found.push_back(known.count(id) > 0);
    return found;
}

/// A grain that left in this step may have touched one that is still there.
void dropContactsOfThoseGone(GrainState& state, const GrainRanks& ranks)
{
    std::vector<std::int64_t> partners;
    for (const ::nscd::StoredImpulse& contact : state.contacts) partners.push_back(contact.idB < 0 ? contact.idA : contact.idB);
    const std::vector<bool> isThere = areThere(partners, state.grains, ranks);
    std::vector<::nscd::StoredImpulse> kept;
    for (std::size_t k = 0; k < isThere.size(); ++k)
    {
        if (isThere[k]) kept.push_back(state.contacts[k]);
    }
    state.contacts = std::move(kept);
}

} // namespace

/// The volumes of the void fraction, summed from its field, beside those of the grains.
void CoupledRun::describeVolumes(StepRow& row) const
{
    if (!hasFluid() || !feedsBack() || !immersion_->mapping) return;
    const MappingReport& mapped = immersion_->mapping->report();
    row.solidVolume = gSum(mesh_.V().field()*(1 - immersion_->sources.fluidFraction.primitiveField()));
    row.volumeOutside = mapped.lostOutside;
    row.volumeMoved = mapped.redistribution.movedVolume;
    row.volumeUnresolved = mapped.redistribution.unresolvedVolume;
    if (row.grainVolume > 0) row.volumeError = mag(row.solidVolume - (row.grainVolume - row.volumeOutside))/row.grainVolume;
}

GrainTotals CoupledRun::totals() const
{
    GrainTotals totals = sumGrains(dynamics_->grains(), *ranks_.exchange());
    if (coarse_) coarse_->describe(dynamics_->grains(), *ranks_.exchange(), totals);
    if (dynamics_->grains().clumps.shapes.empty()) return totals;
    const GrainTotals ofBodies = sumGrains(bodies(), *ranks_.exchange());
    double clumps = double(dynamics_->grains().clumps.size());
    ranks_.exchange()->sum(&clumps, 1);
    totals.clumps = static_cast<std::int64_t>(clumps);
    totals.volume = ofBodies.volume;
    totals.massCenter = ofBodies.massCenter;
    return totals;
}

StepRow CoupledRun::describeStep()
{
    const GrainTotals totals = this->totals();
    StepRow row;
    row.time = time_.value();
    row.deltaT = time_.deltaTValue();
    row.grains = totals.number;
    row.clumps = totals.clumps;
    row.report = step_.grainReport;
    row.subCycles = step_.subCycles;
    row.kineticEnergy = totals.kineticEnergy;
    row.massCenter = totals.massCenter;
    for (const Vec3& force : dynamics_->wallForce()) row.wallForce += toFoam(force);
    row.grainVolume = totals.volume;
    describeVolumes(row);
    row.momentumError = step_.momentumError;
    row.momentumDebt = step_.momentumDebt;
    row.exited = exited_;
    if (entry_) row.entries = ::nscd::totalOf(entry_->states());
    row.courantMax = reach_.courant;
    row.realGrains = totals.real.number;
    if (coarse_) row.realExited = coarse_->exited(*ranks_.exchange());
    if (coarse_ && entry_) row.realEntered = realGrainsEntered(*entry_, scene_.space.shape.dimensions);
    if (heat_) row.heat = heat_->report(dynamics_->grains());
    return row;
}

scalar CoupledRun::owedShare() const
{
    double sums[2] = {0, 0};
    for (std::size_t i = 0; i < debt_.size() && i < step_.received.size(); ++i)
    {
        sums[0] += debt_[i].norm();
        sums[1] += step_.received[i].norm();
    }
    ranks_.exchange()->sum(sums, 2);
    return sums[0]/std::max(sums[1], VSMALL);
}

/// Of the slip between grains and the fluid around them, in the fullest cell.
/// Equation: dt/tau = k (1 + phi rho_p/(alpha rho)), k = gamma dt/m; as for C07
scalar CoupledRun::stepOverRelaxation(const FluidSummary& summary) const
{
    const std::vector<double>& density = properties_.materials.density;
    const scalar heaviest = *std::max_element(density.begin(), density.end()), alpha = summary.fluidFractionMin;
    return summary.dragRatioMax*(1 + (1 - alpha)*heaviest/(alpha*fluidDensity()));
}

FluidSummary CoupledRun::describeFluid() const
{
    FluidSummary summary;
    if (!hasFluid()) return summary;
    const ::nscd::Grains& grains = bodies();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (i < step_.at.velocity.size())
        {
            summary.slipMax = max(summary.slipMax, (step_.at.velocity[i] - grains.velocity[i]).norm());
        }
        summary.fluidForce += toFoam(fluidForce_[i]);
    }
    const closures::BeyondRange beyond = hasGrains() ? step_.drag.beyond : closures::BeyondRange{0, 0};
    vector largest(summary.slipMax, beyond.Re, beyond.fluidFraction);
    reduce(largest, maxOp<vector>());
    summary.slipMax = largest.x();
    summary.beyondRe = largest.y();
    summary.beyondFraction = largest.z();
    reduce(summary.fluidForce, sumOp<vector>());
    summary.isLagged = feedsBack() && step_.response.isZero;
    summary.owedShare = feedsBack() ? owedShare() : 0;
    summary.dragRatioMax = step_.drag.largestStiffness;
    summary.predictorSweeps = step_.predictorSweeps;
    summary.predictorConverged = step_.predictorConverged;
    summary.pressureIterations = pressureIterations(mesh_);
    summary.continuityError = immersion_->fluid->continuityError().largest*time_.deltaTValue();
    summary.fluidFractionMin = gMin(immersion_->sources.fluidFraction.primitiveField());
    if (step_.momentumError > balanceIsOff) summary.viscousReach = viscousReach(*immersion_->fluid);
    if (feedsBack() && relativeCellSize_ < smallCells) summary.stepOverRelaxation = stepOverRelaxation(summary);
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
    dropContactsOfThoseGone(state, ranks_);
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

void CoupledRun::finish() const { log_.finish(timing_, dynamics_->times()); }

} // namespace nscdCoupling
} // namespace Foam
