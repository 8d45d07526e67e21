// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A dry scene run by all ranks together, and gathered on each of them for judgment.
#pragma once

#include "parallel/grainPartition.hpp"
#include "parallel/migration.hpp"
#include "parallel/mpiExchange.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace scenes
{

using OwnerOf = std::function<int(const Vec3& position, std::int64_t id)>;

/// How many take part.
inline int ranks()
{
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

/// All ranks' values, one rank behind the other.
inline std::vector<double> gather(const std::vector<double>& here)
{
    const int size = ranks(), count = static_cast<int>(here.size());
    std::vector<int> counts(size), starts(size, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    for (int k = 1; k < size; ++k) starts[k] = starts[k - 1] + counts[k - 1];
    std::vector<double> all(starts.back() + counts.back());
    MPI_Allgatherv(here.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, MPI_COMM_WORLD);
    return all;
}

inline void add(std::vector<double>& values, const Vec3& x) { values.insert(values.end(), x.data(), x.data() + 3); }

class RankedScene
{
public:
    RankedScene(const Scene& scene, const nscd::ContactSettings& settings, const OwnerOf& ownerOf)
    :
        exchange_(std::make_shared<nscd::MpiExchange>()),
        whole_(scene.grains),
        dynamics_(mine(scene.grains, ownerOf), scene.materials, scene.walls, scene.box, settings, exchange_)
    {}

    nscd::GrainDynamics& dynamics() { return dynamics_; }
    const nscd::MpiExchange& exchange() const { return *exchange_; }

    /// Moves grains and impulses to the ranks that recursive bisection by load names. Returns the grains that left this rank.
    int repartition()
    {
        const nscd::Grains& own = dynamics_.grains();
        const nscd::Communicator& all = exchange_->tree().all();
        const std::vector<int> destination = nscd::partitionGrains(exchange_->tree(), nscd::placesOfBodies(own), dynamics_.loads());
        double lastDeltaT = 0.0;
        std::vector<int> impulseTo;
        std::map<std::int64_t, int> rankOf;
        for (std::size_t i = 0; i < own.size(); ++i) rankOf[own.id[i]] = destination[i];
        const std::vector<nscd::StoredImpulse> impulses = dynamics_.checkpoint(lastDeltaT);
        for (const nscd::StoredImpulse& entry : impulses) impulseTo.push_back(rankOf.at(entry.idA));
        const std::vector<nscd::StoredImpulse> arrived = nscd::moveImpulses(all, impulses, impulseTo);
        const int left = static_cast<int>(own.size() - std::count(destination.begin(), destination.end(), all.rank()));
        dynamics_.setGrains(nscd::Migration(all, destination).moveGrains(own));
        dynamics_.restore(arrived, lastDeltaT);
        return left;
    }

    /// All ranks' grains in the order of their identities.
    nscd::Grains gatherGrains() const
    {
        const nscd::Grains& own = dynamics_.grains();
        std::vector<double> here;
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            here.push_back(static_cast<double>(own.id[i]));
            add(here, own.position[i]);
            add(here, own.velocity[i]);
            add(here, own.omega[i]);
        }
        const std::vector<double> all = gather(here);
        nscd::Grains grains = whole_;
        for (std::size_t k = 0; k < all.size(); k += 10)
        {
            const std::size_t i = static_cast<std::size_t>(all[k]);
            grains.position[i] = Vec3(&all[k + 1]);
            grains.velocity[i] = Vec3(&all[k + 4]);
            grains.omega[i] = Vec3(&all[k + 7]);
        }
        gatherClumps(grains);
        return grains;
    }

    /// All ranks' contacts, by identities.
    std::vector<nscd::LoadedContact> gatherContacts() const
    {
        std::vector<double> here;
        for (const nscd::LoadedContact& c : dynamics_.contacts())
        {
            here.push_back(static_cast<double>(c.idA));
            here.push_back(static_cast<double>(c.idB));
            for (const Vec3& x : {c.impulse, c.attraction, c.moment}) add(here, x);
        }
        const std::vector<double> all = gather(here);
        std::vector<nscd::LoadedContact> contacts;
        for (std::size_t k = 0; k < all.size(); k += 11)
        {
            const std::int64_t idA = static_cast<std::int64_t>(all[k]), idB = static_cast<std::int64_t>(all[k + 1]);
            contacts.push_back({-1, -1, idA, idB, Vec3::Zero(), 0.0, Vec3(&all[k + 2]), Vec3(&all[k + 5]), Vec3(&all[k + 8])});
        }
        return contacts;
    }

    /// Contacts between grains of different ranks that carry an impulse, on all ranks.
    int interfaceContacts() const
    {
        double count = 0.0;
        for (const nscd::LoadedContact& c : dynamics_.contacts())
        {
            if (c.b >= static_cast<int>(dynamics_.grains().size())) count += 1.0;
        }
        exchange_->sum(&count, 1);
        return static_cast<int>(count);
    }

private:
    void gatherClumps(nscd::Grains& grains) const
    {
        const nscd::Clumps& own = dynamics_.grains().clumps;
        std::vector<double> here;
        for (std::size_t c = 0; c < own.size(); ++c)
        {
            here.push_back(static_cast<double>(dynamics_.grains().id[own.firstMember[c]]));
            for (const Vec3& x : {own.position[c], own.velocity[c], own.angularMomentum[c]}) add(here, x);
            here.insert(here.end(), own.orientation[c].coeffs().data(), own.orientation[c].coeffs().data() + 4);
        }
        const std::vector<double> all = gather(here);
        nscd::Clumps& clumps = grains.clumps;
        for (std::size_t k = 0; k < all.size(); k += 14)
        {
            const auto first = std::find(clumps.firstMember.begin(), clumps.firstMember.end(), static_cast<int>(all[k]));
            const auto c = first - clumps.firstMember.begin();
            clumps.position[c] = Vec3(&all[k + 1]);
            clumps.velocity[c] = Vec3(&all[k + 4]);
            clumps.angularMomentum[c] = Vec3(&all[k + 7]);
            clumps.orientation[c].coeffs() = Eigen::Vector4d(&all[k + 10]);
        }
    }

    /// A clump has the owner of its first member.
    static std::vector<int> owners(const nscd::Grains& all, const OwnerOf& ownerOf)
    {
        std::vector<int> owner;
        for (std::size_t i = 0; i < all.size(); ++i) owner.push_back(ownerOf(all.position[i], all.id[i]));
        const nscd::Clumps& clumps = all.clumps;
        for (std::size_t c = 0; c < clumps.size(); ++c)
        {
            const auto first = owner.begin() + clumps.firstMember[c];
            std::fill_n(first, clumps.shapeOf(c).members.size(), *first);
        }
        return owner;
    }

    void addOwnClumps(const nscd::Grains& all, const std::vector<int>& owner, nscd::Grains& own) const
    {
        own.clumps.shapes = all.clumps.shapes;
        for (std::size_t c = 0; c < all.clumps.size(); ++c)
        {
            const int first = all.clumps.firstMember[c];
            if (owner[first] != exchange_->rank()) continue;
            own.clumps.shape.push_back(all.clumps.shape[c]);
            own.clumps.firstMember.push_back(static_cast<int>(std::find(own.id.begin(), own.id.end(), all.id[first]) - own.id.begin()));
            own.clumps.position.push_back(all.clumps.position[c]);
            own.clumps.orientation.push_back(all.clumps.orientation[c]);
            own.clumps.velocity.push_back(all.clumps.velocity[c]);
            own.clumps.angularMomentum.push_back(all.clumps.angularMomentum[c]);
        }
    }

    nscd::Grains mine(const nscd::Grains& all, const OwnerOf& ownerOf) const
    {
        nscd::Grains own;
        own.shape = all.shape;
        const std::vector<int> owner = owners(all, ownerOf);
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            if (owner[i] != exchange_->rank()) continue;
            own.add(all.position[i], all.radius[i], all.mass[i]/all.volume(i), all.material[i], all.id[i]);
            own.velocity.back() = all.velocity[i];
            own.omega.back() = all.omega[i];
            own.isFixed.back() = all.isFixed[i];
        }
        addOwnClumps(all, owner, own);
        return own;
    }

    std::shared_ptr<nscd::MpiExchange> exchange_;
    nscd::Grains whole_;
    nscd::GrainDynamics dynamics_;
};

} // namespace scenes
