// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Numbers and sizes of the real grains.
#include "coupling/step/coarseGrains.H"

#include "coupling/case/input/heatReader.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

scalar CoarseGrains::numberOf(const ::nscd::Grains& grains, std::size_t i) const
{
    return ::nscd::grainsInParcel(factor_[i], grains.shape.dimensions);
}

bool CoarseGrains::isSound() const
{
    return std::all_of(factor_.begin(), factor_.end(), [](scalar factor) { return factor >= 1 && factor < VGREAT; });
}

void CoarseGrains::welcome(std::size_t first, const std::vector<std::size_t>& sources, const std::vector<::nscd::EntrySource>& all)
{
    for (std::size_t k = 0; k < sources.size(); ++k) factor_[first + k] = all[sources[k]].coarseGraining;
}

void CoarseGrains::dismiss(const ::nscd::Grains& grains, const std::vector<std::size_t>& gone)
{
    for (const std::size_t i : gone) exitedHere_ += numberOf(grains, i);
}

void CoarseGrains::update(const ::nscd::Grains& grains)
{
    radius_.resize(factor_.size());
    for (std::size_t i = 0; i < radius_.size(); ++i) radius_[i] = grains.radius[i]/factor_[i];
}

void CoarseGrains::multiplyDrag(const ::nscd::Grains& grains, std::vector<scalar>& dragFactor) const
{
    for (std::size_t i = 0; i < dragFactor.size(); ++i) dragFactor[i] *= numberOf(grains, i);
}

void CoarseGrains::describe(const ::nscd::Grains& grains, const ::nscd::Exchange& exchange, GrainTotals& totals) const
{
    double number = 0;
    double largest[4] = {-GREAT, 0, -GREAT, 0};  // per parcel and diameter: the least, negative, and the largest
    for (std::size_t i = 0; i < factor_.size(); ++i)
    {
        const scalar inThis = numberOf(grains, i), diameter = 2*grains.radius[i]/factor_[i];
        number += inThis;
        const double values[4] = {-inThis, inThis, -diameter, diameter};
        for (int k = 0; k < 4; ++k) largest[k] = std::max(largest[k], values[k]);
    }
    exchange.sum(&number, 1);
    exchange.max(largest, 4);
    totals.real.number = number;
    if (totals.number == 0) return;
    totals.real.perGrainMin = -largest[0];
    totals.real.perGrainMax = largest[1];
    totals.real.diameterMin = -largest[2];
    totals.real.diameterMax = largest[3];
}

scalar CoarseGrains::exited(const ::nscd::Exchange& exchange) const
{
    double number = exitedHere_;
    exchange.sum(&number, 1);
    return number;
}

scalar realGrainsEntered(const ::nscd::GrainEntry& entry, int dimensions)
{
    scalar number = 0;
    for (std::size_t s = 0; s < entry.sources().size(); ++s)
    {
        number += scalar(entry.states()[s].entered)*::nscd::grainsInParcel(entry.sources()[s].coarseGraining, dimensions);
    }
    return number;
}

void checkCoarseGrains(const GrainProperties& properties)
{
    if (properties.materials.table.anyCohesion())
    {
        fail({properties.materials.contactsPlace, "has cohesion, a force that a contact of parcels has no rule for", "", "no cohesion, or no coarseGraining"});
    }
    if (properties.heat && properties.heat->hasContacts)
    {
        fail({properties.heat->place, "lets heat through contacts, which those of parcels are not", "contacts on", "contacts off, or no coarseGraining"});
    }
}

} // namespace nscdCoupling
} // namespace Foam
