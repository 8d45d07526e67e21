// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The box mesh itself: cells, volumes, sides, cyclic pairs, an equation solved on it, and errors as exceptions.

#include "boxMesh.H"

#include "cyclicPolyPatch.H"
#include "fvCFD.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam::nscdCoupling::testing;

BoxMeshSettings flatBox()
{
    BoxMeshSettings settings;
    settings.cells = Foam::labelVector(5, 4, 3);
    settings.min = Foam::point(-1, 0, 2);
    settings.max = Foam::point(1, 1, 5);
    return settings;
}

TEST(boxMesh, hasTheCellsVolumesAndSidesAskedFor)
{
    BoxMesh box(flatBox());
    Foam::fvMesh& mesh = box.mesh();

    EXPECT_EQ(mesh.nCells(), 60);
    EXPECT_EQ(mesh.nInternalFaces(), 4*4*3 + 5*3*3 + 5*4*2);
    EXPECT_NEAR(Foam::sum(mesh.V()).value(), 6, 1e-13);
    EXPECT_NEAR(Foam::min(mesh.V()).value(), 0.1, 1e-14);
    EXPECT_FALSE(mesh.checkMesh());

    const Foam::vector outward[] = {{-3, 0, 0}, {3, 0, 0}, {0, -6, 0}, {0, 6, 0}, {0, 0, -2}, {0, 0, 2}};
    const char* names[] = {"left", "right", "bottom", "top", "front", "back"};
    for (Foam::label side = 0; side < 6; ++side)
    {
        EXPECT_EQ(mesh.boundary()[side].name(), names[side]);
        EXPECT_NEAR(Foam::mag(Foam::sum(mesh.boundary()[side].Sf()) - outward[side]), 0, 1e-13);
    }
}

TEST(boxMesh, cyclicSidesMeetFaceByFaceAndPointByPoint)
{
    BoxMeshSettings settings = flatBox();
    settings.patchTypes = {"cyclic", "cyclic", "cyclic", "cyclic", "cyclic", "cyclic"};
    BoxMesh box(settings);

    for (const char* name : {"left", "bottom", "front"})
    {
        const auto& patch = Foam::refCast<const Foam::cyclicPolyPatch>(box.mesh().boundaryMesh()[name]);
        const Foam::vector across = patch.neighbPatch().faceCentres()[0] - patch.faceCentres()[0];
        EXPECT_TRUE(patch.parallel());
        for (const Foam::edge& pair : patch.coupledPoints())
        {
            const Foam::vector d = patch.neighbPatch().localPoints()[pair[1]] - patch.localPoints()[pair[0]];
            EXPECT_NEAR(Foam::mag(d - across), 0, 1e-13);
        }
    }
}

// laplacian(T) = 0 between T = -1 and T = 1 is linear, whatever the (graded) spacing of the cells.
TEST(boxMesh, solvesAnEquationWithItsSchemesAndSolver)
{
    BoxMeshSettings settings = flatBox();
    settings.patchTypes = {"patch", "patch", "empty", "empty", "empty", "empty"};
    settings.cells = Foam::labelVector(6, 1, 1);
    settings.movePoint = [](const Foam::point& p) { return Foam::point(0.5*p.x()*(1 + p.x()*p.x()), p.y(), p.z()); };
    BoxMesh box(settings);
    Foam::fvMesh& mesh = box.mesh();

    Foam::volScalarField T
    (
        Foam::IOobject("T", box.time().timeName(), mesh),
        mesh,
        Foam::dimensionedScalar("T", Foam::dimless, 0),
        Foam::wordList({"fixedValue", "fixedValue", "empty", "empty", "empty", "empty"})
    );
    T.boundaryFieldRef()[0] == -1;
    T.boundaryFieldRef()[1] == 1;
    Foam::fvScalarMatrix(Foam::fvm::laplacian(T)).solve();

    forAll(T, celli) EXPECT_NEAR(T[celli], mesh.C()[celli].x(), 1e-12);
}

TEST(boxMesh, errorsOfOpenFOAMAreCaughtWithTheirText)
{
    BoxMesh box;
    box.writeFile("constant/someDict", "word notANumber;");
    const std::string message = errorMessage
    (
        [&]
        {
            Foam::IOdictionary dict
            (
                Foam::IOobject("someDict", "constant", box.mesh(), Foam::IOobject::MUST_READ, Foam::IOobject::NO_WRITE)
            );
            dict.get<Foam::scalar>("missing");
        }
    );
    EXPECT_NE(message.find("missing"), std::string::npos);
    EXPECT_EQ(errorMessage([] {}), "");
}

} // End anonymous namespace
