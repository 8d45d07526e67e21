// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The seven parts of a time step.
// Tested by tests/foam/program/caseProgramTest.C, tests/foam/program/ranksTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/step/fluidAtGrains.H"
#include "coupling/step/ownWake.H"

#include "input/dictionary/withoutTraps.hpp"
#include "input/scene/drivenReader.hpp"

#include <algorithm>
#include <numeric>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Below these the grains are handed over with the velocity they have: weak drag, in a fluid much lighter than they are.
/// The lag is then of order gamma dt/m, and the explicit pressure force far from its limit phi rho/(alpha rho_p) < 1.
constexpr scalar weakDrag = 0.05;
constexpr scalar lightFluid = 0.05;

} // namespace

bool CoupledRun::nextStep()
{
    if (!time_.run()) return false;
    if (reach_.isKnown) adjustTimeStep(time_, reach_, properties_.time.maxGrainDisplacement);
    dynamics_->setTime(time_.value());
    balanceRanks();
    letFixedGo();
    // Before the time moves on: the void fraction that the step starts from has the grains that enter in it.
    letIn(time_.value() + time_.deltaTValue());
    ++time_;
    if (hasFluid()) immersion_->sources.beginStep();
    moveMesh();
    driveTo(time_.value(), time_.deltaTValue());
    if (coarse_) coarse_->update(dynamics_->grains());
    if (!hasFluid()) return true;
    immersion_->sources.hasGrains = feedsBack();
    immersion_->sources.hasResponse = feedsBack() && (!immersion_->sources.isStatic || immersion_->sources.isModelB);
    return true;
}

void CoupledRun::letFixedGo()
{
    if (held_.letGo(time_.value(), time_.deltaTValue(), properties_.driven, *dynamics_, *ranks_.exchange())) bodies_.update(dynamics_->grains());
}

void CoupledRun::driveTo(scalar end, scalar deltaT)
{
    toldByFoam([&] { input::driveGrains(properties_.driven, *dynamics_, end - deltaT, end); });
}

ForceInputs CoupledRun::forceInputs() const
{
    return {bodies(), step_.at, fluidDensity(), toVec3(gravity_), bodies_.forms(), coarse_ ? &coarse_->radius() : nullptr};
}

void CoupledRun::applyField()
{
    const GrainMapping* mapping = hasFluid() ? immersion_->mapping.get() : nullptr;
    const GrainsAtHome* atHome = hasFluid() ? &immersion_->atHome : nullptr;
    const scalar end = time_.value();
    step_.at.applied = field_->onGrains(bodies(), end - time_.deltaTValue(), end, mapping, atHome);
}

void CoupledRun::sampleFluid()
{
    const auto timer = timing_.time(StepPart::sampleFluid);
    if (field_ && hasGrains()) applyField();
    if (!hasFluid() || !hasGrains()) return;
    step_.at.ownWake.clear();
    sampleAtGrains(forces_.readsAtStart() | (ownWake_ ? reads::own : reads::nothing) | (heat_ ? GrainHeat::reads : reads::nothing));
    if (ownWake_) followOwnWake(forceInputs(), fluidForce_, ownStressShare_, time_.deltaTValue(), step_.at, *ownWake_);
    if (slipHistory_) slipHistory_->follow(forceInputs(), time_.deltaTValue(), time_.deltaT0Value(), step_.at);
    if (!coarse_) return;
    if (!ownWake_) step_.at.dragFactor.assign(dynamics_->grains().size(), 1.0);
    coarse_->multiplyDrag(dynamics_->grains(), step_.at.dragFactor);
}

void CoupledRun::sampleAtGrains(unsigned wanted)
{
    const volScalarField* fluidFraction = feedsBack() ? &immersion_->sources.fluidFraction : nullptr;
    nscdCoupling::sampleFluid(*immersion_->fluid, fluidFraction, *immersion_->mapping, immersion_->atHome, wanted, step_.at, coarse_ ? &coarse_->factor() : nullptr);
}

void CoupledRun::linearizeDrag()
{
    const auto timer = timing_.time(StepPart::linearizeDrag);
    const input::WithoutTraps traps;  // the contact solver says in words what is not finite
    const scalar deltaT = time_.deltaTValue();
    step_.predictorSweeps = -1;
    step_.predictorConverged = true;
    if (!hasFluid() || !hasGrains()) return;

    const ::nscd::Grains& grains = bodies();
    step_.startVelocity = grains.velocity;
    step_.exchanged = forces_.exchanged(forceInputs());
    step_.force = forces_.explicitForces(forceInputs(), step_.exchanged);
    step_.drag = forces_.linearize(forceInputs(), {step_.force, lastContactForce_, deltaT});
    ranks_.exchange()->max(&step_.drag.largestStiffness, 1);
    if (!feedsBack()) return;

    step_.response = isLagAllowed() ? laggedResponse(grains) : predictResponse();
    step_.response.isZero = !ranks_.exchange()->any(!step_.response.isZero);
    handOver(grains, step_, debt_, *immersion_->mapping, immersion_->atHome, fluidDensity(), deltaT, immersion_->sources);
}

bool CoupledRun::isLagAllowed() const
{
    if (step_.drag.largestStiffness > weakDrag) return false;
    const ::nscd::Grains& grains = bodies();
    const scalar rho = fluidDensity();
    double heaviestFluid = 0;
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (!grains.isFixed[i]) heaviestFluid = std::max(heaviestFluid, rho*grains.volume(i)/grains.mass[i]);
    }
    ranks_.exchange()->max(&heaviestFluid, 1);
    return heaviestFluid <= lightFluid;
}

GrainResponse CoupledRun::predictResponse()
{
    const ::nscd::Grains& grains = bodies();
    const scalar deltaT = time_.deltaTValue();
    ::nscd::ExternalForces external = forces_.external(forceInputs(), step_.force, step_.drag);
    external.speedScale = forces_.speedScale(forceInputs(), step_.exchanged, step_.drag, deltaT, *ranks_.exchange());
    dynamics_->beginStep(deltaT);
    ::nscd::Prediction prediction = freePrediction(grains, external, deltaT);
    std::vector<Mobility> mobility(grains.size());
    if (dynamics_->hasContacts())
    {
        prediction = bodies_.ofBodies(dynamics_->predict(bodies_.onGrains(external)));
        const TrialPush push = makeTrialPush(grains, step_.force, step_.drag, step_.at, external, deltaT);
        const ::nscd::Prediction pushed = bodies_.ofBodies(dynamics_->tryForces(bodies_.onGrains(push.external)));
        mobility = mobilities(push, prediction, pushed);
        step_.predictorSweeps = prediction.solve.sweeps + pushed.solve.sweeps;
        step_.predictorConverged = prediction.solve.converged && pushed.solve.converged;
    }
    return contactAwareResponse(forceInputs(), step_.drag, prediction, mobility, forces_.followPressure(), deltaT);
}

void CoupledRun::solveFluid()
{
    const auto timer = timing_.time(StepPart::solveFluid);
    if (!hasFluid()) return;
    if (heat_) heat_->liftFluid();
    immersion_->fluid->solve();
    reach_.courant = immersion_->fluid->courantNumber().max;
    if (heat_) solveHeat();
}

void CoupledRun::solveHeat()
{
    if (!hasGrains()) return heat_->solveFluidAlone();
    heat_->solve(dynamics_->grains(), forceInputs().realRadius, step_.at, *immersion_->mapping, immersion_->atHome, time_.deltaTValue());
}

void CoupledRun::fluidForces()
{
    const auto timer = timing_.time(StepPart::fluidForces);
    if (!hasGrains()) return;
    if (hasFluid())
    {
        sampleAtGrains(forces_.readsAfterSolve());
        removeOwnWake(step_.at);
    }
    step_.force = forces_.explicitForces(forceInputs(), step_.exchanged);
}

void CoupledRun::advanceGrains()
{
    const auto timer = timing_.time(StepPart::advanceGrains);
    const input::WithoutTraps traps;
    access_.beginStep();
    if (!hasGrains()) return reportNoGrains();
    const label subCycles = subCyclesOf(properties_.time, time_.deltaTValue(), reach_.impactRate);
    const scalar deltaT = time_.deltaTValue()/subCycles;
    step_.received.assign(bodies().size(), Vec3::Zero());
    step_.grainReport = ::nscd::StepReport();
    step_.subCycles = subCycles;
    scalar impacts = 0;
    for (label cycle = 0; cycle < subCycles; ++cycle)
    {
        if (subCycles > 1) driveTo(time_.value() - (subCycles - 1 - cycle)*deltaT, deltaT);
        const LinearDrag drag = subCycles == 1 || !hasFluid()
            ? step_.drag : forces_.splitAgain(bodies(), step_.drag, deltaT);
        const ::nscd::StepReport report = advanceOnce(drag, deltaT);
        impacts += report.solve.impacts;
        step_.grainReport = worstOf(step_.grainReport, report, cycle + 1);
    }
    access_.endMoves();
    if (access_.areContactsWanted()) access_.recordContacts(::nscd::shownContacts(dynamics_->grains(), dynamics_->contacts(), deltaT));
    if (heat_) heat_->conduct(*dynamics_, deltaT, time_.deltaTValue());
    reach_.displacement = step_.grainReport.maxDisplacement*subCycles;
    reach_.impactRate = expectedImpactRate(reach_.impactRate, impacts, time_.deltaTValue());
    lastContactForce_ = bodies_.sums(dynamics_->contactForce());
    if (hasFluid()) recordFluidForce();
    if (hasFluid() && feedsBack()) settleDebts();
}

::nscd::StepReport CoupledRun::advanceOnce(const LinearDrag& drag, scalar deltaT)
{
    const ::nscd::Grains& grains = bodies();
    ::nscd::ExternalForces external = forces_.external(forceInputs(), step_.force, drag);
    // Without a fluid weight acts alone, and no mean over grains rounds it: nscdGrains computes the same, to the bit.
    external.speedScale = hasFluid() || field_
        ? forces_.speedScale(forceInputs(), step_.exchanged, drag, deltaT, *ranks_.exchange()) : forceInputs().gravity.norm()*deltaT;

    const std::vector<Vec3> before = drag.implicit.empty() ? std::vector<Vec3>() : grains.velocity;
    dynamics_->beginStep(deltaT);
    const ::nscd::StepReport report = dynamics_->advance(bodies_.onGrains(std::move(external)));
    bodies_.update(dynamics_->grains());
    for (std::size_t i = 0; i < drag.implicit.size(); ++i)
    {
        const Vec3& u = step_.at.velocity[i];
        step_.received[i] += deltaT*(drag.implicit[i]*(u - grains.velocity[i]) + drag.remainder[i]*(u - before[i]) + drag.pull(i, u));
    }
    return report;
}

void CoupledRun::reportNoGrains()
{
    step_.grainReport = ::nscd::StepReport();
    step_.subCycles = properties_.time.subCycles;
    step_.momentumError = 0;
    step_.momentumDebt = 0;
    reach_.displacement = 0;
}

void CoupledRun::recordFluidForce()
{
    const ::nscd::Grains& grains = bodies();
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        fluidForce_[i] = step_.force[i] - grains.mass[i]*toVec3(gravity_) + step_.received[i]/time_.deltaTValue();
    }
    if (!field_) return;
    for (std::size_t i = 0; i < grains.size(); ++i) fluidForce_[i] -= step_.at.applied[i];
}

void CoupledRun::settleDebts()
{
    const ::nscd::Grains& grains = bodies();
    const scalar deltaT = time_.deltaTValue();
    const StepBalance here = settleDebt(step_, deltaT, debt_);
    // Impulse on the grains and change of their debts; sizes of forces, weights and debts.
    Vec3 got = here.debtChange;
    double sizes[3] = {0, 0, here.debt};
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const Vec3 dynamic = fluidForce_[i] + fluidDensity()*grains.volume(i)*toVec3(gravity_);
        got += deltaT*dynamic;
        sizes[0] += deltaT*dynamic.norm();
        sizes[1] += deltaT*grains.mass[i]*mag(gravity_);
    }
    ranks_.exchange()->sum(got.data(), 3);
    ranks_.exchange()->sum(sizes, 3);
    const scalar scale = std::max({sizes[0], sizes[1], double(VSMALL)});
    step_.momentumError = (deltaT*toVec3(immersion_->fluid->forceOnGrains()) - got).norm()/scale;
    step_.momentumDebt = sizes[2]/scale;
}

void CoupledRun::depositGrains()
{
    const auto timer = timing_.time(StepPart::depositGrains);
    if (!hasGrains()) return;
    if (!hasFluid())
    {
        if (locations_ && hasExits()) removeExited(locations_->update(dynamics_->grains()));
        else if (homes_ && hasExits()) removeExited(cellsElsewhere());
        return;
    }
    if (immersion_->sources.isStatic) return;
    if (homes_)
    {
        removeExited(cellsElsewhere());
        updateWeightsAtHome();
        if (!hasGrains()) immersion_->sources.clear();
        return;
    }
    updateWeights();
    removeThoseOutside();
}

void CoupledRun::removeThoseOutside()
{
    if (immersion_->mapping->report().outsideMesh.empty()) return;
    removeExited(immersion_->mapping->cells());
    updateWeights();
    if (!hasGrains()) immersion_->sources.clear();
}

void CoupledRun::updateWeights(const bool isMeshAhead)
{
    immersion_->mapping->setMeshAhead(isMeshAhead);
    if (homes_) homes_->update(dynamics_->grains(), isMeshAhead);
    updateWeightsAtHome();
    immersion_->mapping->setMeshAhead(false);
}

void CoupledRun::updateWeightsAtHome()
{
    if (homes_) bringHome();
    else immersion_->mapping->update(dynamics_->grains(), scene_.box, bodies_.parts());
    if (feedsBack()) immersion_->mapping->setFluidFraction(immersion_->sources.fluidFraction);
}

void CoupledRun::leaveDebts(const std::vector<std::size_t>& gone)
{
    if (!hasFluid()) return;
    const ::nscd::Grains& grains = bodies();
    std::vector<scalar> share(grains.mass.begin(), grains.mass.begin() + static_cast<std::ptrdiff_t>(grains.nOwned));
    for (std::size_t i : gone) share[i] = 0;
    double sums[4] = {0, 0, 0, std::accumulate(share.begin(), share.end(), scalar(0))};
    for (std::size_t i : gone)
    {
        for (int k = 0; k < 3; ++k) sums[k] += debt_[i][k];
    }
    ranks_.exchange()->sum(sums, 4);
    const Vec3 perMass = Vec3(sums)/std::max(sums[3], VSMALL);
    for (std::size_t i = 0; i < share.size(); ++i) debt_[i] += share[i]*perMass;
}

void CoupledRun::removeExited(const std::vector<label>& cells)
{
    const ExitedGrains exited = withWholeClumps(dynamics_->grains(), findExited
    (
        dynamics_->grains(), toLabelList(cells), mesh_, scene_.roles, ranks_.isParallel() ? &ranks_.tree() : nullptr
    ));
    const std::vector<std::size_t>& gone = exited.grains;
    double number = double(gone.size());
    ranks_.exchange()->sum(&number, 1);
    if (number == 0) return;
    ::nscd::Grains grains = dynamics_->grains();
    access_.recordExits(gone, exited.patches);
    const std::vector<std::size_t> bodiesGone = bodies_.bodiesOf(gone);
    leaveDebts(bodiesGone);
    if (heat_) heat_->dismiss(grains, gone);
    if (coarse_) coarse_->dismiss(grains, gone);
    eraseGrains(grains, gone);
    dynamics_->setGrains(std::move(grains));
    bodies_.update(dynamics_->grains());
    memory_.erase(bodiesGone);
    if (homes_) homes_->erase(gone);
    else if (immersion_) immersion_->mapping->erase(gone);
    if (locations_) locations_->erase(gone);
    exited_ += static_cast<std::int64_t>(number);
    nGrains_ -= static_cast<std::int64_t>(number);
}

} // namespace nscdCoupling
} // namespace Foam
