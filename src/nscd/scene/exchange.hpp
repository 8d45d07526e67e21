// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The seam between the grain library and other ranks: everything it asks of them, and the answers of a serial run.
// Tested by tests/unit/nscd/kernels/haloTest.cpp, tests/parallel/mpiExchangeTest.cpp
#pragma once

#include "nscd/base/periodicBox.hpp"
#include "nscd/scene/grains.hpp"

#include <vector>

namespace nscd
{

/// Where grains may be until lists are stale.
struct GrainPaths
{
    std::vector<double> slack;         ///< of each, how far from where its path expects it [m]
    std::vector<Vec3> path{};          ///< displacement expected of each; empty: none [m]
    Vec3 meanPath = Vec3::Zero();      ///< about what the grains of all ranks have; the same on all [m]
    double range = 0.0;                ///< of laws that act across gaps, of each [m]
};

/// A grain of another rank that could touch one of this rank.
struct GhostGrain
{
    Vec3 position;         ///< in the periodic box [m]
    Vec3 path;             ///< displacement expected of it before lists are stale [m]
    double radius;         ///< [m]
    double slack;          ///< how far it may be from where its path expects it [m]
    double inverseMass;    ///< 0 where held [1/kg]
    std::int64_t id;
    int material;
    int owner;             ///< rank that owns it
    int index;             ///< in the owner's grains
    int clump = -1;        ///< in the owner's clumps, -1: a single grain
};

/// An impulse that the grain `index` of rank `rank` gets from grain `id`.
struct ImpulseForOwner
{
    int rank;
    int index;
    std::int64_t id;
    Vec3 impulse;  ///< [N s]
};

/// What the grain library needs from other ranks. One object per GrainDynamics, or other user of connect(); the base class is a serial run.
/// All functions are collective: every rank calls them in the same order.
class Exchange
{
public:
    virtual ~Exchange() = default;

    virtual int rank() const { return 0; }
    virtual bool isParallel() const { return false; }

    /// Replaces `count` values by their sums or maxima over all ranks; the same bits on every rank.
    virtual void sum(double* /*values*/, int /*count*/) const {}
    virtual void max(double* /*values*/, int /*count*/) const {}
    /// Whether it is so on any rank.
    bool any(bool isHere) const
    {
        double value = isHere ? 1.0 : 0.0;
        max(&value, 1);
        return value > 0.0;
    }
    /// Two sums and a maximum in one go.
    virtual void sumAndMax(double (&/*sums*/)[2], double& /*max*/) const {}

    /// Grains of other ranks that may come within radii, slacks and ranges of one of this rank's on their paths, in a periodic image perhaps:
    /// all that do, and others nearby. In an order that is the same from run to run.
    virtual std::vector<GhostGrain> findGhosts(const Grains& /*owned*/, const GrainPaths&, const PeriodicBox&)
    {
        return {};
    }

    /// Whether a sphere around a place in the box lies within what the paths of this rank's grains cover, and off those of other ranks' grains, as
    /// findGhosts() saw them last. Two such spheres of two ranks do not meet. Not collective.
    virtual bool isAwayFromOthers(const Vec3& /*center*/, double /*size*/) const { return true; }

    /// Sets up toGhosts() and toOwners() for `ghosts`, in this order. Returns this rank's own grains that others hold as ghosts,
    /// one entry for each rank that does, in the order of their values in toGhosts().
    virtual std::vector<int> connect(const std::vector<GhostGrain>& /*ghosts*/) { return {}; }

    /// Copies `width` numbers from each entry of the list that connect() returned to the ghosts it has elsewhere.
    virtual void toGhosts(const std::vector<double>& /*shared*/, std::vector<double>& /*ghosts*/, int /*width*/) const {}

    /// Brings `width` numbers of each ghost back to the entries it stands for.
    virtual void toOwners(const std::vector<double>& /*ghosts*/, std::vector<double>& /*shared*/, int /*width*/) const {}

    /// Hands each entry to its rank; returns those for this rank, by sender and in the order they were given.
    virtual std::vector<ImpulseForOwner> deliver(const std::vector<ImpulseForOwner>& entries) const { return entries; }
};

} // namespace nscd
