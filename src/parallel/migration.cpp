// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packing of grains for their new owners.
#include "parallel/migration.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_map>

namespace nscd
{

namespace
{

using Plain3 = std::array<double, 3>;
using Plain4 = std::array<double, 4>;

template<class Value>
constexpr std::size_t sizeOfEntry(std::vector<Value> Grains::*)
{
    return sizeof(Value);
}

constexpr std::size_t grainBytes()
{
    std::size_t sum = 0;
    Grains::forEachMember([&sum](const char*, auto array) { sum += sizeOfEntry(array); });
    return sum;
}

/// The entries of one grain in all arrays, byte by byte one behind the other.
using GrainRecord = std::array<char, grainBytes()>;

Plain3 plain(const Vec3& v) { return {v[0], v[1], v[2]}; }
Plain4 plain(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Vec3 vectorOf(const Plain3& p) { return Vec3(p.data()); }
Quaternion quaternionOf(const Plain4& p) { return Quaternion(p[0], p[1], p[2], p[3]); }

/// Values of an Eigen type, which travel as plain numbers.
template<class Value, class Back>
std::vector<Value> movedAsPlain(const Migration& migration, const std::vector<Value>& values, const Back& back)
{
    std::vector<decltype(plain(values.front()))> sent;
    for (const Value& value : values) sent.push_back(plain(value));
    std::vector<Value> received;
    for (const auto& value : migration.move(sent)) received.push_back(back(value));
    return received;
}

/// StoredImpulse as plain numbers.
struct ImpulseRecord
{
    std::int64_t idA, idB;
    Plain3 impulse;
    std::array<Plain3, lawImpulses> ofLaws;
};

GrainRecord recordOf(const Grains& grains, std::size_t i)
{
    GrainRecord record;
    char* to = record.data();
    Grains::forEachMember([&](const char*, auto array)
    {
        std::memcpy(to, &(grains.*array)[i], sizeOfEntry(array));
        to += sizeOfEntry(array);
    });
    return record;
}

void write(const GrainRecord& record, Grains& grains, std::size_t i)
{
    const char* from = record.data();
    Grains::forEachMember([&](const char*, auto array)
    {
        std::memcpy(static_cast<void*>(&(grains.*array)[i]), from, sizeOfEntry(array));
        from += sizeOfEntry(array);
    });
}

/// A clump on its way, without Eigen's types.
struct ClumpOnWay
{
    std::int64_t firstId;
    Plain3 position, velocity, angularMomentum;
    Plain4 orientation;
    int shape;
    int padding = 0;
};

ClumpOnWay onWay(const Grains& grains, std::size_t c)
{
    const Clumps& clumps = grains.clumps;
    return
    {
        grains.id[clumps.firstMember[c]], plain(clumps.position[c]), plain(clumps.velocity[c]), plain(clumps.angularMomentum[c]),
        plain(clumps.orientation[c]), clumps.shape[c]
    };
}

void addClump(const ClumpOnWay& clump, int firstMember, Clumps& clumps)
{
    clumps.shape.push_back(clump.shape);
    clumps.firstMember.push_back(firstMember);
    clumps.position.push_back(vectorOf(clump.position));
    clumps.orientation.push_back(quaternionOf(clump.orientation));
    clumps.velocity.push_back(vectorOf(clump.velocity));
    clumps.angularMomentum.push_back(vectorOf(clump.angularMomentum));
}

/// That of all of its members.
int destinationOf(const Grains& grains, std::size_t c, const std::vector<int>& destination)
{
    const auto first = destination.begin() + grains.clumps.firstMember[c];
    const auto isElsewhere = [first](int rank) { return rank != *first; };
    const bool isTorn = std::any_of(first, first + static_cast<std::ptrdiff_t>(grains.clumps.shapeOf(c).members.size()), isElsewhere);
    if (isTorn) throw invalidValue("destination of the members of clump " + std::to_string(c), "different ranks", "one rank");
    return *first;
}

} // namespace

Migration::Migration(const Communicator& all, std::vector<int> destination)
:
    all_(all),
    destination_(std::move(destination))
{
    for (int rank : destination_)
    {
        if (rank < 0 || rank >= all_.size()) throw invalidValue("destination", rank, "0 to " + std::to_string(all_.size() - 1));
    }
}

void Migration::checkNumber(std::size_t number) const
{
    if (number != destination_.size()) throw invalidValue("number of values to move", number, std::to_string(destination_.size()));
}

std::vector<Vec3> Migration::move(const std::vector<Vec3>& values) const { return movedAsPlain(*this, values, vectorOf); }

std::vector<Quaternion> Migration::move(const std::vector<Quaternion>& values) const
{
    return movedAsPlain(*this, values, quaternionOf);
}

Grains Migration::moveGrains(const Grains& grains) const
{
    std::vector<GrainRecord> records;
    records.reserve(grains.nOwned);
    for (std::size_t i = 0; i < grains.nOwned; ++i) records.push_back(recordOf(grains, i));
    records = move(records);
    Grains received;
    received.shape = grains.shape;
    received.forEachArray([&](auto& values) { values.resize(records.size()); });
    received.nOwned = received.size();
    for (std::size_t i = 0; i < records.size(); ++i) write(records[i], received, i);
    received.clumps.shapes = grains.clumps.shapes;
    if (!grains.clumps.shapes.empty()) moveClumps(grains, received);
    return received;
}

void Migration::moveClumps(const Grains& grains, Grains& received) const
{
    std::vector<ClumpOnWay> sent;
    std::vector<int> to;
    for (std::size_t c = 0; c < grains.clumps.size(); ++c)
    {
        sent.push_back(onWay(grains, c));
        to.push_back(destinationOf(grains, c, destination_));
    }
    std::unordered_map<std::int64_t, int> indexOf;
    for (std::size_t i = 0; i < received.size(); ++i) indexOf.emplace(received.id[i], static_cast<int>(i));
    for (const ClumpOnWay& clump : valuesOf<ClumpOnWay>(all_.exchange(messagesByRank(sent, to)))) addClump(clump, indexOf.at(clump.firstId), received.clumps);
}

std::vector<StoredImpulse> moveImpulses
(
    const Communicator& all, const std::vector<StoredImpulse>& impulses, const std::vector<int>& destination
)
{
    std::vector<ImpulseRecord> sent;
    sent.reserve(impulses.size());
    for (const StoredImpulse& entry : impulses)
    {
        sent.push_back({entry.idA, entry.idB, plain(entry.impulse), {}});
        for (std::size_t m = 0; m < lawImpulses; ++m) sent.back().ofLaws[m] = plain(entry.ofLaws[m]);
    }
    std::vector<StoredImpulse> received;
    for (const ImpulseRecord& entry : valuesOf<ImpulseRecord>(all.exchange(messagesByRank(sent, destination))))
    {
        received.push_back({entry.idA, entry.idB, vectorOf(entry.impulse)});
        for (std::size_t m = 0; m < lawImpulses; ++m) received.back().ofLaws[m] = vectorOf(entry.ofLaws[m]);
    }
    return received;
}

} // namespace nscd
