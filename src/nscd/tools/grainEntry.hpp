// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that enter during a run: when, how large and where; those that find no room wait.
#pragma once

#include "nscd/tools/entryRoom.hpp"
#include "nscd/tools/sizeDistributions.hpp"

#include <limits>

namespace nscd
{

/// Grains that enter a region.
struct EntrySource
{
    std::string name;
    EntryRegion region;                     ///< of their centers
    SizeDistribution sizes;                 ///< of the bodies that enter: parcels where grains are coarse
    double coarseGraining = 1.0;            ///< diameter of a body over that of the real grains it stands for
    int material = 0;
    double density = 0.0;                   ///< [kg/m3]
    Vec3 velocity = Vec3::Zero();           ///< [m/s]
    bool takesFluidVelocity = false;        ///< whoever knows the fluid then gives grains their velocity once they have entered
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
/// try: neither from time steps nor from where a run was stopped, nor from ranks, all of which try the same. Grains enter in their order, so
/// that sizes in are sizes as asked.
class GrainEntry
{
public:
    /// One state for each source; identities of new grains go on from nextId. All the same on all ranks.
    GrainEntry(std::vector<EntrySource> sources, EntrySpace space, std::vector<EntryState> states, std::int64_t nextId);

    /// Before a step that ends at a time [s]: adds what is due by then and finds room, without overlap with grains and walls where they are.
    /// Returns the number of grains that entered, on all ranks; those of this one are behind the ones it had. Always for
    /// the same dynamics. Collective.
    std::int64_t enter(GrainDynamics& dynamics, double time);

    /// The source of each grain that entered last on this rank, in the order of the grains.
    const std::vector<std::size_t>& sourcesOfLast() const { return sourcesOfLast_; }

    const std::vector<EntrySource>& sources() const { return sources_; }
    const std::vector<EntryState>& states() const { return states_; }
    std::int64_t nextId() const { return nextId_; }

private:
    class PlacesAhead;

    /// Grains of all ranks that enter in a step, and which of them are this rank's.
    struct Entering
    {
        Grains all, own;
    };

    void addDue(std::size_t source, double time);
    bool isDue(std::size_t source, double amount) const;
    double diameterOf(std::size_t source, std::int64_t number) const;
    double massOf(std::size_t source, std::int64_t number) const;
    double largestDiameter() const;
    void enterFrom(std::size_t source, const GrainDynamics& dynamics, Entering& entering);
    bool enterNext(std::size_t source, PlacesAhead& places, Entering& entering);
    void add(std::size_t source, const Vec3& position, double radius, Grains& grains) const;

    std::vector<EntrySource> sources_;
    EntrySpace space_;
    std::vector<EntryState> states_;
    std::int64_t nextId_;
    std::vector<std::size_t> sourcesOfLast_;
    std::unique_ptr<RoomOfWalls> walls_;   ///< since the first grain was due
};

} // namespace nscd
