// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The wake, grain by grain.
#include "coupling/step/ownWake.H"

#include "closures/ownWake.hpp"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The flow that the opposite of the force makes in the grain's cells, at once and without inertia [m/s].
Vec3 stokesWake(const OwnTrace& own, std::size_t i, const Vec3& force, scalar viscosity)
{
    const Vec3& off = own.flowOffDiagonal[i];
    const Vec3 across(off[2]*force[1] + off[1]*force[2], off[2]*force[0] + off[0]*force[2], off[1]*force[0] + off[0]*force[1]);
    return -(own.flowDiagonal[i].cwiseProduct(force) + across)/viscosity;
}

/// Of a parcel's wake, what is its own to take out; 1 for single grains.
scalar shareOfParcel(const ForceInputs& in, std::size_t i, scalar length)
{
    const scalar coarseness = in.coarseness(i);
    return coarseness > 1 ? closures::wakeOfParcel(pow3(coarseness)*2*in.realRadius[i]/length) : 1;
}

} // namespace

scalar ownStressShare(const ForceSettings& settings)
{
    return (settings.isOn("pressureGradient") ? 1.0/3 : 0.0) + (settings.isOn("viscous") ? 2.0/3 : 0.0);
}

void followOwnWake
(
    const ForceInputs& in, const std::vector<Vec3>& fluidForce, scalar stressShare, scalar deltaT, FluidAtGrains& at,
    std::vector<Vec3>& wake
)
{
    const ::nscd::Grains& grains = in.grains;
    at.dragFactor.assign(grains.nOwned, 1.0);
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const scalar volume = grains.volume(i);
        // A grain outside the mesh has no cells of its own.
        const scalar length = at.own.fraction[i] > 0 ? std::cbrt(volume/at.own.fraction[i]) : GREAT;
        const scalar lone = at.own.fraction[i] > 0 ? closures::loneliness(at.own.others[i])*shareOfParcel(in, i, length) : 0;
        if (lone == 0)
        {
            wake[i] = Vec3::Zero();
            continue;
        }
        const scalar slip = (at.velocity[i] - (1 - closures::wakeTakenAlong)*wake[i] - grains.velocity[i]).norm();
        const scalar inertia = closures::wakeInertia(in.fluidDensity*slip*length/at.viscosity[i]);
        const Vec3 dynamic = fluidForce[i] + in.fluidDensity*volume*in.gravity;
        const Vec3 steady = lone*inertia*stokesWake(at.own, i, dynamic, at.viscosity[i]);
        const scalar time = closures::wakeTime(at.viscosity[i], in.fluidDensity, length, slip);
        wake[i] -= std::expm1(-deltaT/time)*(steady - wake[i]);
        at.fluidFraction[i] += lone*at.own.fraction[i];
        at.dragFactor[i] = 1 - lone*at.own.fraction[i]*stressShare;
    }
    at.ownWake = wake;
    removeOwnWake(at);
}

void removeOwnWake(FluidAtGrains& at)
{
    for (std::size_t i = 0; i < at.ownWake.size(); ++i) at.velocity[i] -= at.ownWake[i];
}

} // namespace nscdCoupling
} // namespace Foam
