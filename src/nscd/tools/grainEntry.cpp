// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Letting grains in.
#include "nscd/tools/grainEntry.hpp"

#include "nscd/search/pairSearch.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace nscd
{

namespace
{

/// Places tried for the next grain of a source in a step, before it waits for the next step.
constexpr int triesPerStep = 100;

/// Amounts that are whole but for round-off count as whole.
constexpr double roundOff = 1e-9;

enum Stream : std::uint32_t { sizesOfGrains, placesTried };

/// Independent numbers for each (seed, source, stream, index), the same on every machine.
RandomNumbers numbersFor(std::uint64_t seed, std::size_t source, Stream stream, std::int64_t index)
{
    const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
    const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); };
    const std::uint64_t at = static_cast<std::uint64_t>(index);
    std::seed_seq words{low(seed), high(seed), low(source), std::uint32_t(stream), low(at), high(at)};
    std::array<std::uint32_t, 2> mixed;
    words.generate(mixed.begin(), mixed.end());
    return randomNumbers((std::uint64_t(mixed[0]) << 32) | mixed[1]);
}

} // namespace

/// Where grains and walls are.
class GrainEntry::Room
{
public:
    Room(const Grains& grains, const Walls& walls, const PeriodicBox& box, double largestDiameter)
    :
        walls_(walls),
        box_(box),
        wallSearch_(walls, largestDiameter)
    {
        search_.fill(grains.position, grains.radius, box);
        for (std::size_t region = 0; region < walls.regions.size(); ++region)
        {
            if (walls.regions[region].edges.empty()) planes_.push_back(static_cast<int>(region));
        }
    }

    bool isFree(const Vec3& x, double radius, const Grains& entering)
    {
        return isFreeOfWalls(x, radius) && isFreeOf(entering, x, radius) && search_.around(x, radius, box_).empty();
    }

private:
    bool isFreeOf(const Grains& others, const Vec3& x, double radius) const
    {
        for (std::size_t i = 0; i < others.size(); ++i)
        {
            if (box_.nearestImage(x - others.position[i]).norm() < radius + others.radius[i]) return false;
        }
        return true;
    }

    /// Nothing enters behind a plane, which the search for walls that are near does not tell; a bounded wall has two sides.
    bool isFreeOfWalls(const Vec3& x, double radius)
    {
        const auto distance = [&](int region) { return nearestPoint(walls_, region, x).distance; };
        if (std::any_of(planes_.begin(), planes_.end(), [&](int region) { return distance(region) < radius; })) return false;
        near_.clear();
        wallSearch_.find(x, radius, near_);
        return std::none_of(near_.begin(), near_.end(), [&](int region) { return std::abs(distance(region)) < radius; });
    }

    const Walls& walls_;
    const PeriodicBox& box_;
    WallSearch wallSearch_;
    PairSearch search_;
    std::vector<int> planes_, near_;
};

EntryState totalOf(const std::vector<EntryState>& states)
{
    EntryState sum;
    for (const EntryState& state : states)
    {
        sum.due += state.due;
        sum.entered += state.entered;
        sum.tried += state.tried;
        sum.dueMass += state.dueMass;
        sum.enteredMass += state.enteredMass;
    }
    return sum;
}

GrainEntry::GrainEntry(std::vector<EntrySource> sources, const GrainShape& shape, const PeriodicBox& box, std::vector<EntryState> states, std::int64_t nextId)
:
    sources_(std::move(sources)),
    shape_(shape),
    box_(box),
    states_(std::move(states)),
    nextId_(nextId)
{}

double GrainEntry::diameterOf(std::size_t source, std::int64_t number) const
{
    return sources_[source].sizes.draw(numbersFor(sources_[source].seed, source, sizesOfGrains, number));
}

double GrainEntry::massOf(std::size_t source, std::int64_t number) const
{
    return sources_[source].density*shape_.volume(0.5*diameterOf(source, number));
}

/// Whether an amount reaches to one grain more.
bool GrainEntry::isDue(std::size_t source, double amount) const
{
    const EntryState& state = states_[source];
    if (state.due >= sources_[source].number) return false;
    const double needed = sources_[source].isMass ? state.dueMass + massOf(source, state.due) : state.due + 1.0;
    return amount*(1.0 + roundOff) >= needed;
}

void GrainEntry::addDue(std::size_t source, double time)
{
    EntryState& state = states_[source];
    const double amount = sources_[source].amount(time);
    while (isDue(source, amount))
    {
        state.dueMass += massOf(source, state.due);
        ++state.due;
    }
}

bool GrainEntry::enterNext(std::size_t source, Room& room, Grains& entering)
{
    const EntrySource& from = sources_[source];
    EntryState& state = states_[source];
    const double radius = 0.5*diameterOf(source, state.entered);
    for (int k = 0; k < triesPerStep; ++k)
    {
        const Vec3 x = box_.wrap(randomPoint(from.region, numbersFor(from.seed, source, placesTried, state.tried++)));
        if (!room.isFree(x, radius, entering)) continue;
        entering.add(x, radius, from.density, from.material, nextId_++);
        entering.velocity.back() = from.velocity;
        entering.omega.back() = from.omega;
        ++state.entered;
        state.enteredMass += entering.mass.back();
        return true;
    }
    return false;
}

bool GrainEntry::enter(GrainDynamics& dynamics, double time)
{
    double largest = 0.0;
    for (std::size_t s = 0; s < sources_.size(); ++s)
    {
        addDue(s, time);
        if (states_[s].waiting() > 0) largest = std::max(largest, sources_[s].sizes.largest);
    }
    if (largest == 0.0) return false;

    Room room(dynamics.grains(), dynamics.walls(), box_, largest);
    Grains entering;
    entering.shape = shape_;
    for (std::size_t s = 0; s < sources_.size(); ++s)
    {
        while (states_[s].waiting() > 0 && enterNext(s, room, entering)) {}
    }
    if (entering.size() == 0) return false;
    Grains grains = dynamics.grains();
    grains.append(entering);
    dynamics.setGrains(std::move(grains));
    return true;
}

} // namespace nscd
