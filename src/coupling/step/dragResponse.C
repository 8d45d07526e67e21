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

/// s of a touched grain; exchange: gamma dt [kg].
scalar boundedSlip(scalar slip, const ForceInputs& in, scalar exchange, std::size_t i)
{
    if (slip <= looseSlip) return slip;
    const scalar alpha = in.at.fluidFraction[i];
    const scalar fluidShare = in.fluidDensity*alpha*in.grains.volume(i)/std::max((1 - alpha)*exchange, VSMALL);
    return std::min(slip, looseSlip*(1 + fluidShare));
}

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

std::vector<Mobility> mobilities(const TrialPush& push, const ::nscd::Prediction& before, const ::nscd::Prediction& after)
{
    std::vector<Mobility> all(push.direction.size());
    if (push.speed <= 0) return all;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        // A grain that meets none is free to the last digit; the quotient below would not say so.
        all[i].isTouched = before.contactForce[i] != Vec3::Zero() || after.contactForce[i] != Vec3::Zero();
        if (!all[i].isTouched) continue;
        const scalar followed = push.direction[i].dot(after.velocity[i] - before.velocity[i])/push.speed;
        all[i].share = std::max(0.0, std::min(1.0, followed));
    }
    return all;
}

GrainResponse contactAwareResponse
(
    const ForceInputs& in, const LinearDrag& drag, const ::nscd::Prediction& prediction, const std::vector<Mobility>& mobility,
    bool feelsPressure, scalar deltaT
)
{
    const ::nscd::Grains& grains = in.grains;
    GrainResponse response;
    response.intercept = prediction.velocity;
    response.slip.assign(grains.size(), 0.0);
    response.mobility.assign(grains.size(), 0.0);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.isFixed[i]) continue;
        const scalar gain = mobility[i].share*drag.velocityFactor[i]*deltaT/grains.mass[i];
        const scalar gamma = drag.fluidCoefficient(i);
        response.slip[i] = gain*gamma;
        if (mobility[i].isTouched) response.slip[i] = boundedSlip(response.slip[i], in, gamma*deltaT, i);
        response.intercept[i] -= response.slip[i]*in.at.velocity[i];
        if (feelsPressure)
        {
            response.mobility[i] = gain*grains.volume(i);
            response.intercept[i] += response.mobility[i]*in.at.pressureGradient[i];
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
