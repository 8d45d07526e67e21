// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The field's parts, grain by grain.
#include "coupling/step/forceField.H"

#include "coupling/case/input/inputError.H"
#include "coupling/case/walls/patchRoles.H"

#include "volFields.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const dimensionSet dimForceDensity(dimForce/dimVolume);

::nscd::VectorOfTime integralOrNone(const ::nscd::VectorOfTime& function)
{
    return function ? ::nscd::integralOf(function) : ::nscd::VectorOfTime();
}

/// Mean of a function over a step, from its integral; zero where there is none.
Vec3 meanOf(const ::nscd::VectorOfTime& integral, scalar begin, scalar end)
{
    return integral ? Vec3((integral(end) - integral(begin))/(end - begin)) : Vec3(Vec3::Zero());
}

void readAndRegister(const word& name, const fvMesh& mesh, const Place& place)
{
    IOobject file(name, mesh.time().timeName(), mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE);
    if (!returnReduce(IOobject(file).typeHeaderOk<volVectorField>(true), andOp<bool>()))
    {
        const string allowed = "a volVectorField in the folder of the start time, or one that is registered with the mesh, as bodyAcceleration";
        fail({place, "names a field that is not there", name, allowed});
    }
    regIOobject::store(new volVectorField(file, mesh));
}

} // namespace


ForceField::ForceField(const FieldSettings& settings, const fvMesh& mesh)
:
    settings_(settings),
    mesh_(mesh),
    velocity_(integralOrNone(settings.acceleration)),
    impulse_(integralOrNone(settings.forceDensity))
{
    for (const std::string& name : settings_.fields)
    {
        if (!mesh.foundObject<volVectorField>(name)) readAndRegister(name, mesh, settings_.fieldsPlace);
        const dimensionSet& dimensions = mesh.lookupObject<volVectorField>(name).dimensions();
        if (dimensions == dimAcceleration || dimensions == dimForceDensity) continue;
        fail({settings_.fieldsPlace, "names a field of other dimensions: " + name, messageText(dimensions), "[0 1 -2 0 0 0 0] or [1 -2 -2 0 0 0 0]"});
    }
}


void ForceField::addFields
(
    const ::nscd::Grains& grains, const GrainMapping& mapping, const GrainsAtHome& atHome, std::vector<Vec3>& force
) const
{
    const int empty = emptyAxis(mesh_);
    for (const std::string& name : settings_.fields)
    {
        const volVectorField& field = mesh_.lookupObject<volVectorField>(name);
        const bool isAcceleration = field.dimensions() == dimAcceleration;
        std::vector<Vec3> atGrains;
        mapping.sample(field.primitiveField(), atGrains);
        atHome.toOwners({{}, {&atGrains}});
        for (std::size_t i = 0; i < force.size(); ++i)
        {
            if (empty >= 0) atGrains[i][empty] = 0;
            force[i] += (isAcceleration ? grains.mass[i] : grains.volume(i))*atGrains[i];
        }
    }
}


std::vector<Vec3> ForceField::onGrains
(
    const ::nscd::Grains& grains, scalar begin, scalar end, const GrainMapping* mapping, const GrainsAtHome* atHome
) const
{
    const Vec3 acceleration = meanOf(velocity_, begin, end), density = meanOf(impulse_, begin, end);
    std::vector<Vec3> force(grains.nOwned);
    for (std::size_t i = 0; i < force.size(); ++i) force[i] = grains.mass[i]*acceleration + grains.volume(i)*density;
    if (!settings_.fields.empty()) addFields(grains, *mapping, *atHome, force);
    return force;
}

} // namespace nscdCoupling
} // namespace Foam
