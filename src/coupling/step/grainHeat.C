// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The grains' conductances, and what each takes of the fluid.
#include "coupling/step/grainHeat.H"

#include "coupling/case/input/inputError.H"
#include "coupling/step/contactConduction.H"

#include "mathematicalConstants.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Above, temperatures within a grain differ by more than a tenth of what they differ from the fluid's.
constexpr scalar largestBiot = 0.1;

const HeatSettings& forSpheres(const HeatSettings& settings, const ::nscd::Grains& grains)
{
    if (grains.shape.dimensions == 3) return settings;
    fail({settings.place, "has laws for spheres, and the grains of this case are discs", "", "shape sphere; or no `heat`"});
}

} // namespace


GrainHeat::GrainHeat
(
    const HeatSettings& settings, FluidSolver& fluid, const volScalarField& fluidFraction, const ::nscd::Grains& grains,
    std::vector<scalar>& temperature, std::shared_ptr<::nscd::Exchange> exchange
)
:
    settings_(forSpheres(settings, grains)),
    fluid_(fluid),
    law_(closures::findNusseltLaw(settings.law)),
    energy_(fluid, fluidFraction, settings.fluid),
    temperature_(temperature),
    exchange_(std::move(exchange)),
    balance_(settings, *exchange_)
{
    startLift();
    welcome(grains);
    balance_.begin(energy_, grains, temperature_);
}


// The acceleration is made anew in every step; what a written time holds of it is the user's own.
void GrainHeat::startLift()
{
    if (settings_.fluid.expansion == 0) return;
    const fvMesh& mesh = energy_.T().mesh();
    const IOobject file("bodyAcceleration", mesh.time().timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    IOobject seen(file);
    if (seen.typeHeaderOk<volVectorField>(true))
    {
        fail({settings_.place, "has `expansion`, and the start time has a field bodyAcceleration, whose place it takes", "", "one of the two"});
    }
    fluid_.bodyAcceleration().writeOpt() = IOobject::NO_WRITE;
}


void GrainHeat::liftFluid()
{
    if (settings_.fluid.expansion == 0) return;
    volVectorField& acceleration = fluid_.bodyAcceleration();
    const scalarField rise(energy_.T().primitiveField() - settings_.fluid.reference);
    acceleration.primitiveFieldRef() = -settings_.fluid.expansion*rise*fluid_.gravity();
    acceleration.correctBoundaryConditions();
}


void GrainHeat::conduct(const ::nscd::GrainDynamics& dynamics, scalar contactDeltaT, scalar deltaT)
{
    if (!settings_.hasContacts) return;
    const ::nscd::Grains& grains = dynamics.grains();
    const std::vector<::nscd::GhostGrain>& ghosts = dynamics.ghostsInContacts();
    const ContactConduction network
    (
        settings_, grains, contactConductances(settings_, grains, ghosts, dynamics.contacts(), contactDeltaT), ghosts, *exchange_
    );
    const ConductedHeat conducted = network.over(temperature_, deltaT);
    for (std::size_t i = 0; i < temperature_.size(); ++i)
    {
        if (propertiesOf(grains, i).isHeld) balance_.hold(conducted.heat[i]);
        else temperature_[i] += conducted.heat[i]/heatCapacityOf(settings_, grains, i);
    }
    if (conducted.off <= 0) return;
    Info<< "  heat: temperatures along contacts did not converge, and single ones are off by up to " << conducted.off << " K" << nl;
}


const GrainHeatProperties& GrainHeat::propertiesOf(const ::nscd::Grains& grains, std::size_t i) const
{
    return settings_.materials[std::size_t(grains.material[i])];
}


void GrainHeat::welcome(const ::nscd::Grains& grains)
{
    for (std::size_t i = 0; i < temperature_.size(); ++i)
    {
        if (temperature_[i] != unknown) continue;
        temperature_[i] = propertiesOf(grains, i).temperature;
        balance_.enter(heatCapacityOf(settings_, grains, i)*temperature_[i]);
    }
}


void GrainHeat::dismiss(const ::nscd::Grains& grains, const std::vector<std::size_t>& gone)
{
    for (const std::size_t i : gone) balance_.enter(-heatCapacityOf(settings_, grains, i)*temperature_[i]);
}


closures::NusseltState GrainHeat::stateOf(const Vec3& velocity, scalar diameter, const FluidAtGrains& at, std::size_t i) const
{
    const scalar slip = (at.velocity[i] - velocity).norm(), viscosity = at.viscosity[i];
    return
    {
        fluid_.rho().value()*slip*diameter/viscosity,
        viscosity*settings_.fluid.heatCapacity/settings_.fluid.conductivity,
        at.fluidFraction[i]
    };
}


std::vector<scalar> GrainHeat::conductances
(
    const ::nscd::Grains& grains, const std::vector<scalar>& realRadius, const FluidAtGrains& at, scalar deltaT
)
{
    std::vector<scalar> conductance(grains.nOwned);
    scalar biot = 0;
    for (std::size_t i = 0; i < conductance.size(); ++i)
    {
        const scalar d = 2*realRadius[i];
        const scalar h = law_.law(stateOf(grains.velocity[i], d, at, i))*settings_.fluid.conductivity/d;
        const scalar whole = pow3(grains.radius[i]/realRadius[i])*h*constant::mathematical::pi*d*d;
        const GrainHeatProperties& properties = propertiesOf(grains, i);
        conductance[i] = properties.isHeld ? whole : closures::conductanceOverStep(whole, heatCapacityOf(settings_, grains, i), deltaT);
        if (properties.conductivity > 0) biot = std::max(biot, h*d/(6*properties.conductivity));
    }
    noteBiot(biot);
    return conductance;
}


void GrainHeat::noteBiot(scalar largest)
{
    if (isBiotNoted_) return;
    exchange_->max(&largest, 1);
    if (largest <= largestBiot) return;
    isBiotNoted_ = true;
    Info<< "  heat: a grain's Biot number h d/(6 k) is " << largest << ", above " << largestBiot
        << ": its inside lags behind the one temperature that it has here" << nl;
}


void GrainHeat::handOver(const std::vector<scalar>& conductance, const GrainMapping& mapping, const GrainsAtHome& atHome)
{
    std::vector<scalar> atHomes = conductance, given(conductance.size());
    for (std::size_t i = 0; i < given.size(); ++i) given[i] = conductance[i]*temperature_[i];
    atHome.toHomes({{&atHomes, &given}, {}});
    mapping.spread({{atHomes, energy_.conductance()}, {given, energy_.given()}}, {});
}


void GrainHeat::takeUp
(
    const ::nscd::Grains& grains, const std::vector<scalar>& conductance, const std::vector<scalar>& fluid, scalar deltaT
)
{
    for (std::size_t i = 0; i < conductance.size(); ++i)
    {
        // A grain without a cell, which samples nothing, gives and takes nothing.
        if (!(fluid[i] > 0)) continue;
        const scalar heat = deltaT*conductance[i]*(fluid[i] - temperature_[i]);
        const bool isHeld = propertiesOf(grains, i).isHeld;
        balance_.give(heat, isHeld);
        if (!isHeld) temperature_[i] += heat/heatCapacityOf(settings_, grains, i);
    }
}


void GrainHeat::solve
(
    const ::nscd::Grains& grains, const std::vector<scalar>& realRadius, const FluidAtGrains& at, const GrainMapping& mapping,
    const GrainsAtHome& atHome, scalar deltaT
)
{
    const std::vector<scalar> conductance = conductances(grains, realRadius, at, deltaT);
    handOver(conductance, mapping, atHome);
    balance_.solved(energy_.solve());
    std::vector<scalar> fluid;
    mapping.sample(energy_.T().primitiveField(), fluid);
    atHome.toOwners({{&fluid}, {}});
    takeUp(grains, conductance, fluid, deltaT);
}


void GrainHeat::solveFluidAlone()
{
    energy_.conductance() = 0;
    energy_.given() = 0;
    balance_.solved(energy_.solve());
}

} // namespace nscdCoupling
} // namespace Foam
