// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Reading the fluid's fields, or making those that a fresh start does not have.

#include "coupling/fluid/fluidFields.H"
#include "coupling/fluid/rankPatches.H"

#include "fvcFlux.H"
#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

IOobject stored(const fvMesh& mesh, const word& name, const IOobject::readOption reading)
{
    return IOobject(name, mesh.time().timeName(), mesh, reading, IOobject::AUTO_WRITE);
}

volVectorField zeroOrRead(const fvMesh& mesh, const word& name, const dimensionSet& dimensions)
{
    return volVectorField
    (
        stored(mesh, name, IOobject::READ_IF_PRESENT),
        mesh,
        dimensionedVector(dimensions, Zero),
        zeroGradientFvPatchVectorField::typeName
    );
}

bool isStored(const fvMesh& mesh, const word& name)
{
    return stored(mesh, name, IOobject::READ_IF_PRESENT).typeHeaderOk<volVectorField>(true);
}

} // End anonymous namespace


FluidFields::FluidFields(const fvMesh& mesh, const volScalarField& fluidFraction)
:
    U(stored(mesh, "U", IOobject::MUST_READ), mesh),
    pRgh(stored(mesh, "p_rgh", IOobject::MUST_READ), mesh),
    phi(stored(mesh, "phi", IOobject::READ_IF_PRESENT), (fillRankPatches(U), fvc::flux(fluidFraction*U))),
    balancedGradient(zeroOrRead(mesh, "balancedGradient", dimPressure/dimLength)),
    divTau(zeroOrRead(mesh, "divTau", dimForce/dimVolume))
{
    mesh.setFluxRequired(pRgh.name());
    if (isStored(mesh, "bodyAcceleration")) bodyAccelerationOf(*this);
}


void keepFaceVelocity(FluidFields& fields, const volScalarField& fluidFraction)
{
    const fvMesh& mesh = fields.U.mesh();
    const surfaceVectorField normal(mesh.Sf()/mesh.magSf());
    tmp<surfaceVectorField> velocity(fvc::interpolate(fluidFraction*fields.U, "flux(HbyA)"));
    velocity.ref() += normal*(fields.phi/mesh.magSf() - (normal & velocity()));
    if (fields.faceVelocity.valid()) fields.faceVelocity() = velocity;
    else fields.faceVelocity.reset(new surfaceVectorField("faceVelocity", velocity));
    fields.faceVelocity().oldTime() = fields.faceVelocity();   // made within the step: what it begins with
}


void fluxThroughMovedFaces(FluidFields& fields)
{
    fields.phi = fields.U.mesh().Sf() & fields.faceVelocity();
}


volVectorField& bodyAccelerationOf(FluidFields& fields)
{
    if (!fields.bodyAcceleration.valid())
    {
        fields.bodyAcceleration.reset
        (
            new volVectorField(zeroOrRead(fields.U.mesh(), "bodyAcceleration", dimAcceleration))
        );
    }
    return fields.bodyAcceleration();
}

} // End namespace nscdCoupling
} // End namespace Foam
