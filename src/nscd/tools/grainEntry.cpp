// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Letting grains in.
#include "nscd/tools/grainEntry.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace nscd
{

namespace
{

/// Places tried for the next grain of a source in a step, before it waits for the next step.
constexpr int triesPerStep = 100;

/// Of these, as many at a time where each look asks all ranks.
constexpr int triesPerLook = 20;

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

/// The next places that a source tries, in their order.
class GrainEntry::PlacesAhead
{
public:
    PlacesAhead(const EntrySource& from, std::size_t source, int perLook, RoomOfGrains& room)
    :
        from_(from),
        source_(source),
        perLook_(perLook),
        room_(room)
    {}

    const EntryPlace& at(std::int64_t number)
    {
        if (number < first_ || number - first_ >= static_cast<std::int64_t>(places_.size())) look(number);
        return places_[static_cast<std::size_t>(number - first_)];
    }

private:
    void look(std::int64_t number)
    {
        std::vector<EntryTry> tries;
        for (int k = 0; k < perLook_; ++k) tries.push_back(from_.region.draw(numbersFor(from_.seed, source_, placesTried, number + k)));
        first_ = number;
        places_ = room_.look(tries);
    }

    const EntrySource& from_;
    std::size_t source_;
    int perLook_;
    RoomOfGrains& room_;
    std::int64_t first_ = 0;
    std::vector<EntryPlace> places_;
};

namespace
{

bool isFreeOf(const Grains& others, const PeriodicBox& box, const Vec3& x, double radius)
{
    for (std::size_t i = 0; i < others.size(); ++i)
    {
        if (box.nearestImage(x - others.position[i]).norm() < radius + others.radius[i]) return false;
    }
    return true;
}

} // namespace

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

GrainEntry::GrainEntry(std::vector<EntrySource> sources, EntrySpace space, std::vector<EntryState> states, std::int64_t nextId)
:
    sources_(std::move(sources)),
    space_(std::move(space)),
    states_(std::move(states)),
    nextId_(nextId)
{}

double GrainEntry::diameterOf(std::size_t source, std::int64_t number) const
{
    return sources_[source].sizes.draw(numbersFor(sources_[source].seed, source, sizesOfGrains, number));
}

double GrainEntry::massOf(std::size_t source, std::int64_t number) const
{
    return sources_[source].density*space_.shape.volume(0.5*diameterOf(source, number));
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

void GrainEntry::add(std::size_t source, const Vec3& position, double radius, Grains& grains) const
{
    const EntrySource& from = sources_[source];
    grains.add(position, radius, from.density, from.material, nextId_);
    grains.velocity.back() = from.velocity;
    grains.omega.back() = from.omega;
}

bool GrainEntry::enterNext(std::size_t source, PlacesAhead& places, Entering& entering)
{
    EntryState& state = states_[source];
    const double radius = 0.5*diameterOf(source, state.entered);
    for (int k = 0; k < triesPerStep; ++k)
    {
        const EntryPlace& place = places.at(state.tried++);
        const Vec3& x = place.position;
        if (place.rank < 0 || place.clearance < radius) continue;
        if (!isFreeOf(entering.all, space_.box, x, radius) || !walls_->isFree(x, radius)) continue;
        add(source, x, radius, entering.all);
        if (place.rank == space_.exchange->rank())
        {
            add(source, x, radius, entering.own);
            sourcesOfLast_.push_back(source);
        }
        ++nextId_;
        ++state.entered;
        state.enteredMass += entering.all.mass.back();
        return true;
    }
    return false;
}

double GrainEntry::largestDiameter() const
{
    double largest = 0.0;
    for (const EntrySource& source : sources_) largest = std::max(largest, source.sizes.largest);
    return largest;
}

void GrainEntry::enterFrom(std::size_t source, const GrainDynamics& dynamics, Entering& entering)
{
    const EntrySource& from = sources_[source];
    if (!from.region.begin()) return;
    if (!walls_) walls_ = std::make_unique<RoomOfWalls>(dynamics.walls(), largestDiameter());
    RoomOfGrains room(dynamics.grains(), space_, from.region, 0.5*from.sizes.largest);
    PlacesAhead places(from, source, space_.exchange->isParallel() ? triesPerLook : 1, room);
    while (states_[source].waiting() > 0 && enterNext(source, places, entering)) {}
}

std::int64_t GrainEntry::enter(GrainDynamics& dynamics, double time)
{
    Entering entering;
    sourcesOfLast_.clear();
    entering.all.shape = entering.own.shape = space_.shape;
    for (std::size_t s = 0; s < sources_.size(); ++s)
    {
        addDue(s, time);
        if (states_[s].waiting() > 0) enterFrom(s, dynamics, entering);
    }
    if (entering.all.size() == 0) return 0;
    Grains grains = dynamics.grains();
    grains.append(entering.own);
    dynamics.setGrains(std::move(grains));
    return static_cast<std::int64_t>(entering.all.size());
}

} // namespace nscd
