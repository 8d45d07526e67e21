// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sums over the grains of all ranks.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/log/grainTotals.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

GrainTotals sumGrains(const nscd::Grains& grains, const nscd::Exchange& exchange)
{
    nscd::Vec3 moment = nscd::Vec3::Zero();
    double mass = 0, diameters = 0;
    double radii[2] = {-GREAT, 0};  // the least, negative, and the largest
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        moment += grains.mass[i]*grains.position[i];
        mass += grains.mass[i];
        diameters += 2*grains.radius[i];
        radii[0] = std::max(radii[0], -grains.radius[i]);
        radii[1] = std::max(radii[1], grains.radius[i]);
    }
    double sums[] =
    {
        double(grains.nOwned), mass, totalVolume(grains), kineticEnergy(grains), moment.x(), moment.y(), moment.z(),
        diameters
    };
    exchange.sum(sums, 8);
    exchange.max(radii, 2);

    GrainTotals totals;
    totals.number = static_cast<std::int64_t>(sums[0]);
    totals.mass = sums[1];
    totals.volume = sums[2];
    totals.kineticEnergy = sums[3];
    if (totals.mass > 0) totals.massCenter = vector(sums[4], sums[5], sums[6])/totals.mass;
    if (totals.number > 0)
    {
        totals.diameterMean = sums[7]/sums[0];
        totals.diameterMin = -2*radii[0];
    }
    totals.diameterMax = 2*radii[1];
    return totals;
}

} // namespace nscdCoupling
} // namespace Foam
