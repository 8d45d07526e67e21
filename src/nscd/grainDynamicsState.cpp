// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Making grain dynamics, looking at it, and storing it.
#include "grainDynamicsParts.hpp"

#include "invalidValue.hpp"
#include "sceneCheck.hpp"
#include "sweepKernels.hpp"

#include <cmath>

namespace nscd
{

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
    if (settings.solver != "NLGS" && self_->materials.anyRolling())
    {
        throw invalidValue("contact solver", settings.solver, "NLGS where there is rolling or spinning friction");
    }
    // Whatever acts on spins.
    self_->isFrictional = self_->materials.anyFriction() || self_->materials.anyRolling();
    self_->measureGrains();
    self_->clearForces();
}

GrainDynamics::~GrainDynamics() = default;

const Grains& GrainDynamics::grains() const { return self_->grains; }

void GrainDynamics::setGrains(Grains grains)
{
    double lastDeltaT;
    const std::vector<StoredImpulse> impulses = checkpoint(lastDeltaT);
    checkGrains(grains, self_->materials, self_->walls);
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
    if (velocity != grains.velocity[grain] || omega != grains.omega[grain]) self_->sleep.wakeAll();
    grains.velocity[grain] = velocity;
    grains.omega[grain] = omega;
}

std::vector<double> GrainDynamics::loads() const
{
    const ContactList& list = self_->list;
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

const std::vector<Vec3>& GrainDynamics::contactForce() const { return self_->forces.force; }
const std::vector<Vec3>& GrainDynamics::contactTorque() const { return self_->forces.torque; }
const std::vector<Vec3>& GrainDynamics::wallForce() const { return self_->forces.wall; }
const std::vector<Vec3>& GrainDynamics::wallTorque() const { return self_->forces.wallTorque; }
const Walls& GrainDynamics::walls() const { return self_->walls; }
double GrainDynamics::time() const { return self_->movingWalls.time(); }
void GrainDynamics::setTime(double time) { self_->movingWalls.setTime(time); }
const StepTimes& GrainDynamics::times() const { return self_->times; }

std::vector<LoadedContact> GrainDynamics::contacts() const
{
    const ContactList& list = self_->list;
    std::vector<LoadedContact> loaded;
    for (const SlotImpulse& entry : loadedSlots(list))
    {
        const ContactBlock& block = list.blocks[entry.slot/blockLanes];
        const int lane = entry.slot % blockLanes;
        const std::int64_t idB = entry.pair.b < 0 ? entry.pair.b : list.id[block.b[lane]];
        const Vec3 pull = list.cohesion.empty() ? Vec3(Vec3::Zero()) : Vec3(list.cohesion[entry.slot].attraction);
        const Vec3 moment = list.hasRolling ? rollingMoment(list, entry.slot) : Vec3(Vec3::Zero());
        loaded.push_back
        ({
            entry.pair.a, entry.pair.b, list.id[block.a[lane]], idB, normal(list, entry.slot), list.gap[entry.slot],
            entry.pair.impulse + pull, pull, moment
        });
    }
    return loaded;
}

std::vector<StoredImpulse> GrainDynamics::checkpoint(double& lastDeltaT)
{
    Implementation& self = *self_;
    lastDeltaT = self.impulseDeltaT;
    self.sleep.wakeAll();
    if (!self.isListStale) self.restored = collectImpulses(self.list);
    self.list = ContactList();
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
        if (stored.impulse.allFinite() && stored.rolling.allFinite()) continue;
        throw invalidValue("stored impulse of grain " + std::to_string(stored.idA), "not finite", "finite components [N s]");
    }
    self.restored = byIndex(impulses, self.grains);
    self.impulseDeltaT = lastDeltaT;
    self.sleep.wakeAll();
    self.list = ContactList();
    self.isListStale = true;
    self.isStepBegun = false;
}

} // namespace nscd
