// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How wide cells are in which direction.
#include "boxMesh.H"

#include "coupling/mapping/mesh/cellShape.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

// Leaning cells: between the planes of a pair of faces they are as wide as these are apart, which is what a box has.
TEST(CellShape, leaningCellsAreAsWideAsTheirFacesAreApart)
{
    const scalar lean = 2.75, dx = 0.25, dz = 0.1;
    BoxMeshSettings settings;
    settings.cells = labelVector(4, 2, 10);
    settings.patchTypes = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    settings.movePoint = [lean](const point& p) { return p + vector(lean*p.z(), 0, 0); };
    BoxMesh box(settings);
    const surfaceScalarField across(acrossCells(box.mesh()));
    const surfaceVectorField normals(box.mesh().Sf()/box.mesh().magSf());
    const auto expected = [&](const vector& n) { return mag(n.z()) > 0.999 ? dz : mag(n.y()) > 0.999 ? 0.5 : dx/std::sqrt(1 + sqr(lean)); };
    forAll(across, faceI) EXPECT_NEAR(across[faceI], expected(normals[faceI]), 1e-12);
    forAll(across.boundaryField(), patchI)
    {
        const fvsPatchScalarField& patch = across.boundaryField()[patchI];
        forAll(patch, k) EXPECT_NEAR(patch[k], expected(normals.boundaryField()[patchI][k]), 1e-12) << patchI;
    }
}

TEST(CellShape, cellsOfA2DMeshAreAsWideAsTheyAre)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(5, 2, 1);
    settings.max = point(1, 0.1, 0.001);
    settings.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    BoxMesh box(settings);
    const surfaceScalarField across(acrossCells(box.mesh()));
    forAll(across, faceI) EXPECT_NEAR(across[faceI], mag(box.mesh().Sf()[faceI].x()) > 0 ? 0.2 : 0.05, 1e-12);
}

} // End anonymous namespace
