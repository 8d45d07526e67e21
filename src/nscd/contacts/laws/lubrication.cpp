// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which contacts have a film, and what it adds to velocities and forces.
#include "nscd/contacts/laws/lubrication.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/laws/filmSweep.hpp"
#include "nscd/kernels/applyImpulse.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nscd
{

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Of A from B along the normal [m/s].
double partingSpeed(const ContactList& list, std::size_t slot)
{
    const ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    return normal(list, slot).dot(Vec3(list.bodies[block.a[lane]].v) - Vec3(list.bodies[block.b[lane]].v));
}

void wake(std::vector<std::uint32_t>& awake, const std::vector<std::uint32_t>& more)
{
    std::vector<std::uint32_t> all;
    std::set_union(awake.begin(), awake.end(), more.begin(), more.end(), std::back_inserter(all));
    awake = std::move(all);
}

} // namespace

void Lubrication::resize(std::size_t slots)
{
    films_.resize(slots);
    blocks_.resize((slots + blockLanes - 1)/blockLanes, LawBlock());
}

void Lubrication::set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB)
{
    const double reduced = radiusB > 0.0 ? radiusA*radiusB/(radiusA + radiusB) : radiusA;
    const double strength = pair.roughness > 0.0 ? 6.0*pi*pair.lubricationViscosity*reduced*reduced : 0.0;
    films_[slot] = {strength, pair.roughness, pair.lubricationRange, Vec3::Zero()};
}

void Lubrication::copy(const ContactLaw& from, std::size_t source, std::size_t target)
{
    const Lubrication& other = static_cast<const Lubrication&>(from);
    films_[target] = other.films_[source];
    copyLane(other.blocks_[source/blockLanes], source % blockLanes, blocks_[target/blockLanes], target % blockLanes);
}

bool Lubrication::prepare(ContactList& list, std::size_t slot, double deltaT)
{
    const Film& film = films_[slot];
    LawBlock& block = blocks_[slot/blockLanes];
    const int lane = slot % blockLanes;
    for (double (&q)[blockLanes] : block.q) q[lane] = 0.0;
    for (double (&coefficient)[blockLanes] : block.of) coefficient[lane] = 0.0;
    if (!(film.strength > 0.0) || !list.isUsed(slot)) return false;
    const double gap = list.gap[slot];
    double& bias = list.blocks[slot/blockLanes].bias[lane];
    const bool isNear = gap <= film.range || gap + deltaT*partingSpeed(list, slot) <= film.range;
    if (!isNear || !(bias < unreachable)) return false;
    bias = std::max(0.0, gap)/deltaT;   // a dead band may be wider than the film that is left
    const double thickness = std::max(0.0, gap) + film.roughness, edge = film.range + film.roughness;
    block.of[filmLaw::strength][lane] = film.strength;
    block.of[filmLaw::thickness][lane] = thickness/deltaT;
    block.of[filmLaw::edge][lane] = edge/deltaT;
    block.of[filmLaw::untilClosed][lane] = film.strength*std::log(std::min(thickness, edge)/film.roughness);
    return true;
}

void Lubrication::giveKnown(ContactList& list, double deltaT, double)
{
    std::vector<std::uint32_t> filmed;
    for (std::size_t slot = 0; slot < films_.size(); ++slot)
    {
        const std::uint32_t block = static_cast<std::uint32_t>(slot/blockLanes);
        if (prepare(list, slot, deltaT) && (filmed.empty() || filmed.back() != block)) filmed.push_back(block);
    }
    wake(list.awake, filmed);
}

void Lubrication::chooseKernels(SweepKernels& kernels) const
{
    kernels.sweepLaw = sweepFilms;
    kernels.sweepLawOn = sweepFilmsOn;
    kernels.evaluateLaw = evaluateFilms;
}

void Lubrication::endSolve()
{
    for (std::size_t slot = 0; slot < films_.size(); ++slot)
    {
        const LawBlock& block = blocks_[slot/blockLanes];
        for (int k = 0; k < 3; ++k) films_[slot].given[k] = block.q[k][slot % blockLanes];
    }
}

void Lubrication::beginShock(ContactList& list)
{
    for (std::size_t slot = 0; slot < films_.size(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int lane = slot % blockLanes;
        applyImpulse(list.bodies[block.a[lane]], list.bodies[block.b[lane]], normal(list, slot).data(), films_[slot].given.data());
    }
    std::fill(blocks_.begin(), blocks_.end(), LawBlock());
    list.halo.takeVelocities(list.bodies);
    list.halo.giveVelocities(list.bodies);
}

} // namespace nscd
