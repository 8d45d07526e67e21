// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moving grains and their contacts between ranks.
#include "coupling/step/grainRanks.H"

#include "coupling/case/files/clumpParts.H"

#include "parallel/grainPartition.hpp"
#include "parallel/idDirectory.hpp"
#include "parallel/migration.hpp"
#include "parallel/mpiExchange.hpp"

#include "PstreamReduceOps.H"
#include "Time.H"

#include <numeric>
#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

constexpr label stepsBetweenLooks = 10;

/// What the last share() left may grow by this before it is tried again.
constexpr scalar hopeForBetter = 1.1;

/// By this share the number of grains may change before it counts as another distribution.
constexpr scalar fewOthers = 0.1;

/// Ranks have mixed where they look at more grains of others than this times as many as after the last share(), and at this share of all.
constexpr scalar mixedGhosts = 2.0, fewGhosts = 0.05;

/// Where each contact's first grain, one of this rank's, goes.
std::vector<int> destinationsOfContacts(const GrainState& state, const std::vector<int>& destination)
{
    std::unordered_map<std::int64_t, int> byId;
    for (std::size_t i = 0; i < state.grains.size(); ++i) byId.emplace(state.grains.id[i], destination[i]);
    std::vector<int> ofContacts;
    for (const ::nscd::StoredImpulse& contact : state.contacts) ofContacts.push_back(byId.at(contact.idA));
    return ofContacts;
}

GrainExtras movedExtras(const ::nscd::Migration& move, const GrainExtras& extras)
{
    GrainExtras there;
    for (const auto& [name, values] : extras.scalars) there.scalars[name] = move.move(values);
    for (const auto& [name, values] : extras.vectors) there.vectors[name] = move.move(values);
    return there;
}

void checkDuplicates(const ::nscd::IdDirectory& directory, const polyMesh& mesh)
{
    if (directory.duplicates() == 0) return;
    fail
    ({
        placeInFile(mesh.time().timePath()/"lagrangian/grains", "origId"), "names grains that several processors have",
        Foam::name(label(directory.duplicates())) + " grains", "each grain on one processor"
    });
}

} // namespace

GrainRanks::GrainRanks(scalar maxLoadImbalance)
:
    mpi_(Pstream::parRun() ? std::make_shared<::nscd::MpiExchange>() : nullptr),
    exchange_(mpi_ ? mpi_ : newExchange()),
    maxLoadImbalance_(maxLoadImbalance)
{}

std::shared_ptr<::nscd::Exchange> GrainRanks::newExchange() const
{
    if (isParallel()) return std::make_shared<::nscd::MpiExchange>();
    return std::make_shared<::nscd::Exchange>();
}

const ::nscd::RankTree& GrainRanks::tree() const { return mpi_->tree(); }

GrainState GrainRanks::joinContacts(GrainState state, const polyMesh& mesh) const
{
    if (!isParallel()) return state;
    const ::nscd::Communicator& all = mpi_->tree().all();
    const ::nscd::IdDirectory directory(all, state.grains.id);
    checkDuplicates(directory, mesh);
    std::vector<std::int64_t> idA, idB;
    for (const ::nscd::StoredImpulse& contact : state.contacts)
    {
        idA.push_back(contact.idA);
        idB.push_back(contact.idB >= 0 ? contact.idB : contact.idA);
    }
    const std::vector<int> ownerA = directory.owners(idA), ownerB = directory.owners(idB);
    for (std::size_t k = 0; k < idA.size(); ++k)
    {
        if (ownerA[k] < 0 || ownerB[k] < 0) refuseContact(mesh, state.contacts[k]);
    }
    state.contacts = ::nscd::moveImpulses(all, state.contacts, ownerA);
    return state;
}

GrainState GrainRanks::joinClumps(GrainState state, const polyMesh& mesh, const input::MaterialTable& materials) const
{
    if (!isParallel() || !areClumpsApart(state)) return state;
    const std::vector<scalar>& clump = state.clumpParts.scalars.at(part::clump);
    std::vector<std::int64_t> first;
    for (std::size_t i = 0; i < clump.size(); ++i) first.push_back(clump[i] < 0 ? state.grains.id[i] : std::int64_t(clump[i]));
    const std::vector<int> destination = ::nscd::IdDirectory(mpi_->tree().all(), state.grains.id).owners(first);
    for (std::size_t i = 0; i < destination.size(); ++i)
    {
        if (destination[i] < 0) refuseClump(mesh, label(clump[i]), "whose first member is not there");
    }
    state = moved(state, destination);
    joinClumpParts(state, mesh, materials);
    return state;
}

GrainState GrainRanks::moved(const GrainState& state, const std::vector<int>& destination) const
{
    const ::nscd::Migration move(mpi_->tree().all(), destination);
    GrainState there;
    there.grains = move.moveGrains(state.grains);
    there.extras = movedExtras(move, state.extras);
    there.unwritten = movedExtras(move, state.unwritten);
    there.clumpParts = movedExtras(move, state.clumpParts);
    there.contacts = ::nscd::moveImpulses(mpi_->tree().all(), state.contacts, destinationsOfContacts(state, destination));
    there.numbers = state.numbers;
    return there;
}

std::vector<label> GrainRanks::moved(const std::vector<label>& perGrain, const std::vector<int>& destination) const
{
    return ::nscd::Migration(mpi_->tree().all(), destination).move(perGrain);
}

GrainState GrainRanks::share(const GrainState& state, std::vector<double> load)
{
    if (!isParallel()) return state;
    if (load.empty()) load.assign(state.grains.size(), 1.0);
    const std::vector<int> owner = ::nscd::partitionGrains(mpi_->tree(), ::nscd::placesOfBodies(state.grains), load);
    before_ = imbalanceOf(load);
    after_ = imbalanceOf(::nscd::Migration(mpi_->tree().all(), owner).move(load));
    steps_ = 0;
    grains_ = totalOf(state.grains.size());
    ghosts_ = 0;
    return moved(state, owner);
}

bool GrainRanks::isTimeToLook()
{
    return isParallel() && ++steps_ % stepsBetweenLooks == 0;
}

bool GrainRanks::isUneven(const std::vector<double>& load)
{
    const bool areOthers = mag(totalOf(load.size()) - grains_) > fewOthers*grains_;
    return imbalanceOf(load) > std::max(maxLoadImbalance_, areOthers ? 1 : hopeForBetter*after_);
}

bool GrainRanks::areMixed(std::size_t ghosts, std::size_t grains)
{
    double sums[2] = {static_cast<double>(ghosts), static_cast<double>(grains)};
    exchange_->sum(sums, 2);
    if (ghosts_ > 0) return sums[0] > mixedGhosts*ghosts_ && sums[0] > fewGhosts*sums[1];
    ghosts_ = sums[0];
    return false;
}

scalar GrainRanks::totalOf(std::size_t grains) const
{
    double total = double(grains);
    exchange_->sum(&total, 1);
    return total;
}

scalar GrainRanks::imbalanceOf(const std::vector<double>& load) const
{
    return ::nscd::imbalance(mpi_->tree().all(), std::accumulate(load.begin(), load.end(), 0.0));
}

} // namespace nscdCoupling
} // namespace Foam
