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

PackingRedistribution::PackingRedistribution(const MappingMesh& mesh, const scalar largestSolidFraction)
:
    mesh_(mesh),
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

RedistributionReport PackingRedistribution::build(scalarField& solidFraction)
{
    RedistributionReport report;
    moves_.clear();
    targets_.clear();
    while (true)
    {
        const bool isLast = report.passes == maxPasses;
        bool anyExceeds = false;
        report.unresolvedVolume = 0;
        forAll(solidFraction, cellI)
        {
            if (solidFraction[cellI] <= limit_*(1 + brim))
            {
                continue;
            }
            anyExceeds = true;
            report.unresolvedVolume += (solidFraction[cellI] - limit_)*mesh_.cellVolume[cellI];
            report.movedVolume += isLast ? 0 : relieve(cellI, solidFraction);
        }
        if (!anyExceeds || isLast)
        {
            return report;
        }
        ++report.passes;
    }
}

} // namespace nscdCoupling
} // namespace Foam
