// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moves what exceeds a packing limit to neighboring cells.
#include "coupling/mapping/packing/packingRedistribution.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// A way is as many passes long as there are cells on it.
constexpr label maxPasses = 1000;

// Solid fraction, over the limit, that may still be on its way after the last pass.
constexpr scalar onItsWay = 1e-13;

// Excess over the limit, relative to it, that is left alone, and that is not told.
constexpr scalar leftAlone = 1e-12;
constexpr scalar notTold = 1e-10;

} // namespace

// What arrived in the cells in the last pass is either kept or passed on.
template<class Type>
class PackingRedistribution::Passage
{
public:
    Passage(const PackingRedistribution& owner, Field<Type>& perVolume)
    :
        owner_(owner),
        kept_(perVolume),
        arrived_(owner.atPassers(perVolume)),
        next_(owner.mesh_.nCells(), Zero)
    {
        for (const Passer& passer : owner.passers_) kept_[passer.cell] = Zero;
    }

    Field<Type>& next() { return next_; }

    void give()
    {
        const std::vector<scalar>& volume = owner_.mesh_.cellVolume;
        forAll(arrived_, k)
        {
            const Passer& passer = owner_.passers_[k];
            kept_[passer.cell] += passer.kept*arrived_[k];
            for (label t = passer.firstTarget; t < passer.firstTarget + passer.nTargets; ++t)
            {
                const Target& target = owner_.targets_[t];
                next_[target.cell] += target.share*volume[passer.cell]/volume[target.cell]*arrived_[k];
            }
        }
    }

    // After next() went to the owners.
    void take()
    {
        forAll(arrived_, k)
        {
            const label cell = owner_.passers_[k].cell;
            arrived_[k] = next_[cell];
            next_[cell] = Zero;
        }
    }

    void finish()
    {
        forAll(arrived_, k) kept_[owner_.passers_[k].cell] += arrived_[k];
    }

    // The most that is still to be passed on.
    scalar largestOnItsWay() const
    {
        scalar largest = 0;
        forAll(arrived_, k)
        {
            if (owner_.passers_[k].nTargets > 0) largest = std::max(largest, mag(arrived_[k]));
        }
        return largest;
    }

private:
    const PackingRedistribution& owner_;
    Field<Type>& kept_;
    Field<Type> arrived_;  // by passer
    Field<Type> next_;
};

PackingRedistribution::PackingRedistribution
(
    const MappingMesh& mesh, const HaloExchange& exchange, const scalar largestSolidFraction
)
:
    mesh_(mesh),
    exchange_(exchange),
    limit_(largestSolidFraction),
    potential_(mesh, exchange, largestSolidFraction)
{}

template<class Type>
Field<Type> PackingRedistribution::atPassers(const Field<Type>& cells) const
{
    Field<Type> values(label(passers_.size()));
    forAll(values, k) values[k] = cells[passers_[k].cell];
    return values;
}

scalar PackingRedistribution::largest(const scalarField& solidFraction) const
{
    const auto largest = std::max_element(solidFraction.begin(), solidFraction.end());
    return exchange_.max(largest == solidFraction.end() ? 0 : *largest);
}

// held: what is in the cell and what arrives there [m3].
void PackingRedistribution::addPasser(const label cell, const scalar held)
{
    Passer passer{cell, 1, label(targets_.size()), 0};
    potential_.forAllNeighbors(cell, [&](const label to)
    {
        const scalar share = potential_.flow(cell, to)/held;
        if (share > 0)
        {
            targets_.push_back({to, share});
            passer.kept -= share;
            ++passer.nTargets;
        }
    });
    passers_.push_back(passer);
}

// Returns the volume that flows out of own cells.
scalar PackingRedistribution::findPassers(const scalarField& solidFraction)
{
    scalar moved = 0;
    for (label cell = 0; cell < mesh_.nOwnCells; ++cell)
    {
        scalar in = 0;
        scalar out = 0;
        potential_.forAllNeighbors(cell, [&](const label other)
        {
            in += potential_.flow(other, cell);
            out += potential_.flow(cell, other);
        });
        if (in > 0 || out > 0) addPasser(cell, std::max(out, in + solidFraction[cell]*mesh_.cellVolume[cell]));
        moved += out;
    }
    return moved;
}

void PackingRedistribution::pass(scalarField& solidFraction)
{
    Passage<scalar> passage(*this, solidFraction);
    while (nPasses_ < maxPasses && exchange_.max(passage.largestOnItsWay()) > onItsWay*limit_)
    {
        passage.give();
        exchange_.toOwners({{&passage.next()}, {}});
        passage.take();
        ++nPasses_;
    }
    passage.finish();
}

void PackingRedistribution::sumReport(const scalarField& solidFraction, RedistributionReport& report) const
{
    forAll(solidFraction, cell)
    {
        const scalar excess = solidFraction[cell] - limit_;
        if (excess > notTold*limit_) report.unresolvedVolume += excess*mesh_.cellVolume[cell];
    }
    scalar sums[] = {report.movedVolume, report.unresolvedVolume};
    exchange_.sum(sums, 2);
    report.movedVolume = sums[0];
    report.unresolvedVolume = sums[1];
}

RedistributionReport PackingRedistribution::build(scalarField& solidFraction)
{
    RedistributionReport report;
    passers_.clear();
    targets_.clear();
    nPasses_ = 0;
    const scalar before = largest(solidFraction);
    if (before <= limit_*(1 + leftAlone))
    {
        return report;
    }
    const scalarField old = solidFraction;
    report.iterations = potential_.solve(solidFraction);
    report.movedVolume = findPassers(solidFraction);
    pass(solidFraction);
    if (largest(solidFraction) > before)
    {
        report.movedVolume = 0;
        nPasses_ = 0;
        solidFraction = old;
    }
    report.passes = nPasses_;
    sumReport(solidFraction, report);
    return report;
}

void PackingRedistribution::spread(const CellFields& perVolume) const
{
    if (!isActive())
    {
        return;
    }
    std::vector<Passage<scalar>> scalars;
    std::vector<Passage<vector>> vectors;
    for (scalarField* field : perVolume.scalars) scalars.emplace_back(*this, *field);
    for (vectorField* field : perVolume.vectors) vectors.emplace_back(*this, *field);
    CellFields next;
    for (Passage<scalar>& passage : scalars) next.scalars.push_back(&passage.next());
    for (Passage<vector>& passage : vectors) next.vectors.push_back(&passage.next());
    for (label pass = 0; pass < nPasses_; ++pass)
    {
        for (Passage<scalar>& passage : scalars) passage.give();
        for (Passage<vector>& passage : vectors) passage.give();
        exchange_.toOwners(next);
        for (Passage<scalar>& passage : scalars) passage.take();
        for (Passage<vector>& passage : vectors) passage.take();
    }
    for (Passage<scalar>& passage : scalars) passage.finish();
    for (Passage<vector>& passage : vectors) passage.finish();
}

template<class Type>
void PackingRedistribution::sampleOnce(const Field<Type>& before, Field<Type>& cells) const
{
    Field<Type> seen(before.size());
    forAll(seen, k)
    {
        const Passer& passer = passers_[k];
        seen[k] = passer.kept*before[k];
        for (label t = passer.firstTarget; t < passer.firstTarget + passer.nTargets; ++t)
        {
            seen[k] += targets_[t].share*cells[targets_[t].cell];
        }
    }
    forAll(seen, k) cells[passers_[k].cell] = seen[k];
}

// P^T = (1 + S^T + ... ) K + S^T^n by Horner's rule.
void PackingRedistribution::sample(const CellFields& cells) const
{
    if (!isActive())
    {
        return;
    }
    std::vector<scalarField> scalars;
    std::vector<vectorField> vectors;
    for (const scalarField* field : cells.scalars) scalars.push_back(atPassers(*field));
    for (const vectorField* field : cells.vectors) vectors.push_back(atPassers(*field));
    cells.resize(mesh_.nCells());
    for (label pass = 0; pass < nPasses_; ++pass)
    {
        exchange_.toHalo(cells);
        for (std::size_t k = 0; k < scalars.size(); ++k) sampleOnce(scalars[k], *cells.scalars[k]);
        for (std::size_t k = 0; k < vectors.size(); ++k) sampleOnce(vectors[k], *cells.vectors[k]);
    }
    cells.resize(mesh_.nOwnCells);
}

} // namespace nscdCoupling
} // namespace Foam
