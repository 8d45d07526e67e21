// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How much solid each cell passes on to its neighbors so that none is fuller than a limit.
#include "coupling/mapping/packing/packingPotential.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// Round-off of a cell filled to the limit does not make it flow.
constexpr scalar roundOff = 1e-14;

// Root of the sum of squares of what is left above or below the limit in cells that flow, over the limit.
constexpr scalar tolerance = 1e-13;

// By how much each solution brings that down as long as the set of cells that flow still changes.
constexpr scalar roughly = 0.1;

// Solutions of the last set: each starts from what round-off of the one before left.
constexpr label nLast = 2;

constexpr label maxIterations = 20000;

// Room that is left in the whole mesh, relative to what it holds at the limit; with less, nothing flows.
constexpr scalar leastRoom = 1e-6;

} // namespace

PackingPotential::PackingPotential(const MappingMesh& mesh, const HaloExchange& exchange, const scalar largestSolidFraction)
:
    mesh_(mesh),
    exchange_(exchange),
    limit_(largestSolidFraction)
{}

scalar PackingPotential::conductance(const label cell, const label neighbor) const
{
    return std::min(mesh_.cellVolume[cell], mesh_.cellVolume[neighbor]);
}

scalar PackingPotential::flow(const label from, const label to) const
{
    return conductance(from, to)*std::max(0.0, potential_[from] - potential_[to]);
}

scalar PackingPotential::netOutflow(const label cell, const scalarField& potential) const
{
    scalar sum = 0;
    forAllNeighbors(cell, [&](const label to) { sum += conductance(cell, to)*(potential[cell] - potential[to]); });
    return sum;
}

// Cells that would flow backwards leave the set. Whether there are any here.
bool PackingPotential::drop()
{
    const std::size_t before = flowing_.size();
    const auto isBackwards = [this](const Flowing& f) { return potential_[f.cell] < 0; };
    for (const Flowing& f : flowing_)
    {
        if (!isBackwards(f)) continue;
        flows_[f.cell] = false;
        direction_[f.cell] = 0;
    }
    flowing_.erase(std::remove_if(flowing_.begin(), flowing_.end(), isBackwards), flowing_.end());
    for (scalar& u : potential_) u = std::max(0.0, u);
    return flowing_.size() < before;
}

// Overfull cells that do not flow yet join the set. Whether there are any here.
bool PackingPotential::grow(const scalarField& solidFraction)
{
    const std::size_t before = flowing_.size();
    for (label cell = 0; cell < mesh_.nOwnCells; ++cell)
    {
        if (flows_[cell]) continue;
        const scalar fraction = solidFraction[cell] - netOutflow(cell, potential_)/mesh_.cellVolume[cell];
        if (fraction <= limit_*(1 + roundOff)) continue;
        scalar diagonal = 0;
        forAllNeighbors(cell, [&](const label to) { diagonal += conductance(cell, to); });
        flowing_.push_back({cell, diagonal, 0});
        flows_[cell] = true;
    }
    return flowing_.size() > before;
}

void PackingPotential::findResiduals(const scalarField& solidFraction)
{
    for (Flowing& f : flowing_)
    {
        f.residual = (solidFraction[f.cell] - limit_)*mesh_.cellVolume[f.cell] - netOutflow(f.cell, potential_);
    }
}

// Sums over the cells that flow: residual.residual/diagonal, and the squares of what is left above or below the limit.
PackingPotential::Size PackingPotential::size() const
{
    scalar sums[] = {0, 0};
    for (const Flowing& f : flowing_)
    {
        sums[0] += sqr(f.residual)/f.diagonal;
        sums[1] += sqr(f.residual/mesh_.cellVolume[f.cell]);
    }
    exchange_.sum(sums, 2);
    return {sums[0], std::sqrt(sums[1])};
}

// One step of conjugate gradients along direction_, with the diagonal as preconditioner. Returns the size after it.
PackingPotential::Size PackingPotential::step(const Size& before)
{
    exchange_.toHalo({{&direction_}, {}});
    scalar curvature = 0;
    image_.resize(flowing_.size());
    for (std::size_t k = 0; k < flowing_.size(); ++k)
    {
        image_[k] = netOutflow(flowing_[k].cell, direction_);
        curvature += direction_[flowing_[k].cell]*image_[k];
    }
    exchange_.sum(&curvature, 1);
    if (curvature <= 0)
    {
        return {};
    }
    const scalar length = before.weighted/curvature;
    for (std::size_t k = 0; k < flowing_.size(); ++k)
    {
        potential_[flowing_[k].cell] += length*direction_[flowing_[k].cell];
        flowing_[k].residual -= length*image_[k];
    }
    const Size after = size();
    for (const Flowing& f : flowing_)
    {
        direction_[f.cell] = f.residual/f.diagonal + after.weighted/before.weighted*direction_[f.cell];
    }
    return after;
}

// Solves the equation of the cells that flow, from the present u. Returns the number of steps.
label PackingPotential::relax(const scalar reduction)
{
    for (const Flowing& f : flowing_) direction_[f.cell] = f.residual/f.diagonal;
    Size left = size();
    const scalar enough = std::max(tolerance*limit_, reduction*left.plain);
    label steps = 0;
    for (; steps < maxIterations && left.plain > enough; ++steps) left = step(left);
    exchange_.toHalo({{&potential_}, {}});
    return steps;
}

bool PackingPotential::isRoomForAll(const scalarField& solidFraction) const
{
    scalar sums[] = {0, 0};
    forAll(solidFraction, cell)
    {
        sums[0] += solidFraction[cell]*mesh_.cellVolume[cell];
        sums[1] += limit_*mesh_.cellVolume[cell];
    }
    exchange_.sum(sums, 2);
    return sums[0] < sums[1]*(1 - leastRoom);
}

label PackingPotential::solve(const scalarField& solidFraction)
{
    potential_ = scalarField(mesh_.nCells(), Zero);
    direction_ = potential_;
    flows_.assign(mesh_.nOwnCells, false);
    flowing_.clear();
    label iterations = 0;
    label last = isRoomForAll(solidFraction) ? 0 : nLast;
    while (last < nLast && iterations < maxIterations)
    {
        const bool isDropped = drop();
        const bool isGrown = grow(solidFraction);
        last = exchange_.max(isDropped || isGrown) > 0 ? 0 : last + 1;
        findResiduals(solidFraction);
        iterations += relax(last > 0 ? 0 : roughly);
    }
    drop();
    exchange_.toHalo({{&potential_}, {}});
    return iterations;
}

} // namespace nscdCoupling
} // namespace Foam
