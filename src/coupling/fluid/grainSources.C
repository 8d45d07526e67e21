// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The grains' cell fields: made, aged, and completed on the patches.

#include "coupling/fluid/grainSources.H"
#include "coupling/fluid/rankPatches.H"

#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

template<class Type>
GeometricField<Type, fvPatchField, volMesh> zeroField
(
    const fvMesh& mesh, const word& name, const dimensionSet& dimensions
)
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}

} // End anonymous namespace


GrainSources::GrainSources(const fvMesh& mesh)
:
    fluidFraction
    (
        IOobject("alpha.fluid", mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    drag(zeroField<scalar>(mesh, "grainDrag", dimless/dimTime)),
    acceleration(zeroField<vector>(mesh, "grainAcceleration", dimAcceleration)),
    pressure(zeroField<scalar>(mesh, "grainPressure", dimless)),
    carried(zeroField<vector>(mesh, "grainCarried", dimVelocity)),
    slip(zeroField<scalar>(mesh, "grainSlip", dimless)),
    mobility(zeroField<scalar>(mesh, "grainMobility", dimTime))
{
    fillRankPatches(fluidFraction);
}


void GrainSources::beginStep()
{
    fluidFraction.oldTime();
}


void GrainSources::clear()
{
    fluidFraction.primitiveFieldRef() = 1;
    for (volScalarField* field : {&drag, &pressure, &slip, &mobility}) field->primitiveFieldRef() = 0;
    acceleration.primitiveFieldRef() = Zero;
    carried.primitiveFieldRef() = Zero;
    correctBoundaryConditions();
}


void GrainSources::correctBoundaryConditions()
{
    fluidFraction.correctBoundaryConditions();
    drag.correctBoundaryConditions();
    acceleration.correctBoundaryConditions();
    if (!hasResponse) return;

    pressure.correctBoundaryConditions();
    carried.correctBoundaryConditions();
    slip.correctBoundaryConditions();
    mobility.correctBoundaryConditions();
}

} // End namespace nscdCoupling
} // End namespace Foam
