// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Recording what function objects ask for, and bringing values of grains to cells for them.
#include "coupling/step/grainAccess.H"

#include "coupling/case/input/inputError.H"
#include "coupling/mapping/grainMapping.H"
#include "coupling/step/grainsAtHome.H"

#include "parallel/idDirectory.hpp"

#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

defineTypeNameAndDebug(GrainAccess, 0);

namespace
{

/// Tensors that other ranks have for grains of this one. Collective.
std::vector<TensorForGrain> swapped(const std::vector<TensorForGrain>& away, const ::nscd::Grains& grains, const ::nscd::Communicator& all)
{
    std::vector<std::int64_t> ids;
    for (const TensorForGrain& tensor : away) ids.push_back(tensor.id);
    const std::vector<int> owners = ::nscd::IdDirectory(all, {grains.id.begin(), grains.id.begin() + std::ptrdiff_t(grains.nOwned)}).owners(ids);
    std::vector<TensorForGrain> owned;
    std::vector<int> destination;
    for (std::size_t k = 0; k < away.size(); ++k)
    {
        if (owners[k] < 0) continue;
        owned.push_back(away[k]);
        destination.push_back(owners[k]);
    }
    return ::nscd::valuesOf<TensorForGrain>(all.exchange(::nscd::messagesByRank(owned, destination)));
}

} // namespace


GrainAccess::GrainAccess
(
    const fvMesh& mesh, const PatchRoles& roles, const ::nscd::PeriodicBox& box, const ::nscd::Materials& materials
)
:
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE)),
    nCells_(mesh.nCells()),
    roles_(roles),
    box_(box),
    materials_(materials)
{}


const GrainAccess& GrainAccess::of(const objectRegistry& mesh, const input::Place& place)
{
    if (mesh.foundObject<GrainAccess>(typeName)) return mesh.lookupObject<GrainAccess>(typeName);
    fail({place, "needs grains", "", "a function object of nscdDEMFoam, in a run of it"});
}


void GrainAccess::showMapping(const std::unique_ptr<GrainMapping>& mapping, const GrainsAtHome& atHome)
{
    mapping_ = &mapping;
    atHome_ = &atHome;
}


std::vector<scalarField> GrainAccess::perVolume(std::vector<std::vector<scalar>> amounts) const
{
    std::vector<scalarField> cells(amounts.size(), scalarField(nCells_, Zero));
    // A mapping that never saw grains has no shares.
    if (!*mapping_ || returnReduce(label(grains_->nOwned), sumOp<label>()) == 0) return cells;
    if ((*mapping_)->hasBodies())
    {
        FatalErrorInFunction << "Function objects that lay amounts of grains down in cells know no clumps; remove them." << exit(FatalError);
    }
    GrainValues values;
    for (std::vector<scalar>& amount : amounts) values.scalars.push_back(&amount);
    atHome_->toHomes(values);
    std::vector<ScalarSpread> spreads;
    for (std::size_t k = 0; k < amounts.size(); ++k) spreads.push_back({amounts[k], cells[k]});
    (*mapping_)->spread(spreads, {});
    return cells;
}


std::vector<std::vector<scalar>> GrainAccess::sumsOfOwned(const std::vector<TensorForGrain>& tensors) const
{
    std::unordered_map<std::int64_t, std::size_t> indexOf;
    for (std::size_t i = 0; i < grains_->nOwned; ++i) indexOf[grains_->id[i]] = i;
    std::vector<std::vector<scalar>> sums(9, std::vector<scalar>(grains_->nOwned, 0));
    std::vector<TensorForGrain> away;
    const auto take = [&](const TensorForGrain& tensor)
    {
        const auto found = indexOf.find(tensor.id);
        if (found == indexOf.end()) return away.push_back(tensor);
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k][found->second] += tensor.value[k];
    };
    for (const TensorForGrain& tensor : tensors) take(tensor);
    if (!all_ || returnReduce(label(away.size()), sumOp<label>()) == 0) return sums;
    for (const TensorForGrain& tensor : swapped(away, *grains_, *all_)) take(tensor);
    return sums;
}


void GrainAccess::beginStep()
{
    contacts_.clear();
    moves_.clear();
    exits_.clear();
    if (!followsMoves_) return;
    for (std::size_t i = 0; i < grains_->nOwned; ++i)
    {
        moves_.push_back({grains_->position[i], grains_->position[i], grains_->mass[i]});
    }
}


bool GrainAccess::areContactsWanted() const
{
    bool any = false;
    for (const auto& wanted : contactsWanted_) any = wanted.second() || any;
    return any;
}


void GrainAccess::endMoves()
{
    for (std::size_t i = 0; i < moves_.size(); ++i) moves_[i].to = grains_->position[i];
}


void GrainAccess::recordExits(const std::vector<std::size_t>& gone, const labelList& patches)
{
    for (std::size_t k = 0; k < gone.size(); ++k) exits_.push_back({patches[label(k)], grains_->mass[gone[k]]});
}

} // namespace nscdCoupling
} // namespace Foam
