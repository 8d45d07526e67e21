// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that enter during a run: when, how large and where; those that find no room wait.
#pragma once

#include "nscd/search/wallSearch.hpp"
#include "nscd/tools/regions.hpp"
#include "nscd/tools/sizeDistributions.hpp"

#include <limits>

namespace nscd
{

/// Grains that enter a region.
struct EntrySource
{
    std::string name;
    Region region;                          ///< of their centers
    SizeDistribution sizes;
    int material = 0;
    double density = 0.0;                   ///< [kg/m3]
    Vec3 velocity = Vec3::Zero();           ///< [m/s]
    Vec3 omega = Vec3::Zero();              ///< [rad/s]
    ScalarOfTime amount;                    ///< due from the beginning of the run to a time: a number, or a mass [kg]
    bool isMass = false;                    ///< what `amount` is
    std::int64_t number = std::numeric_limits<std::int64_t>::max();   ///< of grains, at most
    std::uint64_t seed = 1;
};

/// What a source has done; all that a restart needs of it.
struct EntryState
{
    std::int64_t due = 0;        ///< grains that were to enter
    std::int64_t entered = 0;
    std::int64_t tried = 0;      ///< places that were looked at
    double dueMass = 0.0;        ///< [kg]
    double enteredMass = 0.0;    ///< [kg]

    std::int64_t waiting() const { return due - entered; }
    double waitingMass() const { return waiting() > 0 ? dueMass - enteredMass : 0.0; }
};

/// Sums over the sources.
EntryState totalOf(const std::vector<EntryState>& states);

/// Lets grains in. A grain's size follows from seed, source and its number, a place that is tried from seed, source and the number of the
/// try: neither from time steps nor from where a run was stopped. Grains enter in their order, so that sizes in are sizes as asked.
class GrainEntry
{
public:
    /// One state for each source; identities of new grains go on from nextId.
    GrainEntry(std::vector<EntrySource> sources, const GrainShape& shape, const PeriodicBox& box, std::vector<EntryState> states, std::int64_t nextId);

    /// Before a step that ends at a time [s]: adds what is due by then and finds room, without overlap with grains and walls where they are.
    /// Returns whether any grain entered. With all of them on one rank.
    bool enter(GrainDynamics& dynamics, double time);

    const std::vector<EntrySource>& sources() const { return sources_; }
    const std::vector<EntryState>& states() const { return states_; }
    std::int64_t nextId() const { return nextId_; }

private:
    void addDue(std::size_t source, double time);
    bool isDue(std::size_t source, double amount) const;
    double diameterOf(std::size_t source, std::int64_t number) const;
    double massOf(std::size_t source, std::int64_t number) const;
    class Room;
    bool enterNext(std::size_t source, Room& room, Grains& entering);

    std::vector<EntrySource> sources_;
    GrainShape shape_;
    PeriodicBox box_;
    std::vector<EntryState> states_;
    std::int64_t nextId_;
};

} // namespace nscd
