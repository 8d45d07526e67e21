// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Falling asleep by speed and force, waking by force.
#include "nscd/step/grainSleep.hpp"

#include "nscd/step/contactStep.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

Vec3 entry(const std::vector<Vec3>& values, std::size_t i) { return values.empty() ? Vec3(Vec3::Zero()) : values[i]; }

bool isDriven(const Grains& grains, int i) { return grains.isFixed[i] && (grains.velocity[i] != Vec3::Zero() || grains.omega[i] != Vec3::Zero()); }

/// Whether neither of two changes [N, N m] could give a grain more than `speed` in a step. False for what is not a number.
bool isSmall(const Grains& grains, std::size_t i, const Vec3& force, const Vec3& torque, double speed, double deltaT)
{
    const double limit = speed*grains.mass[i]/deltaT, moment = limit*grains.radius[i];
    return force.squaredNorm() <= limit*limit && torque.squaredNorm() <= moment*moment;
}

/// Whether a grain is slower than a speed, its surface too.
bool isSlow(const Grains& grains, int i, double speed)
{
    const double spin2 = grains.radius[i]*grains.radius[i]*grains.omega[i].squaredNorm();
    return grains.velocity[i].squaredNorm() <= speed*speed && spin2 <= speed*speed;
}

/// A flag of any member becomes one of all members of its clump.
void giveToClumps(const ContactList& list, std::vector<std::uint8_t>& isFlagged)
{
    std::vector<std::uint8_t> ofClumps(list.general.own(), 0);
    for (std::size_t k = 0; k < list.general.ownMembers; ++k)
    {
        const GeneralMember& member = list.general.members[k];
        ofClumps[member.owner] |= isFlagged[member.body];
    }
    for (std::size_t k = 0; k < list.general.ownMembers; ++k) isFlagged[list.general.members[k].body] = ofClumps[list.general.members[k].owner];
}

bool isMoving(const Body& body) { return Vec3(body.v) != Vec3::Zero() || Vec3(body.s) != Vec3::Zero(); }

} // namespace

std::vector<int> GrainSleep::disturbedBy(const Grains& grains, const ExternalForces& external, double deltaT) const
{
    std::vector<int> disturbed;
    for (std::size_t i = 0; i < isAsleep_.size(); ++i)
    {
        if (!isAsleep_[i] || grains.isFixed[i] || isMember(i)) continue;
        const Vec3 force = entry(external.force, i) - force_[i], torque = entry(external.torque, i) - torque_[i];
        if (!isSmall(grains, i, force, torque, restLimit*speedScale_, deltaT)) disturbed.push_back(static_cast<int>(i));
    }
    const Clumps& clumps = grains.clumps;
    for (std::size_t c = 0; c < clumps.size() && any(); ++c)
    {
        const int first = clumps.firstMember[c], end = first + static_cast<int>(clumps.shapeOf(c).members.size());
        if (!isAsleep_[first]) continue;
        ClumpLoad change;   // callers' forces act at the mass center
        for (int i = first; i < end; ++i) change.add(entry(external.force, i) - force_[i], entry(external.torque, i) - torque_[i], Vec3::Zero());
        if (!isSmall(grains, static_cast<int>(c), change, restLimit*speedScale_, deltaT)) disturbed.push_back(first);
    }
    return disturbed;
}

/// Of the own clumps of a list, what contacts do to them now against what was noted; forces and torques by body, or by grain.
std::vector<ClumpLoad> GrainSleep::changes(const ContactList& list, const std::vector<Vec3>& force, const std::vector<Vec3>& torque, bool areOfBodies) const
{
    std::vector<ClumpLoad> changes(list.general.own());
    for (std::size_t k = 0; k < list.general.ownMembers; ++k)
    {
        const GeneralMember& member = list.general.members[k];
        const int i = list.grainOf[member.body], at = areOfBodies ? member.body : i;
        changes[member.owner].add(force[at] - contactForce_[i], torque[at] - contactTorque_[i], member.arm);
    }
    return changes;
}

std::vector<int> GrainSleep::disturbedBy(const Grains& grains, const ContactList& list, const ContactForces& onBodies, double deltaT) const
{
    std::vector<int> disturbed;
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        if (!isAsleep_[i] || grains.isFixed[i] || isMember(i)) continue;
        const Vec3 force = onBodies.force[body] - contactForce_[i], torque = onBodies.torque[body] - contactTorque_[i];
        if (!isSmall(grains, i, force, torque, restLimit*speedScale_, deltaT)) disturbed.push_back(i);
    }
    const std::vector<ClumpLoad> ofClumps = changes(list, onBodies.force, onBodies.torque, true);
    for (std::size_t k = 0; k < ofClumps.size(); ++k)
    {
        const int clump = list.general.clumpOf[k], first = grains.clumps.firstMember[clump];
        if (isAsleep_[first] && !isSmall(grains, clump, ofClumps[k], restLimit*speedScale_, deltaT)) disturbed.push_back(first);
    }
    return disturbed;
}

std::vector<int> GrainSleep::pressed(const Grains& grains, const ContactList& list, double tolerance) const
{
    std::vector<std::uint8_t> isPressed(list.bodies.size(), 0);
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot) || list.gap[slot] >= -tolerance) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        isPressed[block.a[slot % blockLanes]] = isPressed[block.b[slot % blockLanes]] = 1;
    }
    list.halo.takeFlags(isPressed);
    std::vector<int> pressed;
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        if (isPressed[body] && isAsleep(i) && !grains.isFixed[i]) pressed.push_back(i);
    }
    return pressed;
}

void GrainSleep::wakeOne(int grain)
{
    if (!isAsleep_[grain]) return;
    isAsleep_[grain] = 0;
    quietSteps_[grain] = 0;
    --asleepHere_;
}

void GrainSleep::wake(const std::vector<int>& sleepers, const Halo& halo)
{
    const int n = static_cast<int>(isAsleep_.size());
    for (int i : sleepers)
    {
        wakeOne(i);
        if (!isMember(i)) continue;
        for (int k = i - 1; k >= 0 && clumpOf_[k] == clumpOf_[i]; --k) wakeOne(k);
        for (int k = i + 1; k < n && clumpOf_[k] == clumpOf_[i]; ++k) wakeOne(k);
    }
    asleep_ = halo.sum(static_cast<double>(asleepHere_));
}

/// A grain in a flow may be slow for a while; what presses on it is not steady then.
void GrainSleep::countQuietSteps(const RestingStep& step, const Grains& grains)
{
    const double speed = restLimit*step.speedScale;
    for (int i : step.list.grainOf)
    {
        if (isMember(i)) continue;
        const double force = speed*grains.mass[i]/step.deltaT;
        const bool isQuiet = isSlow(grains, i, speed) && (step.contact.force[i] - contactForce_[i]).squaredNorm() <= force*force;
        quietSteps_[i] = isQuiet ? quietSteps_[i] + 1 : 0;
    }
}

void GrainSleep::countQuietClumps(const RestingStep& step, const Grains& grains)
{
    const double speed = restLimit*step.speedScale;
    const std::vector<ClumpLoad> ofClumps = changes(step.list, step.contact.force, step.contact.torque, false);
    for (std::size_t k = 0; k < ofClumps.size(); ++k)
    {
        const int clump = step.list.general.clumpOf[k], first = grains.clumps.firstMember[clump];
        const int end = first + static_cast<int>(grains.clumps.shapeOf(clump).members.size());
        bool isQuiet = isSmall(grains, clump, ofClumps[k], speed, step.deltaT);
        for (int i = first; i < end && isQuiet; ++i) isQuiet = isSlow(grains, i, speed);
        for (int i = first; i < end; ++i) quietSteps_[i] = isQuiet ? quietSteps_[i] + 1 : 0;
    }
}

/// Bodies of the list that are awake and have to stay so.
std::vector<std::uint8_t> GrainSleep::restlessBodies(const RestingStep& step, const Grains& grains) const
{
    const ContactList& list = step.list;
    std::vector<std::uint8_t> fails(list.bodies.size(), 0);
    for (int body = 0; body < list.owned(); ++body)
    {
        const int i = list.grainOf[body];
        if (grains.isFixed[i]) fails[body] = isDriven(grains, i);
        else fails[body] = !isAsleep_[i] && quietSteps_[i] < stepsToSleep;
    }
    list.halo.giveFlags(fails);
    for (std::size_t body = list.firstWallBody(); body < list.bodies.size(); ++body) fails[body] = isMoving(list.bodies[body]);

    std::vector<std::uint8_t> isRestless = fails;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const bool isClosed = list.isUsed(slot) && (list.gap[slot] <= step.deadBand || impulse(list, slot) != Vec3::Zero());
        if (!isClosed) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        if (fails[a]) isRestless[b] = 1;
        if (fails[b]) isRestless[a] = 1;
    }
    list.halo.takeFlags(isRestless);
    if (!list.general.empty()) giveToClumps(list, isRestless);
    return isRestless;
}

void GrainSleep::makeRoom(const Grains& grains)
{
    const std::size_t n = grains.size();
    if (quietSteps_.size() == n) return;
    quietSteps_.resize(n, 0);
    isAsleep_.resize(n, 0);
    for (std::vector<Vec3>* values : {&contactForce_, &contactTorque_, &force_, &torque_}) values->resize(n, Vec3::Zero());
    clumpOf_ = clumpOfGrains(grains);
}

void GrainSleep::note(const RestingStep& step, int grain)
{
    contactForce_[grain] = step.contact.force[grain];
    contactTorque_[grain] = step.contact.torque[grain];
    force_[grain] = entry(step.external.force, grain);
    torque_[grain] = entry(step.external.torque, grain);
}

bool GrainSleep::fallAsleep(const RestingStep& step, Grains& grains)
{
    makeRoom(grains);
    countQuietSteps(step, grains);
    if (!step.list.general.empty()) countQuietClumps(step, grains);
    if (++steps_ % stepsToSleep != 0) return false;

    const std::vector<std::uint8_t> isRestless = restlessBodies(step, grains);
    std::vector<int> fallers;
    for (int body = 0; body < step.list.owned(); ++body)
    {
        const int i = step.list.grainOf[body];
        if (isAsleep_[i]) continue;
        note(step, i);
        if (grains.isFixed[i]) isAsleep_[i] = !isRestless[body];
        else if (!isRestless[body]) fallers.push_back(i);
    }
    double sums[3] = {static_cast<double>(fallers.size()), static_cast<double>(asleepHere_ + fallers.size()), static_cast<double>(grains.size())};
    step.list.halo.sum(sums, 3);
    if (sums[0] == 0.0 || sums[1] < worthwhile*sums[2]) return false;
    speedScale_ = step.speedScale;
    asleepHere_ += fallers.size();
    asleep_ = sums[1];
    grains_ = sums[2];
    for (int i : fallers)
    {
        isAsleep_[i] = 1;
        grains.velocity[i].setZero();
        grains.omega[i].setZero();
        if (!isMember(i)) continue;
        grains.clumps.velocity[clumpOf_[i]].setZero();
        grains.clumps.angularMomentum[clumpOf_[i]].setZero();
    }
    return true;
}

} // namespace nscd
