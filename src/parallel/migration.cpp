// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packing of grains for their new owners.
#include "parallel/migration.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <array>

namespace nscd
{

namespace
{

using Plain3 = std::array<double, 3>;
using Plain4 = std::array<double, 4>;

/// All properties of a grain; its Eigen types as plain numbers.
struct GrainRecord
{
    Plain3 position, velocity, omega;
    Plain4 orientation;
    double radius, mass;
    std::int64_t id;
    std::int32_t material, isFixed;
};

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

GrainRecord recordOf(const Grains& g, std::size_t i)
{
    return
    {
        plain(g.position[i]), plain(g.velocity[i]), plain(g.omega[i]), plain(g.orientation[i]), g.radius[i], g.mass[i], g.id[i],
        g.material[i], g.isFixed[i]
    };
}

void append(const GrainRecord& record, Grains& grains)
{
    grains.position.push_back(vectorOf(record.position));
    grains.velocity.push_back(vectorOf(record.velocity));
    grains.omega.push_back(vectorOf(record.omega));
    grains.orientation.push_back(quaternionOf(record.orientation));
    grains.radius.push_back(record.radius);
    grains.mass.push_back(record.mass);
    grains.material.push_back(record.material);
    grains.id.push_back(record.id);
    grains.isFixed.push_back(static_cast<std::uint8_t>(record.isFixed));
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
    received.reserve(records.size());
    for (const GrainRecord& record : records) append(record, received);
    received.nOwned = received.size();
    return received;
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
