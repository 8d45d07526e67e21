// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The response, grain by grain.
#include "coupling/step/dragResponse.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The trial push against the speed scale of the step: well above the contact tolerance, well below what moves a bed.
constexpr scalar pushShare = 0.1;

} // namespace

TrialPush makeTrialPush
(
    const ::nscd::Grains& grains, const std::vector<Vec3>& force, const LinearDrag& drag, const FluidAtGrains& at,
    const ::nscd::ExternalForces& external, scalar deltaT
)
{
    TrialPush push{external, std::vector<Vec3>(grains.size(), Vec3::Zero()), pushShare*external.speedScale};
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar gamma = drag.implicit[i] + drag.remainder[i];
        push.direction[i] = (gamma*(at.velocity[i] - grains.velocity[i]) - force[i]).normalized();
        push.external.force[i] += push.speed/deltaT*grains.mass[i]/drag.velocityFactor[i]*push.direction[i];
    }
    return push;
}

std::vector<scalar> followedShare
(
    const TrialPush& push, const std::vector<Vec3>& force, const ::nscd::Prediction& before, const ::nscd::Prediction& after
)
{
    std::vector<scalar> share(push.direction.size(), 1.0);
    if (push.speed <= 0) return share;
    for (std::size_t i = 0; i < share.size(); ++i)
    {
        // A grain that meets none is free to the last digit; the quotient below would not say so.
        if (before.contactForce[i] == Vec3::Zero() && after.contactForce[i] == Vec3::Zero()) continue;
        const scalar followed = push.direction[i].dot(after.velocity[i] - before.velocity[i])/push.speed;
        const scalar unborne = 1.0 - before.contactForce[i].norm()/std::max(force[i].norm(), VSMALL);
        share[i] = std::max(0.0, std::min({1.0, followed, unborne}));
    }
    return share;
}

GrainResponse contactAwareResponse
(
    const ::nscd::Grains& grains, const LinearDrag& drag, const FluidAtGrains& at,
    const ::nscd::Prediction& prediction, const std::vector<scalar>& mobility, bool feelsPressure, scalar deltaT
)
{
    GrainResponse response;
    response.intercept = prediction.velocity;
    response.slip.assign(grains.size(), 0.0);
    response.mobility.assign(grains.size(), 0.0);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.isFixed[i]) continue;
        const scalar gain = mobility[i]*drag.velocityFactor[i]*deltaT/grains.mass[i];
        response.slip[i] = gain*(drag.implicit[i] + drag.remainder[i]);
        response.intercept[i] -= response.slip[i]*at.velocity[i];
        if (feelsPressure)
        {
            response.mobility[i] = gain*grains.volume(i);
            response.intercept[i] += response.mobility[i]*at.pressureGradient[i];
        }
        response.isZero = response.isZero && gain == 0;
    }
    return response;
}

::nscd::Prediction freePrediction
(
    const ::nscd::Grains& grains, const ::nscd::ExternalForces& external, scalar deltaT
)
{
    ::nscd::Prediction prediction;
    prediction.velocity = grains.velocity;
    prediction.contactForce.assign(grains.size(), Vec3::Zero());
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.isFixed[i]) continue;
        const scalar gamma = external.implicitDrag[i];
        prediction.velocity[i] = (grains.mass[i]*grains.velocity[i] + deltaT*external.force[i])/(grains.mass[i] + gamma*deltaT);
    }
    return prediction;
}

GrainResponse laggedResponse(const ::nscd::Grains& grains)
{
    return {grains.velocity, std::vector<scalar>(grains.size(), 0.0), std::vector<scalar>(grains.size(), 0.0), true};
}

} // namespace nscdCoupling
} // namespace Foam
