// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Choosing the forces of a run, and adding them up.
#include "coupling/step/forces/grainForces.H"

#include "coupling/step/forces/forceTable.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

bool isOn(const ForceRow& row, const ForceSettings& settings, const ForceConditions& conditions)
{
    const bool lacks =
        (row.needs & needs::fluid && !conditions.hasFluid)
     || (row.needs & needs::dragLaw && !settings.isOn("drag"))
     || (row.needs & needs::turning && !conditions.canTurn);
    return !lacks && (!row.isSwitched || settings.isOn(row.name));
}

void refuseDiscs(const ForceRow& row, const ForceSettings& settings)
{
    fail({settings.switches.at(row.name).place, "is a law for spheres, and the grains of this case are discs", "on", "off"});
}

/// Published for spheres; in the plane the force on the mean would be shared out otherwise.
void refuseMixOfDiscs(const DragSettings& drag)
{
    fail({drag.polydispersePlace, "is for spheres, and the grains of this case are discs", "on", "off"});
}

/// To add to -0 gives what is added to the last bit, the sign of a zero included.
std::vector<Vec3> emptySums(std::size_t n) { return std::vector<Vec3>(n, Vec3::Constant(-0.0)); }

LinearDrag zeroDrag(std::size_t n)
{
    LinearDrag drag;
    drag.implicit.assign(n, 0.0);
    drag.remainder.assign(n, 0.0);
    return drag;
}

void setVelocityFactor(LinearDrag& drag, const ::nscd::Grains& grains, scalar deltaT)
{
    drag.velocityFactor.resize(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        drag.velocityFactor[i] = grains.mass[i]/(grains.mass[i] + drag.implicit[i]*deltaT);
    }
}

/// Velocity change of each owned grain per force on it over the step [m/(s N)].
std::vector<scalar> gains(const ::nscd::Grains& grains, const LinearDrag& drag, scalar deltaT)
{
    std::vector<scalar> gain(grains.nOwned);
    for (std::size_t i = 0; i < gain.size(); ++i)
    {
        const scalar implicit = drag.implicit.empty() ? 0 : drag.implicit[i];
        gain[i] = deltaT/(grains.mass[i] + implicit*deltaT);
    }
    return gain;
}

} // namespace

GrainForces::GrainForces(const ForceSettings& settings, const ForceConditions& conditions)
{
    if (settings.drag.isPolydisperse && !conditions.areSpheres) refuseMixOfDiscs(settings.drag);
    for (const ForceRow& row : forceTable())
    {
        if (!isOn(row, settings, conditions)) continue;
        if (row.needs & needs::spheres && !conditions.areSpheres) refuseDiscs(row, settings);
        forces_.push_back(row.make(settings));
    }
}

unsigned GrainForces::readsAtStart() const
{
    unsigned all = reads::nothing;
    for (const GrainForce& force : forces_) all |= force.reads;
    return all;
}

unsigned GrainForces::readsAfterSolve() const
{
    unsigned all = reads::nothing;
    for (const GrainForce& force : forces_)
    {
        if (force.addSteady || force.addTorque) all |= force.reads;
    }
    return all;
}

bool GrainForces::followPressure() const
{
    return std::any_of(forces_.begin(), forces_.end(), [](const GrainForce& force) { return force.followsPressure; });
}

std::vector<Vec3> GrainForces::exchanged(const ForceInputs& in) const
{
    std::vector<Vec3> sum;
    for (const GrainForce& force : forces_)
    {
        if (!force.addExchanged) continue;
        if (sum.empty()) sum.assign(in.grains.size(), Vec3::Zero());
        force.addExchanged(in, sum);
    }
    return sum;
}

std::vector<Vec3> GrainForces::explicitForces(const ForceInputs& in, const std::vector<Vec3>& exchanged) const
{
    std::vector<Vec3> sum = emptySums(in.grains.size());
    for (const GrainForce& force : forces_)
    {
        if (force.addSteady) force.addSteady(in, sum);
    }
    for (std::size_t i = 0; i < exchanged.size(); ++i) sum[i] += exchanged[i];
    return sum;
}

LinearDrag GrainForces::linearize(const ForceInputs& in, const StepInputs& step) const
{
    LinearDrag drag = zeroDrag(in.grains.size());
    drag.deltaT = step.deltaT;
    for (const GrainForce& force : forces_)
    {
        if (force.linearize) force.linearize(in, step, drag);
    }
    drag.shareInertia(step.deltaT);
    setVelocityFactor(drag, in.grains, step.deltaT);
    return drag;
}

LinearDrag GrainForces::splitAgain(const ::nscd::Grains& grains, const LinearDrag& whole, scalar deltaT) const
{
    LinearDrag part = zeroDrag(grains.size());
    part.spin = whole.spin;
    part.addedMass = whole.addedMass;
    part.startFluid = whole.startFluid;
    part.deltaT = whole.deltaT;
    part.largestStiffness = whole.largestStiffness;
    for (const GrainForce& force : forces_)
    {
        if (force.splitAgain) force.splitAgain(grains, whole, deltaT, part);
    }
    part.shareInertia(deltaT);
    setVelocityFactor(part, grains, deltaT);
    return part;
}

::nscd::ExternalForces GrainForces::external
(
    const ForceInputs& in, const std::vector<Vec3>& force, const LinearDrag& drag
) const
{
    ::nscd::ExternalForces external;
    external.force = force;
    external.implicitDrag = drag.implicit;
    for (std::size_t i = 0; i < drag.implicit.size(); ++i)
    {
        const Vec3& u = in.at.velocity[i];
        external.force[i] += drag.implicit[i]*u + drag.remainder[i]*(u - in.grains.velocity[i]);
        if (!drag.addedMass.empty()) external.force[i] += drag.pull(i, u);
    }
    external.implicitSpinDrag = drag.spin;
    external.torque = emptySums(drag.spin.size());
    for (const GrainForce& each : forces_)
    {
        if (each.addTorque) each.addTorque(in, drag, external.torque);
    }
    return external;
}

scalar GrainForces::speedScale
(
    const ForceInputs& in, const std::vector<Vec3>& exchanged, const LinearDrag& drag, scalar deltaT,
    const ::nscd::Exchange& exchange
) const
{
    const std::vector<scalar> gain = gains(in.grains, drag, deltaT);
    std::vector<double> sums = {double(in.grains.nOwned), 0};
    for (std::size_t i = 0; i < std::min(gain.size(), exchanged.size()); ++i) sums[1] += sqr(gain[i])*exchanged[i].squaredNorm();
    for (const GrainForce& force : forces_)
    {
        if (force.sumSquares) sums.push_back(force.sumSquares(in, drag, gain));
    }
    exchange.sum(sums.data(), sums.size());
    return Foam::sqrt(*std::max_element(sums.begin() + 1, sums.end())/std::max(1.0, sums[0]));
}

} // namespace nscdCoupling
} // namespace Foam
