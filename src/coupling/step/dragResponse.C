// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Linear drag and response, grain by grain.
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

closures::GrainSize sizeOf(const ::nscd::Grains& grains, std::size_t i)
{
    return grains.shape.dimensions == 2
        ? closures::discSize(2*grains.radius[i], grains.shape.thickness)
        : closures::sphereSize(2*grains.radius[i]);
}

scalar dragCoefficient
(
    const ::nscd::Grains& grains, const FluidAtGrains& at, std::size_t i, const Vec3& force, bool isFree,
    const DragModel& model, scalar deltaT
)
{
    closures::DragState state;
    state.size = sizeOf(grains, i);
    state.slip = (at.velocity[i] - grains.velocity[i]).norm();
    state.fluidFraction = at.fluidFraction[i];
    state.density = model.fluidDensity;
    state.viscosity = at.viscosity[i];
    if (!isFree) return model.law(state);
    const closures::DragStep step{at.velocity[i], force, grains.mass[i], deltaT};
    return closures::gammaAtMidSlip(model.law, state, step, grains.velocity[i], model.weighting);
}

scalar spinDrag(const ::nscd::Grains& grains, std::size_t i, scalar viscosity)
{
    return grains.shape.dimensions == 2
        ? closures::discSpinDrag(2*grains.radius[i], grains.shape.thickness, viscosity)
        : closures::sphereSpinDrag(2*grains.radius[i], viscosity);
}

void setSplit
(
    LinearDrag& drag, std::size_t i, scalar gamma, scalar mass, closures::DragWeighting weighting, scalar deltaT
)
{
    const closures::DragSplit split = closures::splitDrag(gamma, mass, deltaT, weighting);
    drag.implicit[i] = split.implicit;
    drag.remainder[i] = split.remainder;
    drag.velocityFactor[i] = mass/(mass + split.implicit*deltaT);
}

} // namespace

LinearDrag noDrag(const ::nscd::Grains& grains)
{
    LinearDrag drag;
    drag.implicit.assign(grains.size(), 0.0);
    drag.remainder.assign(grains.size(), 0.0);
    drag.velocityFactor.assign(grains.size(), 1.0);
    return drag;
}

LinearDrag splitAgain(const ::nscd::Grains& grains, const LinearDrag& drag, closures::DragWeighting weighting, scalar deltaT)
{
    LinearDrag shorter = drag;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        setSplit(shorter, i, drag.implicit[i] + drag.remainder[i], grains.mass[i], weighting, deltaT);
    }
    return shorter;
}

LinearDrag linearizeDrag
(
    const ::nscd::Grains& grains, const FluidAtGrains& at, const std::vector<Vec3>& force,
    const std::vector<Vec3>& lastContactForce, const DragModel& model, scalar deltaT
)
{
    LinearDrag drag = noDrag(grains);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const bool isFree = !grains.isFixed[i] && lastContactForce[i] == Vec3::Zero();
        const scalar gamma = dragCoefficient(grains, at, i, force[i], isFree, model, deltaT);
        setSplit(drag, i, gamma, grains.mass[i], model.weighting, deltaT);
        if (!grains.isFixed[i]) drag.largestStiffness = std::max(drag.largestStiffness, gamma*deltaT/grains.mass[i]);
    }
    if (!model.hasSpinDrag) return drag;
    drag.spin.resize(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) drag.spin[i] = spinDrag(grains, i, at.viscosity[i]);
    return drag;
}

::nscd::ExternalForces externalForces
(
    const ::nscd::Grains& grains, const std::vector<Vec3>& force, const LinearDrag& drag, const FluidAtGrains& at
)
{
    ::nscd::ExternalForces external;
    external.force = force;
    external.implicitDrag = drag.implicit;
    for (std::size_t i = 0; i < drag.implicit.size(); ++i)
    {
        external.force[i] += drag.implicit[i]*at.velocity[i] + drag.remainder[i]*(at.velocity[i] - grains.velocity[i]);
    }
    external.implicitSpinDrag = drag.spin;
    external.torque.resize(drag.spin.size());
    for (std::size_t i = 0; i < drag.spin.size(); ++i) external.torque[i] = drag.spin[i]*at.spin[i];
    return external;
}

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
