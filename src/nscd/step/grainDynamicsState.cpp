// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Making grain dynamics, looking at it, and storing it.
// Tested by tests/unit/nscd/scenes/restartTest.cpp, tests/unit/nscd/tools/sceneCheckpointTest.cpp
#include "nscd/step/grainDynamicsParts.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/scene/sceneCheck.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Candidates a grain below which a list is so short that it had better last longer, and above which it had better be shorter.
constexpr double fewCandidates = 0.5, manyCandidates = 2.0;
constexpr double mostStepsPerList = 64.0;
/// Candidates a grain above which lists are made for less scatter of grains, until they are fewer than the lower number. In a bed that bubbles lists of 11 a
/// grain became ones of 6, one in each step in place of one in one or two, and the grains' part of the step took 0.6 of the time.
constexpr double manyOfLongLists = 8.0, fewOfLongLists = 4.0;

void refuseBesideLaws(const ContactSettings& settings, const Materials& materials, bool areDiscs)
{
    if (areDiscs && materials.anyRoughness()) throw invalidValue("lubrication", "set", "none between discs");
    if (materials.anyRolling() && materials.anyRoughness()) throw invalidValue("lubrication", "set", "none where there is rolling or spinning friction");
    for (const ContactLawRow* law : lawsInUse(materials))
    {
        if (!law->isSwept || settings.solver == "NLGS") continue;
        throw invalidValue("contact solver", settings.solver, "NLGS where there is " + std::string(law->words));
    }
}

} // namespace

/// In a dilute cloud candidates cost little, and searches much; in a bed it is the other way round.
void GrainDynamics::Implementation::fitStepsPerList()
{
    double sums[2] = {static_cast<double>(list.candidates), static_cast<double>(grains.size())};
    exchange->sum(sums, 2);
    if (sums[0] < fewCandidates*sums[1]) stepsPerList = std::min(2.0*stepsPerList, mostStepsPerList);
    else if (sums[0] > manyCandidates*sums[1]) stepsPerList = std::max(0.5*stepsPerList, fewestStepsPerList);
    areListsLong = sums[0] > (areListsLong ? fewOfLongLists : manyOfLongLists)*sums[1];
}

void GrainDynamics::Implementation::chooseKernelsOfStep()
{
    const int axis = grains.shape.emptyAxis;
    const bool isPlanar = isFrictional && axis >= 0 && isInPlane(list, axis);
    kernelsOfStep = isPlanar ? planar(kernels, axis) : kernels;
    list.laws.chooseKernels(kernelsOfStep);
}

GrainDynamics::GrainDynamics
(
    Grains grains, Materials materials, Walls walls, PeriodicBox box,
    ContactSettings settings, std::shared_ptr<Exchange> exchange
)
:
    self_(std::make_unique<Implementation>())
{
    checkWalls(walls);
    checkGrains(grains, materials, walls);
    checkBox(box);
    checkSettings(settings);
    if (!exchange) throw invalidValue("exchange", "null", "an Exchange, or none given");
    self_->grains = std::move(grains);
    self_->grains.shrinkToFit();
    self_->materials = std::move(materials);
    self_->walls = std::move(walls);
    self_->movingWalls.setTime(0.0);
    self_->box = box;
    self_->settings = settings;
    self_->exchange = std::move(exchange);
    const ContactSolverRow& solver = findContactSolver(settings.solver);
    if (self_->exchange->isParallel() && !solver.worksOnRanks)
    {
        throw invalidValue("contact solver", settings.solver, "NLGS or NNCG where there are several ranks");
    }
    self_->solve = solver.solve;
    self_->kernels = chooseKernels(settings.vectorPath.c_str());
    refuseBesideLaws(settings, self_->materials, self_->grains.shape.dimensions == 2);
    checkGeneralBodies(self_->grains, self_->box, settings, self_->materials);
    // Whatever acts on spins.
    self_->isFrictional = actsOnSpins(self_->materials);
    if (!self_->isFrictional) self_->kernels = normalOnly(self_->kernels);
    self_->sumForces = ContactForceSum(self_->kernels);
    self_->measureGrains();
    self_->clearForces();
}

GrainDynamics::~GrainDynamics() = default;

const Grains& GrainDynamics::grains() const { return self_->grains; }

void GrainDynamics::setGrains(Grains grains)
{
    checkGrains(grains, self_->materials, self_->walls);
    checkGeneralBodies(grains, self_->box, self_->settings, self_->materials);
    double lastDeltaT;
    const std::vector<StoredImpulse> impulses = checkpoint(lastDeltaT);
    self_->grains = std::move(grains);
    self_->grains.shrinkToFit();
    self_->clearForces();
    restore(impulses, lastDeltaT);
}

void GrainDynamics::drive(std::size_t grain, const Vec3& velocity, const Vec3& omega)
{
    Grains& grains = self_->grains;
    if (grain >= grains.size() || !grains.isFixed[grain])
    {
        throw invalidValue("driven grain", grain, "the index of a held grain (isFixed)");
    }
    if (!velocity.allFinite() || !omega.allFinite())
    {
        throw invalidValue("velocity of driven grain " + std::to_string(grains.id[grain]), "not finite", "finite components [m/s, rad/s]");
    }
    if (velocity != grains.velocity[grain] || omega != grains.omega[grain]) self_->isAnyDrivenAnew = true;
    grains.velocity[grain] = velocity;
    grains.omega[grain] = omega;
}

std::vector<double> GrainDynamics::loads() const
{
    const ContactList& list = self_->wholeList();
    std::vector<double> load(self_->grains.size(), 1.0);
    if (self_->isListStale) return load;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        for (std::int32_t body : {block.a[slot % blockLanes], block.b[slot % blockLanes]})
        {
            if (body < list.owned()) load[list.grainOf[body]] += 0.5;
        }
    }
    return load;
}

std::size_t GrainDynamics::ghosts() const { return self_->isListStale ? 0 : self_->wholeList().ghosts.size() + self_->wholeList().solvedElsewhere.size(); }

const std::vector<Vec3>& GrainDynamics::contactForce() const { return self_->forces.force; }
const std::vector<Vec3>& GrainDynamics::contactTorque() const { return self_->forces.torque; }
const std::vector<Vec3>& GrainDynamics::wallForce() const { return self_->forces.wall; }
const std::vector<Vec3>& GrainDynamics::wallTorque() const { return self_->forces.wallTorque; }
const Walls& GrainDynamics::walls() const { return self_->walls; }
double GrainDynamics::time() const { return self_->movingWalls.time(); }
void GrainDynamics::setTime(double time) { self_->movingWalls.setTime(time); }
const StepTimes& GrainDynamics::times() const { return self_->times; }

std::vector<LoadedContact> GrainDynamics::Implementation::contactsOf(const ContactList& list)
{
    std::vector<LoadedContact> loaded;
    for (const SlotImpulse& entry : loadedSlots(list))
    {
        const ContactBlock& block = list.blocks[entry.slot/blockLanes];
        const int lane = entry.slot % blockLanes;
        const std::int64_t idB = entry.pair.b < 0 ? entry.pair.b : list.id[block.b[lane]];
        const Vec3 known = list.laws.known(entry.slot);
        loaded.push_back
        ({
            entry.pair.a, entry.pair.b, list.id[block.a[lane]], idB, normal(list, entry.slot), list.gap[entry.slot],
            entry.pair.impulse + known, known, list.laws.moment(list, entry.slot),
            entry.pair.b < 0 ? 0.0 : list.radius[block.b[lane]], block.friction[lane]
        });
    }
    return loaded;
}

std::vector<LoadedContact> GrainDynamics::contacts() const
{
    ContactList& list = self_->wholeList();
    self_->shockImpulses.swapWith(list);
    std::vector<LoadedContact> loaded = Implementation::contactsOf(list);
    self_->shockImpulses.swapWith(list);
    return loaded;
}

const std::vector<GhostGrain>& GrainDynamics::ghostsInContacts() const { return self_->wholeList().ghosts; }

std::vector<StoredImpulse> GrainDynamics::checkpoint(double& lastDeltaT)
{
    Implementation& self = *self_;
    lastDeltaT = self.impulseDeltaT;
    self.wakeAll();
    self.stepsAtCap = self.stepsOfManyImpacts = 0;
    self.packing.forget();
    if (!self.isListStale) self.restored = collectImpulses(self.list);
    self.list = ContactList();
    self.shockImpulses.clear();
    self.stepsPerList = fewestStepsPerList;
    self.areListsLong = false;
    self.fall.clear();
    self.isListStale = true;
    self.isStepBegun = false;
    return byIdentity(self.restored, self.grains);
}

void GrainDynamics::restore(const std::vector<StoredImpulse>& impulses, double lastDeltaT)
{
    Implementation& self = *self_;
    if (!(lastDeltaT >= 0.0) || !std::isfinite(lastDeltaT)) throw invalidValue("length of the last step", lastDeltaT, "a finite value >= 0 s");
    for (const StoredImpulse& stored : impulses)
    {
        const auto isFinite = [](const Vec3& impulse) { return impulse.allFinite(); };
        if (stored.impulse.allFinite() && std::all_of(stored.ofLaws.begin(), stored.ofLaws.end(), isFinite)) continue;
        throw invalidValue("stored impulse of grain " + std::to_string(stored.idA), "not finite", "finite components [N s]");
    }
    self.restored = byIndex(impulses, self.grains);
    self.impulseDeltaT = lastDeltaT;
    self.wakeAll();
    self.stepsAtCap = self.stepsOfManyImpacts = 0;
    self.packing.forget();
    self.list = ContactList();
    self.shockImpulses.clear();
    self.stepsPerList = fewestStepsPerList;
    self.areListsLong = false;
    self.fall.clear();
    self.isListStale = true;
    self.isStepBegun = false;
}

} // namespace nscd
