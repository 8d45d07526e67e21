// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sums.
#include "coupling/step/heatBalance.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

scalar heatCapacityOf(const HeatSettings& settings, const ::nscd::Grains& grains, std::size_t i)
{
    return grains.mass[i]*settings.materials[std::size_t(grains.material[i])].heatCapacity;
}


scalar HeatBalance::contentOf(const ::nscd::Grains& grains, const std::vector<scalar>& temperature) const
{
    double sum = 0;
    for (std::size_t i = 0; i < grains.nOwned; ++i) sum += heatCapacityOf(settings_, grains, i)*temperature[i];
    exchange_.sum(&sum, 1);
    return sum;
}


void HeatBalance::begin(const FluidEnergy& fluid, const ::nscd::Grains& grains, const std::vector<scalar>& temperature)
{
    here_ = HeatRow();
    fluidBefore_ = fluid.content();
    grainsBefore_ = contentOf(grains, temperature);
}


void HeatBalance::give(scalar heat, bool isHeld)
{
    here_.toGrains += heat;
    if (isHeld) here_.held += heat;
}


void HeatBalance::sumOverRanks(HeatRow& row, const std::vector<scalar>& temperature) const
{
    double sums[3] = {row.toGrains, row.held, row.entered};
    exchange_.sum(sums, 3);
    row.toGrains = sums[0];
    row.held = sums[1];
    row.entered = sums[2];
    double extremes[2] = {-GREAT, -GREAT};
    for (const scalar T : temperature)
    {
        extremes[0] = std::max(extremes[0], -T);
        extremes[1] = std::max(extremes[1], T);
    }
    exchange_.max(extremes, 2);
    if (extremes[1] < 0) return;
    row.grainMin = -extremes[0];
    row.grainMax = extremes[1];
}


HeatRow HeatBalance::close(const FluidEnergy& fluid, const ::nscd::Grains& grains, const std::vector<scalar>& temperature)
{
    HeatRow row = here_;
    here_ = HeatRow();
    sumOverRanks(row, temperature);
    row.fluid = fluid.content();
    row.grains = contentOf(grains, temperature);
    row.inflow = step_.inflow;
    row.shifted = (step_.before - fluidBefore_) + (row.fluid - step_.after);
    row.error = (row.fluid - fluidBefore_) + (row.grains - grainsBefore_) - row.inflow + row.held - row.entered - row.shifted;
    row.fluidMin = gMin(fluid.T().primitiveField());
    row.fluidMax = gMax(fluid.T().primitiveField());
    fluidBefore_ = row.fluid;
    grainsBefore_ = row.grains;
    return row;
}

} // namespace nscdCoupling
} // namespace Foam
