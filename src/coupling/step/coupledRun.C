// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The seven parts of a time step.
#include "coupling/step/coupledRun.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/step/grainForces.H"

#include "input/scene/drivenReader.hpp"

#include <algorithm>

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

::nscd::ExternalForces withoutFluid(std::vector<Vec3> force)
{
    ::nscd::ExternalForces external;
    external.force = std::move(force);
    return external;
}

} // namespace

bool CoupledRun::nextStep()
{
    if (!time_.run()) return false;
    if (reach_.isKnown) adjustTimeStep(time_, reach_, properties_.time.maxGrainDisplacement);
    dynamics_->setTime(time_.value());
    ++time_;
    balanceRanks();
    driveTo(time_.value(), time_.deltaTValue());
    if (hasFluid()) immersion_->sources.beginStep();
    return true;
}

void CoupledRun::driveTo(scalar end, scalar deltaT)
{
    toldByFoam([&] { input::driveGrains(properties_.driven, *dynamics_, end - deltaT, end); });
}

void CoupledRun::sampleFluid()
{
    const auto timer = timing_.time(StepPart::sampleFluid);
    if (!hasFluid() || !hasGrains()) return;
    const volScalarField* alpha = feedsBack() ? &immersion_->sources.alpha : nullptr;
    nscdCoupling::sampleFluid(*immersion_->fluid, alpha, *immersion_->mapping, immersion_->atHome, active_, step_.at);
}

void CoupledRun::linearizeDrag()
{
    const auto timer = timing_.time(StepPart::linearizeDrag);
    const scalar deltaT = time_.deltaTValue();
    step_.predictorSweeps = -1;
    step_.predictorConverged = true;
    if (!hasFluid() || !hasGrains()) return;

    const ::nscd::Grains& grains = dynamics_->grains();
    const scalar rho = immersion_->fluid->rho().value();
    step_.startVelocity = grains.velocity;
    step_.force = steadyForces(grains, step_.at, active_, rho, gravity_);
    step_.drag = active_.drag
        ? nscdCoupling::linearizeDrag(grains, step_.at, step_.force, lastContactForce_, dragModel(), deltaT)
        : noDrag(grains);
    ranks_.exchange()->max(&step_.drag.largestStiffness, 1);
    if (!feedsBack()) return;

    step_.response = isLagAllowed() ? laggedResponse(grains) : predictResponse();
    double responds = step_.response.isZero ? 0 : 1;
    ranks_.exchange()->max(&responds, 1);
    step_.response.isZero = responds == 0;
    handOver
    (
        grains, step_.drag, step_.response, debt_, *immersion_->mapping, immersion_->atHome, rho, deltaT, immersion_->sources
    );
}

bool CoupledRun::isLagAllowed() const
{
    if (step_.drag.largestStiffness > weakDrag) return false;
    const ::nscd::Grains& grains = dynamics_->grains();
    const scalar rho = immersion_->fluid->rho().value();
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
    const ::nscd::Grains& grains = dynamics_->grains();
    const scalar deltaT = time_.deltaTValue();
    ::nscd::ExternalForces external = externalForces(grains, step_.force, step_.drag, step_.at);
    external.speedScale = speedScale
    (
        grains, step_.at, step_.drag.implicit, step_.drag.remainder, immersion_->fluid->rho().value(), gravity_, deltaT,
        *ranks_.exchange()
    );
    dynamics_->beginStep(deltaT);
    ::nscd::Prediction prediction = freePrediction(grains, external, deltaT);
    std::vector<scalar> mobility(grains.size(), 1.0);
    if (dynamics_->hasContacts())
    {
        prediction = dynamics_->predict(external);
        const TrialPush push = makeTrialPush(grains, step_.force, step_.drag, step_.at, external, deltaT);
        const ::nscd::Prediction pushed = dynamics_->tryForces(push.external);
        mobility = followedShare(push, step_.force, prediction, pushed);
        step_.predictorSweeps = prediction.solve.sweeps + pushed.solve.sweeps;
        step_.predictorConverged = prediction.solve.converged && pushed.solve.converged;
    }
    return contactAwareResponse(grains, step_.drag, step_.at, prediction, mobility, active_.pressureGradient, deltaT);
}

void CoupledRun::solveFluid()
{
    const auto timer = timing_.time(StepPart::solveFluid);
    if (!hasFluid()) return;
    immersion_->fluid->solve();
    reach_.courant = immersion_->fluid->courantNumber().max;
    step_.spreadForce = feedsBack() ? nscdCoupling::spreadForce(immersion_->sources, *immersion_->fluid) : vector(Zero);
}

void CoupledRun::fluidForces()
{
    const auto timer = timing_.time(StepPart::fluidForces);
    if (!hasGrains()) return;
    const ::nscd::Grains& grains = dynamics_->grains();
    if (!hasFluid())
    {
        step_.force = steadyForces(grains, step_.at, active_, 0, gravity_);
        return;
    }
    const volScalarField* alpha = feedsBack() ? &immersion_->sources.alpha : nullptr;
    nscdCoupling::sampleFluid(*immersion_->fluid, alpha, *immersion_->mapping, immersion_->atHome, active_, step_.at);
    step_.force = steadyForces(grains, step_.at, active_, immersion_->fluid->rho().value(), gravity_);
}

void CoupledRun::advanceGrains()
{
    const auto timer = timing_.time(StepPart::advanceGrains);
    if (!hasGrains()) return;
    const label subCycles = properties_.time.subCycles;
    const scalar deltaT = time_.deltaTValue()/subCycles;
    step_.received.assign(dynamics_->grains().size(), Vec3::Zero());
    step_.grainReport = ::nscd::StepReport();
    for (label cycle = 0; cycle < subCycles; ++cycle)
    {
        if (subCycles > 1) driveTo(time_.value() - (subCycles - 1 - cycle)*deltaT, deltaT);
        const LinearDrag drag = subCycles == 1 || !active_.drag
            ? step_.drag : splitAgain(dynamics_->grains(), step_.drag, dragModel().weighting, deltaT);
        step_.grainReport = worstOf(step_.grainReport, advanceOnce(drag, deltaT), cycle + 1);
    }
    reach_.displacement = step_.grainReport.maxDisplacement*subCycles;
    lastContactForce_ = dynamics_->contactForce();
    if (hasFluid()) recordFluidForce();
    if (hasFluid() && feedsBack()) settleDebt();
}

::nscd::StepReport CoupledRun::advanceOnce(const LinearDrag& drag, scalar deltaT)
{
    const ::nscd::Grains& grains = dynamics_->grains();
    const scalar rho = hasFluid() ? immersion_->fluid->rho().value() : 0;
    ::nscd::ExternalForces external = hasFluid()
        ? externalForces(grains, step_.force, drag, step_.at) : withoutFluid(step_.force);
    external.speedScale = speedScale
    (
        grains, step_.at, drag.implicit, drag.remainder, rho, gravity_, deltaT, *ranks_.exchange()
    );

    const std::vector<Vec3> before = drag.implicit.empty() ? std::vector<Vec3>() : grains.velocity;
    dynamics_->beginStep(deltaT);
    const ::nscd::StepReport report = dynamics_->advance(external);
    for (std::size_t i = 0; i < drag.implicit.size(); ++i)
    {
        const Vec3& u = step_.at.velocity[i];
        step_.received[i] += deltaT*(drag.implicit[i]*(u - grains.velocity[i]) + drag.remainder[i]*(u - before[i]));
    }
    return report;
}

void CoupledRun::recordFluidForce()
{
    const ::nscd::Grains& grains = dynamics_->grains();
    fluidForce_.resize(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        fluidForce_[i] = step_.force[i] - grains.mass[i]*toVec3(gravity_) + step_.received[i]/time_.deltaTValue();
    }
}

void CoupledRun::settleDebt()
{
    const scalar deltaT = time_.deltaTValue();
    Vec3 balance = Vec3::Zero();
    double sizes[2] = {0, 0};   // of what grains received, and of what they carry [N s]
    for (std::size_t i = 0; i < step_.received.size(); ++i)
    {
        const Vec3& u = step_.at.velocity[i];
        const Vec3 gradient = active_.pressureGradient ? step_.at.pressureGradient[i] : Vec3(Vec3::Zero());
        const Vec3 paid = deltaT*paidDrag(step_.drag, step_.response, step_.startVelocity[i], i, u, gradient);
        const Vec3 repaid = repaidShare*debt_[i];
        balance += paid - repaid;
        sizes[0] += step_.received[i].norm();
        sizes[1] += dynamics_->grains().mass[i]*step_.startVelocity[i].norm();
        debt_[i] += paid - step_.received[i] - repaid;
    }
    ranks_.exchange()->sum(balance.data(), 3);
    ranks_.exchange()->sum(sizes, 2);
    balance += deltaT*toVec3(step_.spreadForce);
    step_.momentumError = balance.norm()/std::max({sizes[0], sizes[1], VSMALL});
}

void CoupledRun::depositGrains()
{
    const auto timer = timing_.time(StepPart::depositGrains);
    if (!hasGrains()) return;
    if (!hasFluid())
    {
        if (locations_) removeExited(locations_->update(dynamics_->grains()));
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
    if (immersion_->mapping->report().outsideMesh.empty()) return;
    removeExited(immersion_->mapping->cells());
    updateWeights();
    if (!hasGrains()) immersion_->sources.clear();
}

void CoupledRun::updateWeights()
{
    if (homes_) homes_->update(dynamics_->grains());
    updateWeightsAtHome();
}

void CoupledRun::updateWeightsAtHome()
{
    if (homes_) bringHome();
    else immersion_->mapping->update(dynamics_->grains(), scene_.box);
    if (feedsBack()) immersion_->mapping->voidFraction(immersion_->sources.alpha);
}

void CoupledRun::removeExited(const std::vector<label>& cells)
{
    const labelList cellList(cells.begin(), cells.end());
    const std::vector<std::size_t> gone = findExited
    (
        dynamics_->grains(), cellList, mesh_, scene_.roles, ranks_.isParallel() ? &ranks_.tree() : nullptr
    );
    double number = double(gone.size());
    ranks_.exchange()->sum(&number, 1);
    if (number == 0) return;
    ::nscd::Grains grains = dynamics_->grains();
    eraseGrains(grains, gone);
    dynamics_->setGrains(std::move(grains));
    for (std::vector<Vec3>* perGrain : {&debt_, &lastContactForce_, &fluidForce_}) eraseAt(*perGrain, gone);
    if (homes_) homes_->erase(gone);
    exited_ += static_cast<std::int64_t>(number);
    nGrains_ -= static_cast<std::int64_t>(number);
}

} // namespace nscdCoupling
} // namespace Foam
