// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cutting the part of a list that awake grains need, and putting it back.
#include "nscd/step/awakePart.hpp"

#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/generalCandidates.hpp"
#include "nscd/step/sweptPairs.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

/// Copies what a slot holds of geometry and impulses.
void copySlot(const ContactList& from, std::size_t source, ContactList& to, std::size_t target)
{
    const Vec3 n = normal(from, source);
    ContactBlock& block = to.blocks[target/blockLanes];
    for (int k = 0; k < 3; ++k) block.n[k][target % blockLanes] = n[k];
    setImpulse(to, target, impulse(from, source));
    to.gap[target] = from.gap[source];
    if (!to.laws.empty()) to.laws.copy(from.laws, source, target);
}

void add(std::vector<Vec3>& sum, const std::vector<Vec3>& more, double factor)
{
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor*more[k];
}

void add(ContactForces& sum, const ContactForces& more, double factor)
{
    add(sum.force, more.force, factor);
    add(sum.torque, more.torque, factor);
    add(sum.wall, more.wall, factor);
    add(sum.wallTorque, more.wallTorque, factor);
}

} // namespace

template<class Visit>
void AwakePart::forEachSlot(const ContactList& part, const Visit& visit) const
{
    for (std::size_t slot = 0; slot < part.slots(); ++slot)
    {
        if (part.isUsed(slot)) visit(slot, slotInWhole_[slot]);
    }
}

void AwakePart::hold(ContactList whole, ContactForceSum& sumForces, const Scene& scene, double deltaT)
{
    whole_ = std::move(whole);
    forces_ = sumForces(whole_, {nullptr, whole_.blocks.size()}, scene, deltaT);
    bodyOf_.resize(whole_.owned());
    for (int body = 0; body < whole_.owned(); ++body) bodyOf_[whole_.grainOf[body]] = body;
    findSlotsOfBodies();
}

void AwakePart::findSlotsOfBodies()
{
    slotStart_.assign(whole_.owned() + 1, 0);
    const auto forEach = [&](const auto& visit)
    {
        for (std::size_t slot = 0; slot < whole_.slots(); ++slot)
        {
            if (!whole_.isUsed(slot)) continue;
            const ContactBlock& block = whole_.blocks[slot/blockLanes];
            for (int body : {block.a[slot % blockLanes], block.b[slot % blockLanes]})
            {
                if (body < whole_.owned()) visit(body, static_cast<std::uint32_t>(slot));
            }
        }
    };
    forEach([&](int body, std::uint32_t) { ++slotStart_[body + 1]; });
    std::partial_sum(slotStart_.begin(), slotStart_.end(), slotStart_.begin());
    slots_.resize(slotStart_.back());
    std::vector<std::uint32_t> next(slotStart_.begin(), slotStart_.end() - 1);
    forEach([&](int body, std::uint32_t slot) { slots_[next[body]++] = slot; });
}

void AwakePart::findAwake(const GrainSleep& sleep)
{
    isAwake_.assign(whole_.bodies.size(), 0);
    for (int body = 0; body < whole_.owned(); ++body) isAwake_[body] = !sleep.isAsleep(whole_.grainOf[body]);
    const bool isAnyAwake = std::find(isAwake_.begin(), isAwake_.end(), 1) != isAwake_.end();
    whole_.halo.giveFlags(isAwake_);
    isEmpty_ = !whole_.halo.any(isAnyAwake);
}

/// Also notes the bodies of the part. Body by body, walls first, so that the slots of a body with walls stand together.
std::vector<std::uint32_t> AwakePart::slotsOfAwake()
{
    bodies_.clear();
    std::vector<std::uint32_t> found;
    for (int body = 0; body < whole_.owned(); ++body)
    {
        if (!isAwake_[body]) continue;
        bodies_.push_back(body);
        for (const bool isWall : {true, false})
        for (std::uint32_t k = slotStart_[body]; k < slotStart_[body + 1]; ++k)
        {
            if ((whole_.wall[slots_[k]] >= 0) != isWall || isBetweenRanks(whole_, slots_[k])) continue;
            const int other = otherBody(slots_[k], body);
            if (!isWall && isAwake_[other] && other < body) continue;  // found there
            found.push_back(slots_[k]);
            if (!isWall) bodies_.push_back(other);
        }
    }
    addWholeClumps();
    return found;
}

std::vector<std::uint32_t> AwakePart::interfaceSlotsOfAwake() const
{
    std::vector<std::uint32_t> found;
    for (std::size_t slot = whole_.interfaceBlock*blockLanes; slot < whole_.slots(); ++slot)
    {
        const ContactBlock& block = whole_.blocks[slot/blockLanes];
        const bool isAnyAwake = isAwake_[block.a[slot % blockLanes]] || isAwake_[block.b[slot % blockLanes]];
        if (whole_.isUsed(slot) && isAnyAwake && isBetweenRanks(whole_, slot)) found.push_back(static_cast<std::uint32_t>(slot));
    }
    return found;
}

void AwakePart::packSlots(ContactList& part, const Scene& scene, double diameter)
{
    const std::vector<std::uint32_t> inner = slotsOfAwake(), interface = interfaceSlotsOfAwake();
    if (whole_.halo.isParallel())
    {
        bodies_.resize(whole_.firstWallBody());
        std::iota(bodies_.begin(), bodies_.end(), 0);
    }
    addBodies(part);
    addGeneral(part);
    const auto inPart = [&](int body) { return static_cast<int>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin()); };
    const auto candidate = [&](std::uint32_t slot)
    {
        const ContactBlock& block = whole_.blocks[slot/blockLanes];
        const int wall = whole_.wall[slot], b = wall >= 0 ? -1 : inPart(block.b[slot % blockLanes]);
        return Candidate{inPart(block.a[slot % blockLanes]), b, wall, whole_.image[slot]};
    };
    Candidates candidates;
    for (std::uint32_t slot : inner) candidates.inner.push_back(candidate(slot));
    for (std::uint32_t slot : interface) candidates.interface.push_back(candidate(slot));
    const CandidateSlots slots = packCandidates(part, scene, candidates, diameter);
    slotInWhole_.assign(part.slots(), 0);
    for (std::size_t k = 0; k < inner.size(); ++k) slotInWhole_[slots.inner[k]] = inner[k];
    for (std::size_t k = 0; k < interface.size(); ++k) slotInWhole_[slots.interface[k]] = interface[k];
}

ContactList AwakePart::cut(ContactForceSum& sumForces, const Scene& scene, const GrainSleep& sleep, double diameter, double deltaT)
{
    ContactList part;
    part.laws = ListLaws(scene.materials);
    part.pathTime = whole_.pathTime;
    part.age = whole_.age;
    part.halo = whole_.halo;
    part.ghosts = whole_.ghosts;
    findAwake(sleep);
    packSlots(part, scene, diameter);
    forEachSlot(part, [&](std::size_t slot, std::size_t inWhole) { copySlot(whole_, inWhole, part, slot); });
    for (std::size_t body = 0; body < bodies_.size(); ++body) part.bodies[body] = whole_.bodies[bodies_[body]];
    findFastPairs(part);

    outside_ = {{}, {}, forces_.wall, forces_.wallTorque};
    for (int body = 0; body < part.owned(); ++body)
    {
        outside_.force.push_back(forces_.force[bodies_[body]]);
        outside_.torque.push_back(forces_.torque[bodies_[body]]);
    }
    add(outside_, sumForces(part, {nullptr, part.blocks.size()}, scene, deltaT), -1.0);
    for (int body = 0; body < part.owned(); ++body)
    {
        if (!isAwake_[bodies_[body]]) continue;
        outside_.force[body].setZero();  // what is left is round-off: all contacts of an awake grain are in the part
        outside_.torque[body].setZero();
    }
    part.laws.beginStep(part);
    return part;
}

std::vector<AwakePart::Impulse> AwakePart::impulses(const ContactList& part) const
{
    std::vector<Impulse> found;
    forEachSlot(part, [&](std::size_t slot, std::uint32_t inWhole)
    {
        found.push_back({inWhole, impulse(part, slot), part.laws.impulses(slot)});
    });
    return found;
}

void AwakePart::setImpulses(const std::vector<Impulse>& impulses, bool isPart, ContactList& list) const
{
    std::vector<std::uint32_t> place(isPart ? whole_.slots() : 0);
    if (isPart) forEachSlot(list, [&](std::size_t slot, std::uint32_t inWhole) { place[inWhole] = static_cast<std::uint32_t>(slot); });
    for (const Impulse& entry : impulses)
    {
        const std::size_t slot = isPart ? place[entry.slot] : entry.slot;
        setImpulse(list, slot, entry.r);
        list.laws.setImpulses(slot, entry.ofLaws);
    }
}

void AwakePart::giveBack(const ContactList& part, const ContactForces& onBodies)
{
    forEachSlot(part, [&](std::size_t slot, std::size_t inWhole) { copySlot(part, slot, whole_, inWhole); });
    whole_.age = part.age;
    for (std::size_t body = 0; body < bodies_.size(); ++body)
    {
        whole_.position[bodies_[body]] = part.position[body];
        whole_.bodies[bodies_[body]] = part.bodies[body];
    }
    const std::vector<int> own(bodies_.begin(), bodies_.begin() + part.owned());
    giveToGrains(onBodies, own, forces_);
}

const ContactForces& AwakePart::forcesOn(const ContactList& part, BlockRange loaded, ContactForceSum& sumForces, const Scene& scene, double deltaT) const
{
    ContactForces& sum = sumForces(part, loaded, scene, deltaT);
    add(sum, outside_, 1.0);
    return sum;
}

} // namespace nscd
