// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The grains' time step.
#include "grainDynamicsParts.hpp"

#include "andersonAcceleration.hpp"
#include "invalidValue.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace nscd
{

namespace
{

/// Steps of unchanged motion a rebuilt list should last.
constexpr double stepsPerList = 2.0;
constexpr int maxListRebuilds = 6;

} // namespace

void GrainDynamics::Implementation::measureGrains()
{
    double sums[2] = {2.0*std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0), static_cast<double>(grains.size())};
    exchange->sum(sums, 2);
    if (sums[1] > 0.0) diameter = sums[0]/sums[1];

    double extremes[2] = {0.0, 0.0};
    const std::vector<int> clumpOf = clumpOfGrains(grains);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.isFixed[i] || (!clumpOf.empty() && clumpOf[i] >= 0)) continue;
        extremes[0] = std::max(extremes[0], grains.mass[i]);
        extremes[1] = std::max(extremes[1], 1.0/grains.mass[i]);
    }
    measureClumps(grains.clumps, extremes);
    exchange->max(extremes, 2);
    massRatio = extremes[0]*extremes[1];
}

void GrainDynamics::Implementation::clearForces()
{
    const std::vector<Vec3> none(grains.size(), Vec3::Zero());
    const std::vector<Vec3> noneOnWalls(walls.patches.size(), Vec3::Zero());
    forces = {none, none, noneOnWalls, noneOnWalls};
}

/// Its cells are a few grains wide; made anew only where the grains have become others.
void GrainDynamics::Implementation::makeWallSearch()
{
    double largest = 0.0;
    for (double radius : grains.radius) largest = std::max(largest, radius);
    const bool isFitting = wallSearch && wallSearch->cellSize() >= 2.0*largest && wallSearch->cellSize() <= 8.0*largest;
    if (!isFitting) wallSearch = std::make_unique<WallSearch>(walls, largest > 0.0 ? 4.0*largest : diameter);
}

void GrainDynamics::Implementation::rebuildList(const std::vector<Vec3>& velocity)
{
    const Stopwatch watch(times.findPairs);
    // Within a step bonds are those of its start, whatever a solve has made of them since.
    const bool isWithinStep = isStepBegun && !list.cohesion.empty();
    ImpulseRecord impulses = isListStale ? std::move(restored) : isWithinStep ? beforeStep : collectImpulses(list);
    restored = ImpulseRecord();

    // A slow grain may be hit, and be as fast as the others at the end of the step.
    double sums[2] = {0.0, static_cast<double>(velocity.size())};
    for (const Vec3& v : velocity) sums[0] += v.squaredNorm();
    exchange->sum(sums, 2);
    const double commonSpeed = std::sqrt(sums[0]/std::max(1.0, sums[1]));
    const double range = materials.cohesionRange();
    std::vector<double> reach(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        reach[i] = range + 0.5*settings.skin*diameter + stepsPerList*deltaT*std::max(velocity[i].norm(), commonSpeed);
    }
    list = ContactList();  // two at a time would be the peak of the memory
    makeWallSearch();
    list = buildContactList(scene(), *wallSearch, reach, movingWalls.reach(*wallSearch, grains, reach, diameter), diameter, *exchange);
    updateGeometry(list, scene());
    assignImpulses(list, std::move(impulses), *exchange);
    markBonds(list);
    isListStale = false;
}

double GrainDynamics::Implementation::measureMotion(double speedScale) const
{
    if (!(speedScale > 0.0)) return 1.0;
    double sums[2] = {0.0, static_cast<double>(grains.size())};
    for (const Vec3& v : grains.velocity) sums[0] += std::min(1.0, v.norm()/speedScale);
    exchange->sum(sums, 2);
    return sums[1] > 0.0 ? sums[0]/sums[1] : 1.0;
}

SolveReport GrainDynamics::Implementation::solveOnce(const ExternalForces& external)
{
    {
        const Stopwatch watch(times.buildContacts);
        do
        {
            setFreeVelocities(list, grains, external, deltaT, sleep);
            if (!list.clumps.empty()) setFreeClumps(list, grains, external, deltaT);
            movingWalls.setVelocities(list, grains.shape.emptyAxis);
        }
        while (sleep.any() && sleep.wakeByContacts(list, deltaT, deadBand()));
        prepareSlots(list, kernels, deltaT, deadBand(), impulseDeltaT > 0.0 ? deltaT/impulseDeltaT : 1.0);
        impulseDeltaT = deltaT;
    }
    const Stopwatch watch(times.solveContacts);
    ContactProblem problem = makeProblem(external.speedScale);
    problem.motion = measureMotion(external.speedScale);
    const SolveReport report = solve(problem, settings);
    if (!list.clumps.empty()) takeClumpVelocities(list, grains.shape);
    return report;
}

SolveReport GrainDynamics::Implementation::solveAndWake(const ExternalForces& external)
{
    SolveReport report = solveOnce(external);
    while (sleep.any() && sleep.wakeByContacts(list, deltaT, deadBand()))
    {
        const int before = report.sweeps;
        report = solveOnce(external);
        report.sweeps += before;
    }
    return report;
}

SolveReport GrainDynamics::Implementation::solveVelocities(const ExternalForces& external)
{
    SolveReport report = solveAndWake(external);
    // Grains that turn out faster than the list allows for could pass one another unseen: list and solve again.
    for (int attempt = 0; !coversStep(); ++attempt)
    {
        if (attempt == maxListRebuilds) throw std::runtime_error("contact list cannot follow the grains; use a smaller time step");
        std::vector<Vec3> velocity(grains.size());
        for (int body = 0; body < list.owned(); ++body)
        {
            velocity[list.grainOf[body]] = (attempt + 1.0)*Vec3(list.bodies[body].v);
        }
        const int before = report.sweeps, newtonBefore = report.newtonSteps;
        rebuildList(velocity);
        report = solveAndWake(external);
        report.sweeps += before;
        report.newtonSteps += newtonBefore;
    }
    return report;
}

void GrainDynamics::Implementation::rebound(const ExternalForces& external, SolveReport& report)
{
    std::vector<Body> inelastic = list.bodies;
    setFreeVelocities(list, grains, external, deltaT, sleep);
    if (!list.clumps.empty()) mirrorFreeClumps(list, list.bodies);
    const std::vector<Body> freeBodies = std::move(list.bodies);
    list.bodies = std::move(inelastic);
    // Below twice what the forces add in a step a rebound is noise of a resting contact.
    if (!setRestitutionBias(list, freeBodies, 2.0*external.speedScale, deadBand())) return;

    ContactProblem problem = makeProblem(external.speedScale);
    AndersonAcceleration::Impulses beforeShock;
    gatherImpulses(list.blocks, {nullptr, list.blocks.size()}, beforeShock);
    const RollingSlots rollingBeforeShock = list.rolling;
    // Nothing moves with these velocities within the step, so no displacement limits them: the rms tolerance alone does.
    ContactSettings shockSettings = settings;
    shockSettings.displacementTolerance = 1.0;
    const SolveReport shock = solve(problem, shockSettings);
    if (!list.clumps.empty()) takeClumpVelocities(list, grains.shape);
    report.sweeps += shock.sweeps;
    report.newtonSteps += shock.newtonSteps;
    report.converged = report.converged && shock.converged;
    report.residualRms = std::max(report.residualRms, shock.residualRms);
    report.residualMax = std::max(report.residualMax, shock.residualMax);
    forces = contactForces();
    // The next step starts from the impulses of the motion, not from those of the shock.
    for (std::size_t k = 0; k < list.blocks.size(); ++k)
    {
        std::copy_n(beforeShock.begin() + static_cast<std::ptrdiff_t>(3*blockLanes*k), 3*blockLanes, &list.blocks[k].r[0][0]);
    }
    list.rolling = rollingBeforeShock;
}

void GrainDynamics::Implementation::correctPositions(StepReport& report)
{
    updateGeometry(list, scene());
    OverlapStatistics overlap = measureOverlap(list);
    const double tolerance = settings.overlapTolerance*diameter;
    if (overlap.deepest > tolerance)
    {
        report.correctionSweeps = list.clumps.empty()
            ? correctOverlaps(list, scene(), overlap.deepest, tolerance, deadBand())
            : correctClumpOverlaps(list, grains, scene(), overlap.deepest, tolerance, deadBand());
        for (int body = 0; body < list.owned(); ++body) grains.position[list.grainOf[body]] = box.wrap(list.position[body]);
        overlap = measureOverlap(list);
    }
    report.overlapMax = overlap.max/diameter;
    report.overlapMean = overlap.mean/diameter;
}

void GrainDynamics::Implementation::wakeDisturbed(const ExternalForces& external)
{
    if (!sleep.any()) return;
    const bool wasEverybodyAsleep = sleep.isEverybodyAsleep();
    sleep.wakeByForces(grains, external, deltaT);
    // The list was not looked at when the step began.
    if (wasEverybodyAsleep && !coversStep()) rebuildList(grains.velocity);
}

StepReport GrainDynamics::Implementation::restingReport() const
{
    StepReport report = lastReport;
    report.solve.sweeps = 0;
    report.listRebuilt = false;
    report.correctionSweeps = 0;
    report.maxDisplacement = 0.0;
    return report;
}

void GrainDynamics::beginStep(double deltaT)
{
    if (!(deltaT > 0.0) || !std::isfinite(deltaT)) throw invalidValue("time step", deltaT, "a finite value > 0 s");
    Implementation& self = *self_;
    const bool haveJumped = self.movingWalls.beginStep(deltaT);
    if (deltaT != self.deltaT || haveJumped || self.movingWalls.isAnyMoving()) self.sleep.wakeAll();
    self.deltaT = deltaT;
    if (self.sleep.isEverybodyAsleep()) return;
    if (self.isListStale) self.measureGrains();
    if (self.isListStale || !self.coversStep()) self.rebuildList(self.grains.velocity);
    else if (haveJumped) updateGeometry(self.list, self.scene());
    if (self.isStepBegun) return;
    self.isStepBegun = true;
    markBonds(self.list);
    self.beforeStep = self.list.cohesion.empty() ? ImpulseRecord() : collectImpulses(self.list);
}

bool GrainDynamics::hasContacts() const { return self_->list.halo.any(self_->list.candidates > 0); }

Prediction GrainDynamics::predict(const ExternalForces& external)
{
    self_->sleep.wakeAll();
    Prediction prediction;
    prediction.solve = self_->solveVelocities(external);
    prediction.velocity.resize(self_->grains.size());
    for (int body = 0; body < self_->list.owned(); ++body)
    {
        prediction.velocity[self_->list.grainOf[body]] = Vec3(self_->list.bodies[body].v);
    }
    prediction.contactForce = self_->contactForces().force;
    return prediction;
}

Prediction GrainDynamics::tryForces(const ExternalForces& external)
{
    ImpulseRecord impulses = collectImpulses(self_->list);
    Prediction prediction = predict(external);
    for (std::size_t slot = 0; slot < self_->list.slots(); ++slot)
    {
        if (self_->list.isUsed(slot)) setImpulse(self_->list, slot, Vec3::Zero());
    }
    for (RollingSlot& slot : self_->list.rolling) std::fill_n(slot.q, 3, 0.0);
    assignImpulses(self_->list, std::move(impulses), *self_->exchange);
    return prediction;
}

StepReport GrainDynamics::advance(const ExternalForces& external)
{
    Implementation& self = *self_;
    self.wakeDisturbed(external);
    if (self.sleep.isEverybodyAsleep())
    {
        self.movingWalls.endStep();
        return self.restingReport();
    }
    StepReport report;
    const double findPairsBefore = self.times.findPairs;
    report.solve = self.solveVelocities(external);
    report.listRebuilt = self.times.findPairs > findPairsBefore;
    report.candidates = static_cast<std::size_t>(self.list.halo.sum(static_cast<double>(self.list.candidates)));

    const Stopwatch watch(self.times.moveGrains);
    self.forces = self.contactForces();
    report.maxDisplacement = moveGrains(self.list, self.grains, self.box, self.deltaT, self.isFrictional)/self.diameter;
    if (self.materials.anyRestitution()) self.rebound(external, report.solve);
    self.movingWalls.endStep();
    copyVelocities(self.list, self.grains);
    self.correctPositions(report);
    if (self.settings.sleep && !self.exchange->isParallel() && self.grains.clumps.empty())
    {
        self.sleep.fallAsleep(self.list, self.grains, external, report.solve.speedScale, self.deadBand());
        report.asleep = self.sleep.count();
    }
    self.lastReport = report;
    self.isStepBegun = false;
    return report;
}

} // namespace nscd
