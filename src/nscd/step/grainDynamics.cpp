// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The grains' time step.
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/solvers/heldFriction.hpp"
#include "nscd/step/generalCorrection.hpp"
#include "nscd/step/overlapCorrection.hpp"
#include "nscd/step/sweptPairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace nscd
{

namespace
{

constexpr int maxListRebuilds = 6;

void checkLength(const char* name, std::size_t length, std::size_t grains)
{
    if (length != 0 && length != grains) throw invalidValue(name, length, "an entry for each of the " + std::to_string(grains) + " grains, or none");
}

void checkForces(const ExternalForces& external, std::size_t grains)
{
    checkLength("number of forces", external.force.size(), grains);
    checkLength("number of torques", external.torque.size(), grains);
    checkLength("number of implicit drags", external.implicitDrag.size(), grains);
    checkLength("number of implicit spin drags", external.implicitSpinDrag.size(), grains);
    if (!(external.speedScale >= 0.0) || !std::isfinite(external.speedScale)) throw invalidValue("speed scale", external.speedScale, "a finite value >= 0 m/s");
}

} // namespace

void GrainDynamics::Implementation::measureGrains()
{
    double sums[2] = {2.0*std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0), static_cast<double>(grains.size())};
    exchange->sum(sums, 2);
    if (sums[1] > 0.0) diameter = sums[0]/sums[1];

    std::array<double, 2> extremes = massExtremes(grains);
    exchange->max(extremes.data(), 2);
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
    areWallsOutlined = std::any_of(walls.regions.begin(), walls.regions.end(), [](const WallRegion& region) { return !region.edges.empty(); });
    if (!isFitting) wallSearch = std::make_unique<WallSearch>(walls, largest > 0.0 ? 4.0*largest : diameter);
}

void GrainDynamics::Implementation::rebuildList(const std::vector<Vec3>& velocity, double margin)
{
    const auto timer = times.time(GrainPart::findPairs);
    shockImpulses.clear();
    const bool areSomeAsleep = sleep.any();
    // Within a step laws act by the impulses at its start, whatever a solve has made of them since.
    const bool isWithinStep = isStepBegun && list.laws.areOfStart() && !areSomeAsleep;
    // What such laws did in the last step, which belongs to the forces on sleeping grains, is lost with a list.
    if (areSomeAsleep && list.laws.areOfStart()) wakeAll();
    else if (areSomeAsleep) list = awakePart.release();
    ImpulseRecord impulses = isListStale ? std::move(restored) : isWithinStep ? beforeStep : collectImpulses(list);
    restored = ImpulseRecord();

    makeWallSearch();
    ListPlan plan = planList(velocity, margin);
    plan.expected.areStraysFollowed = mayFollowStrays();
    std::vector<double> reach(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) reach[i] = reachAtRest() + plan.expected.time*plan.speed[i];
    std::vector<WallReach> wallReach = movingWalls.reach(*wallSearch, grains, reach, diameter);
    if (areWallsOutlined) lookForFast(plan, reach, wallReach);
    plan.expected.reachToMany = reachToMany;
    plan.expected.mayBeStopped = isAnyFast && exchange->isParallel();
    list = buildContactList(scene(), *wallSearch, reach, std::move(wallReach), diameter, *exchange, std::move(list), plan.expected);
    updateGeometry(list, scene());
    findFastPairs(list);
    assignImpulses(list, std::move(impulses), *exchange);
    list.laws.beginStep(list);
    isListStale = false;
    isListNew = true;
    fitStepsPerList();
    if (!sleep.any()) return;
    holdWholeList();
    cutAwakePart();
}

double GrainDynamics::Implementation::measureMotion(double speedScale) const
{
    if (!(speedScale > 0.0)) return 1.0;
    double sums[2] = {0.0, static_cast<double>(grains.size())};
    for (int i : list.grainOf) sums[0] += std::min(1.0, grains.velocity[i].norm()/speedScale);
    exchange->sum(sums, 2);
    return sums[1] > 0.0 ? sums[0]/sums[1] : 1.0;
}

/// Whether a wall that a grain is near goes faster than the speed scale.
bool GrainDynamics::Implementation::areWallsDriving(double speedScale) const
{
    const bool isAnyFast = std::any_of(list.bodies.begin() + list.firstWallBody(), list.bodies.end(), [=](const Body& wall) { return Vec3(wall.v).norm() > speedScale; });
    return list.halo.any(isAnyFast);
}

void GrainDynamics::Implementation::prepareSolve(const ExternalForces& external)
{
    const auto timer = times.time(GrainPart::buildContacts);
    setFreeVelocities(list, grains, external, deltaT, sleep);
    if (!list.general.empty()) setFreeGeneral(list, grains, external, deltaT, sleep);
    keepVelocities(list, freeVelocity);
    movingWalls.setVelocities(list, box, grains.shape.emptyAxis);
    if (!list.fastPairs.empty()) aimFastPairs(list, box, deltaT);
    chooseKernelsOfStep();
    prepareSlots(list, kernelsOfStep, deltaT, deadBand(), impulseDeltaT > 0.0 ? deltaT/impulseDeltaT : 1.0);
    impulseDeltaT = deltaT;
}

ContactProblem GrainDynamics::Implementation::makeProblem(double speedScale)
{
    ContactProblem problem
    {
        list.bodies, list.blocks, list.awake, list.interfaceBlock, list.halo, kernelsOfStep, isFrictional, deltaT, speedScale, diameter,
        list.position
    };
    problem.massRatio = massRatio;
    problem.lawBlocks = list.laws.sweptBlocks();
    problem.areFilms = materials.anyRoughness();
    problem.general = list.general.empty() ? nullptr : &list.general;
    problem.packing = &packing;
    problem.freeVelocity = &freeVelocity;
    problem.times = &times;
    return problem;
}

ContactProblem GrainDynamics::Implementation::prepareProblem(const ExternalForces& external)
{
    prepareSolve(external);
    ContactProblem problem = makeProblem(external.speedScale);
    problem.motion = measureMotion(external.speedScale);
    problem.isDriven = areWallsDriving(external.speedScale);
    return problem;
}

/// A solve of the step's problem, timed, with its account of energy.
SolveReport GrainDynamics::Implementation::solveBy
(
    ContactSolver solver, ContactProblem& problem, const ContactSettings& asked, const ExternalForces& external
)
{
    const auto timer = times.time(GrainPart::solveContacts);
    SolveReport report = solveWhereAwake(problem, asked, solver);
    list.laws.endSolve();
    if (!report.converged) report.createdEnergy = createdEnergy(external, report);
    return report;
}

SolveReport GrainDynamics::Implementation::solveOnce(const ExternalForces& external, const ContactSettings& asked)
{
    ContactProblem problem = prepareProblem(external);
    SolveReport report = solveBy(solve, problem, asked, external);
    if (mayHoldFriction() && (isHarmful(report) || isJammed(report, problem))) report = together(report, solveAnew(solveHeld, external, asked));
    isPressed = isFlung(report);
    if (isPressed) report = together(report, solveAnew(solvePressed, external, asked));
    report.isSqueezed = mayBeSqueezed(report);
    if (!list.general.empty()) takeGeneralVelocities(list, grains.shape);
    return report;
}

SolveReport GrainDynamics::Implementation::solveVelocities(const ExternalForces& external)
{
    SolveReport report = solveAndWake(external);
    // Grains that turn out faster than the list allows for could pass one another unseen: list what they may meet, and solve again.
    int lists = 0, mended = 0;
    for (Coverage coverage = coverOrMend(); coverage != Coverage::whole; coverage = coverOrMend())
    {
        if (coverage == Coverage::mended && ++mended <= maxListRebuilds)
        {
            report = together(report, solveAndWake(external));
            continue;
        }
        if (lists++ == maxListRebuilds) throw std::runtime_error("contact list cannot follow the grains; use a smaller time step");
        std::vector<Vec3> velocity = grains.velocity;   // of those that sleep, which are not in the list
        for (int body = 0; body < list.owned(); ++body)
        {
            velocity[list.grainOf[body]] = Vec3(list.bodies[body].v);
        }
        rebuildList(velocity, lists);
        report = together(report, solveAndWake(external));
    }
    return report;
}

/// Geometry where grains are now.
OverlapStatistics GrainDynamics::Implementation::placeContacts()
{
    const auto timer = times.time(GrainPart::updateGeometry);
    updateGeometry(list, scene());
    return measureOverlap(list);
}

void GrainDynamics::Implementation::correctPositions(StepReport& report)
{
    OverlapStatistics overlap = placeContacts();
    // Here, as a rebound that woke grains has another list than the motion.
    if (isAnyFast) atMissedWalls = bodiesAtMissedWalls(list, wallsOfStep());
    std::vector<WallGap> missed = gapsToMissedWalls(list, wallsOfStep(), atMissedWalls);
    double inMissedWalls = deepestOfRanks(missed);
    const double deepest = std::max(overlap.deepest, inMissedWalls);
    report.overlapUncorrected = std::max(deepest, 0.0)/diameter;
    const double tolerance = settings.overlapTolerance*diameter;
    if (deepest > tolerance)
    {
        const auto timer = times.time(GrainPart::correctOverlaps);
        report.correctionSweeps = list.general.empty()
            ? correctOverlaps(list, scene(), missed, deepest, tolerance, deadBand())
            : correctGeneralOverlaps(list, grains, scene(), missed, deepest, tolerance, deadBand());
        for (int body = 0; body < list.owned(); ++body) grains.position[list.grainOf[body]] = box.wrap(list.position[body]);
        overlap = measureOverlap(list);
        inMissedWalls = deepestOfRanks(gapsToMissedWalls(list, wallsOfStep(), atMissedWalls));
    }
    report.overlapMax = std::max({overlap.max, inMissedWalls, sleep.any() ? overlapAsleep : 0.0})/diameter;
    report.overlapMean = overlap.mean/diameter;
}

void GrainDynamics::Implementation::checkReady(const ExternalForces& external) const
{
    if (isListStale) throw std::logic_error("a step of grains needs beginStep() first, also after setGrains(), checkpoint() and restore()");
    checkForces(external, grains.size());
}

StepReport GrainDynamics::Implementation::restingReport() const
{
    StepReport report = lastReport;
    report.solve.sweeps = 0;
    report.solve.newtonSteps = 0;
    report.listRebuilt = false;
    report.correctionSweeps = 0;
    report.maxDisplacement = 0.0;
    return report;
}

/// What a step needs in which anything is awake.
void GrainDynamics::Implementation::beginAwakeStep(bool haveWallsJumped)
{
    if (isListStale) measureGrains();
    if (isListStale || coverOrMend() == Coverage::none) rebuildList(grains.velocity, 1.0);
    else if (haveWallsJumped) placeContacts();
    if (isStepBegun) return;
    isStepBegun = true;
    list.laws.beginStep(list);
    if (!sleep.any()) beforeStep = list.laws.areOfStart() ? collectImpulses(list) : ImpulseRecord();
}

void GrainDynamics::beginStep(double deltaT)
{
    if (!(deltaT > 0.0) || !std::isfinite(deltaT)) throw invalidValue("time step", deltaT, "a finite value > 0 s");
    Implementation& self = *self_;
    const auto timer = self.times.time(GrainPart::moveGrains);
    const bool haveJumped = self.movingWalls.beginStep(deltaT);
    if (deltaT != self.deltaT || haveJumped || self.movingWalls.isAnyMoving() || self.haveDrivenChanged()) self.wakeAll();
    self.deltaT = deltaT;
    if (!self.isEverybodyAsleep()) self.beginAwakeStep(haveJumped);
}

bool GrainDynamics::hasContacts() const { return self_->list.halo.any(self_->wholeList().candidates > 0); }

StepReport GrainDynamics::advance(const ExternalForces& external)
{
    Implementation& self = *self_;
    const auto timer = self.times.time(GrainPart::moveGrains);
    self.checkReady(external);
    self.shockImpulses.clear();
    self.wakeDisturbed(external);
    if (self.isEverybodyAsleep())
    {
        self.movingWalls.endStep();
        return self.restingReport();
    }
    if (!self.isStepBegun) self.beginAwakeStep(false);
    StepReport report;
    report.solve = self.solveVelocities(external);
    report.listRebuilt = self.isListNew;
    self.isListNew = false;
    report.candidates = static_cast<std::size_t>(self.list.halo.sum(static_cast<double>(self.wholeList().candidates)));

    const auto giveForces = [&]() { giveToGrains(self.forcesOnBodies(), self.list.grainOf, self.forces); };
    // Where there was no room the shock has none either, and would press again by sweeps that swing.
    const bool mayRebound = self.materials.anyRestitution() && !self.isPressed;
    if (!mayRebound) giveForces();
    report.maxDisplacement = self.moveBodies(report)/self.diameter;
    if (mayRebound && !self.rebound(external, report.solve)) giveForces();
    self.movingWalls.endStep();
    copyVelocities(self.list, self.grains);
    self.correctPositions(report);
    if (self.maySleep()) self.letSleep(external, report);
    self.stepsAtCap = report.solve.atCap ? self.stepsAtCap + 1 : 0;
    report.solve.stepsAtCap = self.stepsAtCap;
    self.stepsOfManyImpacts = report.solve.impacts > manyImpacts ? self.stepsOfManyImpacts + 1 : 0;
    report.solve.stepsOfManyImpacts = self.stepsOfManyImpacts;
    self.lastReport = report;
    self.isStepBegun = false;
    return report;
}

} // namespace nscd
