// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Reading the fluid's fields, or making those that a fresh start does not have.

#include "coupling/fluid/fluidFields.H"
#include "coupling/fluid/rankPatches.H"

#include "fvcFlux.H"
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
