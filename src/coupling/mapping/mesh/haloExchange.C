// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Values of cells between the ranks that own them and those that hold copies.
#include "coupling/mapping/mesh/haloExchange.H"

#include "parallel/communicator.hpp"

#include "Pstream.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// Calls handle(value) for every scalar of a cell, in an order of its own.
template<class Handle>
void forAllScalars(const CellFields& fields, const label cell, const Handle& handle)
{
    for (scalarField* field : fields.scalars) handle((*field)[cell]);
    for (vectorField* field : fields.vectors)
    {
        for (direction axis = 0; axis < 3; ++axis) handle((*field)[cell][axis]);
    }
}

} // namespace

void CellFields::resize(const label nCells) const
{
    for (scalarField* field : scalars) field->setSize(nCells, Zero);
    for (vectorField* field : vectors) field->setSize(nCells, Zero);
}

struct HaloExchange::Lists
{
    std::vector<::nscd::RankCount> owners;   // of the halo cells, which come in their order
    std::vector<::nscd::RankCount> holders;  // of own cells as halo cells
    std::vector<label> shared;               // those own cells, by holder
    std::vector<double> own;                 // work space: values of `shared`
    std::vector<double> halo;                // work space: values of the halo cells
};

HaloExchange::HaloExchange(const MappingMesh& mesh)
:
    nOwn_(mesh.nOwnCells),
    nCells_(mesh.nCells())
{
    if (Pstream::parRun())
    {
        ranks_.reset(new ::nscd::Communicator);
        lists_.reset(new Lists);
        connect(mesh);
    }
}

HaloExchange::~HaloExchange() = default;

void HaloExchange::connect(const MappingMesh& mesh)
{
    std::vector<label> cells;
    std::vector<int> ranks;
    for (const CellHome& home : mesh.haloHomes)
    {
        cells.push_back(home.cell);
        ranks.push_back(home.rank);
    }
    const std::vector<::nscd::Message> requests = ::nscd::messagesByRank(cells, ranks);
    for (const ::nscd::Message& request : requests)
    {
        lists_->owners.push_back({request.rank, int(request.bytes.size()/sizeof(label))});
    }
    for (const ::nscd::Message& request : ranks_->exchange(requests))
    {
        lists_->holders.push_back({request.rank, int(request.bytes.size()/sizeof(label))});
        ::nscd::unpack(request.bytes, lists_->shared);
    }
}

void HaloExchange::toHalo(const CellFields& fields) const
{
    if (!isParallel())
    {
        return;
    }
    lists_->own.clear();
    for (const label cell : lists_->shared)
    {
        forAllScalars(fields, cell, [this](const scalar value) { lists_->own.push_back(value); });
    }
    lists_->halo.resize(std::size_t(fields.width())*(nCells_ - nOwn_));
    ranks_->transfer(lists_->holders, lists_->own.data(), lists_->owners, lists_->halo.data(), fields.width());
    const double* next = lists_->halo.data();
    for (label cell = nOwn_; cell < nCells_; ++cell)
    {
        forAllScalars(fields, cell, [&next](scalar& value) { value = *next++; });
    }
}

void HaloExchange::toOwners(const CellFields& fields) const
{
    if (!isParallel())
    {
        return;
    }
    lists_->halo.clear();
    for (label cell = nOwn_; cell < nCells_; ++cell)
    {
        forAllScalars(fields, cell, [this](scalar& value) { lists_->halo.push_back(value); value = 0; });
    }
    lists_->own.resize(fields.width()*lists_->shared.size());
    ranks_->transfer(lists_->owners, lists_->halo.data(), lists_->holders, lists_->own.data(), fields.width());
    const double* next = lists_->own.data();
    for (const label cell : lists_->shared)
    {
        forAllScalars(fields, cell, [&next](scalar& value) { value += *next++; });
    }
}

void HaloExchange::sum(scalar* values, const int count) const
{
    if (isParallel()) ranks_->sum(values, count);
}

scalar HaloExchange::max(scalar value) const
{
    if (isParallel()) ranks_->max(&value, 1);
    return value;
}

} // namespace nscdCoupling
} // namespace Foam
