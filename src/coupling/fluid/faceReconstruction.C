// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The least-squares reconstruction with its inverse kept.

#include "coupling/fluid/faceReconstruction.H"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

tmp<tensorField> inverseOf(const surfaceVectorField& normal)
{
    return inv(fvc::surfaceSum(normal*normal.mesh().Sf())().primitiveField());
}

} // End anonymous namespace


FaceReconstruction::FaceReconstruction(const fvMesh& mesh)
:
    mesh_(mesh),
    normal_("faceNormal", mesh.Sf()/mesh.magSf()),
    inverse_(inverseOf(normal_))
{}


void FaceReconstruction::follow()
{
    normal_ = mesh_.Sf()/mesh_.magSf();
    inverse_ = inverseOf(normal_);
}


tmp<volVectorField> FaceReconstruction::operator()(const surfaceScalarField& faceFlux) const
{
    tmp<volVectorField> cells
    (
        new volVectorField
        (
            IOobject("reconstruct(" + faceFlux.name() + ')', mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(faceFlux.dimensions()/dimArea, Zero),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    cells.ref().primitiveFieldRef() = inverse_ & fvc::surfaceSum(normal_*faceFlux)().primitiveField();
    cells.ref().correctBoundaryConditions();
    return cells;
}

} // End namespace nscdCoupling
} // End namespace Foam
