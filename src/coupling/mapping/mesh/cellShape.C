// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How wide cells are in which direction.
#include "coupling/mapping/mesh/cellShape.H"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "linear.H"
#include "volFields.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

/// int x x^T dV over a tetrahedron of the origin and three corners; negative where they are ordered the other way.
symmTensor momentOf(const vector& a, const vector& b, const vector& c)
{
    return ((a ^ b) & c)/120*(sqr(a) + sqr(b) + sqr(c) + sqr(a + b + c));
}

/// The same over the pyramid of a face on a cell's center, as seen by the face's owner.
symmTensor momentOf(const face& corners, const pointField& points, const point& faceCenter, const point& cellCenter)
{
    symmTensor sum = Zero;
    forAll(corners, k) sum += momentOf(faceCenter - cellCenter, points[corners[k]] - cellCenter, points[corners.nextLabel(k)] - cellCenter);
    return sum;
}

/// M of each cell [m2].
volSymmTensorField cellVariances(const fvMesh& mesh)
{
    volSymmTensorField variances(IOobject("cellVariance", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false), mesh,
        dimensionedSymmTensor(dimArea, Zero), extrapolatedCalculatedFvPatchSymmTensorField::typeName);
    symmTensorField& of = variances.primitiveFieldRef();
    const pointField& points = mesh.points();
    forAll(mesh.faces(), faceI)
    {
        const label owner = mesh.faceOwner()[faceI];
        of[owner] += momentOf(mesh.faces()[faceI], points, mesh.faceCentres()[faceI], mesh.cellCentres()[owner]);
        if (!mesh.isInternalFace(faceI)) continue;
        const label neighbor = mesh.faceNeighbour()[faceI];
        of[neighbor] -= momentOf(mesh.faces()[faceI], points, mesh.faceCentres()[faceI], mesh.cellCentres()[neighbor]);
    }
    of /= mesh.V().field();
    variances.correctBoundaryConditions();
    return variances;
}

} // namespace

surfaceScalarField acrossCells(const fvMesh& mesh)
{
    const surfaceVectorField normals(mesh.Sf()/mesh.magSf());
    return sqrt(12*mag(normals & (linearInterpolate(cellVariances(mesh)) & normals)));
}

} // namespace nscdCoupling
} // namespace Foam
