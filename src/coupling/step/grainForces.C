// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Weight, buoyancy, pressure gradient and viscous stress.
#include "coupling/step/grainForces.H"

#include "coupling/base/vectorConversion.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

std::vector<Vec3> steadyForces
(
    const ::nscd::Grains& grains, const FluidAtGrains& at, const ActiveForces& active, scalar fluidDensity, const vector& gravity
)
{
    const Vec3 g = toVec3(gravity);
    std::vector<Vec3> force(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) force[i] = (grains.mass[i] - fluidDensity*grains.volume(i))*g;
    if (active.pressureGradient)
    {
        for (std::size_t i = 0; i < grains.size(); ++i) force[i] -= grains.volume(i)*at.pressureGradient[i];
    }
    if (active.viscous)
    {
        for (std::size_t i = 0; i < grains.size(); ++i) force[i] += grains.volume(i)*at.divTau[i];
    }
    return force;
}

scalar speedScale
(
    const ::nscd::Grains& grains, const FluidAtGrains& at, const std::vector<scalar>& implicitDrag,
    const std::vector<scalar>& remainder, scalar fluidDensity, const vector& gravity, scalar deltaT,
    const ::nscd::Exchange& exchange
)
{
    scalar weight2 = 0, pressure2 = 0, viscous2 = 0, drag2 = 0;
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const scalar gamma = implicitDrag.empty() ? 0 : implicitDrag[i];
        const scalar gain = deltaT/(grains.mass[i] + gamma*deltaT);
        weight2 += sqr(gain*(grains.mass[i] - fluidDensity*grains.volume(i)))*magSqr(gravity);
        if (!at.pressureGradient.empty()) pressure2 += sqr(gain*grains.volume(i))*at.pressureGradient[i].squaredNorm();
        if (!at.divTau.empty()) viscous2 += sqr(gain*grains.volume(i))*at.divTau[i].squaredNorm();
        if (!implicitDrag.empty())
        {
            drag2 += sqr(gain*(gamma + remainder[i]))*(at.velocity[i] - grains.velocity[i]).squaredNorm();
        }
    }
    double sums[] = {weight2, pressure2, viscous2, drag2, double(grains.nOwned)};
    exchange.sum(sums, 5);
    return Foam::sqrt(*std::max_element(sums, sums + 4)/std::max(1.0, sums[4]));
}

} // namespace nscdCoupling
} // namespace Foam
