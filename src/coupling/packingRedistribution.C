// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moves what exceeds a packing limit to neighboring cells.
#include "packingRedistribution.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// The excess spreads like diffusion: n passes reach about sqrt(n) cells beyond the overfull ones. Grains ten cells wide need 300.
constexpr label maxPasses = 1000;

// Round-off of a cell filled to the brim does not start another pass.
constexpr scalar brim = 1e-10;

} // namespace

PackingRedistribution::PackingRedistribution
(
    const MappingMesh& mesh, const HaloExchange& exchange, const scalar largestSolidFraction
)
:
    mesh_(mesh),
    exchange_(exchange),
    limit_(largestSolidFraction)
{}

void PackingRedistribution::findLowerNeighbors(const label cell, const scalarField& solidFraction)
{
    lower_.clear();
    for (label k = mesh_.cellFaceStart[cell]; k < mesh_.cellFaceStart[cell + 1]; ++k)
    {
        const label other = mesh_.cellFaces[k].neighbor;
        const bool isKnown = std::find(lower_.begin(), lower_.end(), other) != lower_.end();
        if (other >= 0 && !isKnown && solidFraction[other] < solidFraction[cell])
        {
            lower_.push_back(other);
        }
    }
}

scalar PackingRedistribution::relieve(const label cell, scalarField& solidFraction)
{
    findLowerNeighbors(cell, solidFraction);
    const scalar fraction = solidFraction[cell];
    const scalar volume = mesh_.cellVolume[cell];
    scalar room = 0;
    scalar below = 0;
    scalar lowerVolume = 0;
    for (const label other : lower_)
    {
        room += mesh_.cellVolume[other]*std::max(0.0, limit_ - solidFraction[other]);
        below += mesh_.cellVolume[other]*(fraction - solidFraction[other]);
        lowerVolume += mesh_.cellVolume[other];
    }
    const scalar excess = (fraction - limit_)*volume;
    const bool fits = room >= excess;
    const scalar moved = fits ? excess : below*volume/(volume + lowerVolume);
    if (moved <= 0)
    {
        return 0;
    }
    Move move{cell, label(targets_.size()), 0, 1 - moved/(fraction*volume)};
    for (const label other : lower_)
    {
        const scalar level = fits ? limit_ : fraction;
        const scalar wanted = mesh_.cellVolume[other]*std::max(0.0, level - solidFraction[other]);
        const scalar amount = moved*wanted/(fits ? room : below);
        targets_.push_back({other, amount/(fraction*volume)});
        solidFraction[other] += amount/mesh_.cellVolume[other];
        ++move.nTargets;
    }
    solidFraction[cell] *= move.kept;
    moves_.push_back(move);
    return moved;
}

bool PackingRedistribution::exceeds(const scalar solidFraction) const
{
    return solidFraction > limit_*(1 + brim);
}

bool PackingRedistribution::anyExceeds(const scalarField& solidFraction) const
{
    const auto end = solidFraction.begin() + mesh_.nOwnCells;
    const bool isHere = std::any_of(solidFraction.begin(), end, [this](const scalar value) { return exceeds(value); });
    return exchange_.max(isHere) > 0;
}

scalar PackingRedistribution::runPass(scalarField& solidFraction)
{
    const CellFields fields{{&solidFraction}, {}};
    exchange_.toHalo(fields);
    const std::vector<scalar> halo(solidFraction.begin() + mesh_.nOwnCells, solidFraction.end());
    scalar moved = 0;
    for (label cell = 0; cell < mesh_.nOwnCells; ++cell)
    {
        if (exceeds(solidFraction[cell])) moved += relieve(cell, solidFraction);
    }
    for (std::size_t k = 0; k < halo.size(); ++k) solidFraction[mesh_.nOwnCells + label(k)] -= halo[k];
    exchange_.toOwners(fields);
    passEnd_.push_back(label(moves_.size()));
    return moved;
}

RedistributionReport PackingRedistribution::build(scalarField& solidFraction)
{
    RedistributionReport report;
    moves_.clear();
    targets_.clear();
    passEnd_.clear();
    if (!anyExceeds(solidFraction))
    {
        return report;
    }
    solidFraction.setSize(mesh_.nCells(), Zero);
    do
    {
        report.movedVolume += runPass(solidFraction);
        ++report.passes;
    }
    while (report.passes < maxPasses && anyExceeds(solidFraction));
    solidFraction.setSize(mesh_.nOwnCells);
    forAll(solidFraction, cell)
    {
        if (exceeds(solidFraction[cell])) report.unresolvedVolume += (solidFraction[cell] - limit_)*mesh_.cellVolume[cell];
    }
    scalar sums[] = {report.movedVolume, report.unresolvedVolume};
    exchange_.sum(sums, 2);
    report.movedVolume = sums[0];
    report.unresolvedVolume = sums[1];
    return report;
}

template<class Type>
void PackingRedistribution::spread(const std::size_t pass, Field<Type>& perVolume) const
{
    for (label moveI = passStart(pass); moveI < passEnd_[pass]; ++moveI)
    {
        const Move& move = moves_[moveI];
        const Type amount = mesh_.cellVolume[move.from]*perVolume[move.from];
        for (label k = move.firstTarget; k < move.firstTarget + move.nTargets; ++k)
        {
            perVolume[targets_[k].cell] += targets_[k].share/mesh_.cellVolume[targets_[k].cell]*amount;
        }
        perVolume[move.from] *= move.kept;
    }
}

void PackingRedistribution::spread(const CellFields& perVolume) const
{
    perVolume.resize(isActive() ? mesh_.nCells() : mesh_.nOwnCells);
    for (std::size_t pass = 0; pass < passEnd_.size(); ++pass)
    {
        for (scalarField* field : perVolume.scalars) spread(pass, *field);
        for (vectorField* field : perVolume.vectors) spread(pass, *field);
        exchange_.toOwners(perVolume);
    }
    perVolume.resize(mesh_.nOwnCells);
}

template<class Type>
void PackingRedistribution::sample(const std::size_t pass, Field<Type>& cells) const
{
    for (label moveI = passEnd_[pass] - 1; moveI >= passStart(pass); --moveI)
    {
        const Move& move = moves_[moveI];
        Type value = move.kept*cells[move.from];
        for (label k = move.firstTarget; k < move.firstTarget + move.nTargets; ++k)
        {
            value += targets_[k].share*cells[targets_[k].cell];
        }
        cells[move.from] = value;
    }
}

void PackingRedistribution::sample(const CellFields& cells) const
{
    cells.resize(isActive() ? mesh_.nCells() : mesh_.nOwnCells);
    for (std::size_t pass = passEnd_.size(); pass-- > 0;)
    {
        exchange_.toHalo(cells);
        for (scalarField* field : cells.scalars) sample(pass, *field);
        for (vectorField* field : cells.vectors) sample(pass, *field);
    }
    cells.resize(mesh_.nOwnCells);
}

} // namespace nscdCoupling
} // namespace Foam
