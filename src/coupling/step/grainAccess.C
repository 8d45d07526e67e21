// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Recording what function objects ask for, and bringing values of grains to cells for them.
#include "coupling/step/grainAccess.H"

#include "coupling/case/input/inputError.H"
#include "coupling/mapping/grainMapping.H"
#include "coupling/step/grainsAtHome.H"

namespace Foam
{
namespace nscdCoupling
{

defineTypeNameAndDebug(GrainAccess, 0);


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
    GrainValues values;
    for (std::vector<scalar>& amount : amounts) values.scalars.push_back(&amount);
    atHome_->toHomes(values);
    std::vector<ScalarSpread> spreads;
    for (std::size_t k = 0; k < amounts.size(); ++k) spreads.push_back({amounts[k], cells[k]});
    (*mapping_)->spread(spreads, {});
    return cells;
}


void GrainAccess::beginStep()
{
    moves_.clear();
    exits_.clear();
    if (!followsMoves_) return;
    for (std::size_t i = 0; i < grains_->nOwned; ++i)
    {
        moves_.push_back({grains_->position[i], grains_->position[i], grains_->mass[i]});
    }
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
