// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The cell of a point, against a search through all cells.

#include "mappingTools.H"

#include "coupling/mapping/mesh/nearestBorder.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

label bruteForceCell(const fvMesh& mesh, const Vec3& x)
{
    for (label cellI = 0; cellI < mesh.nCells(); ++cellI)
    {
        if (isInCell(mesh, cellI, toFoam(x))) return cellI;
    }
    return -1;
}

TEST(mappingLocator, findsTheCellsOfAShakenMesh)
{
    BoxMeshSettings settings = unitCells(labelVector(6, 5, 7));
    shake(settings, 0.2);
    BoxMesh box(settings);
    const MappingMesh mappingMesh = makeMappingMesh(box.mesh());
    const CellLocator locator(mappingMesh, box.mesh());

    label guess = -1, nearby = -1;
    for (const Vec3& x : randomPoints(2000, Vec3(0, 0, 0), Vec3(6, 5, 7)))
    {
        const label expected = bruteForceCell(box.mesh(), x);
        EXPECT_EQ(locator.find(x, -1), expected);
        EXPECT_EQ(locator.find(x, -1, nearby), expected);
        EXPECT_EQ(nearby, expected);
        guess = locator.find(x, guess);
        EXPECT_EQ(guess, expected);
    }
}

TEST(mappingLocator, givesPointsOnFacesAndBordersToACellTheyTouch)
{
    BoxMesh box(unitCells(labelVector(3, 3, 3)));
    const MappingMesh mappingMesh = makeMappingMesh(box.mesh());
    const CellLocator locator(mappingMesh, box.mesh());
    for (int corner = 0; corner < 64; ++corner)
    {
        const Vec3 x(corner % 4, corner/4 % 4, corner/16);
        for (const label guess : {-1, 0, 13, 26})
        {
            const label cell = locator.find(x, guess);
            ASSERT_GE(cell, 0) << x.transpose();
            EXPECT_LT((x - toVec3(box.mesh().cellCentres()[cell])).cwiseAbs().maxCoeff(), 0.5 + 1e-12);
        }
    }
}

TEST(mappingLocator, saysWhoIsOutside)
{
    BoxMesh box(unitCells(labelVector(3, 3, 3)));
    GrainMapping mapping(box.mesh(), mappingDict("exact"));
    ::nscd::Grains grains = makeGrains({Vec3(1, 1, 1), Vec3(3.01, 1, 1), Vec3(2, 2, 2), Vec3(1, -50, 1)}, 0.2);
    const MappingReport& report = mapping.update(grains, {});
    EXPECT_EQ(report.outsideMesh, (std::vector<std::int64_t>{101, 103}));
    EXPECT_NEAR(report.volumeDeposited, 2*grains.volume(0), 1e-15);
    std::vector<scalar> sampled;
    mapping.sample(scalarField(27, 5.0), sampled);
    EXPECT_EQ(sampled[1], 0);
    EXPECT_NEAR(sampled[2], 5, 1e-14);

    grains.position[1] = Vec3(2.99, 1, 1);
    EXPECT_EQ(mapping.update(grains, {}).outsideMesh, (std::vector<std::int64_t>{103}));
}

BorderFace nearestOfAllFaces(const polyMesh& mesh, const point& x)
{
    BorderFace nearest;
    for (label face = mesh.nInternalFaces(); face < mesh.nFaces(); ++face)
    {
        const scalar distance = mesh.faces()[face].nearestPoint(x, mesh.points()).distance();
        if (distance < nearest.distance) nearest = {distance, face};
    }
    return nearest;
}

// Inside of the mesh, beside it and far from it.
TEST(nearestBorder, isTheNearestOfAllFaces)
{
    BoxMeshSettings settings = unitCells(labelVector(5, 4, 3));
    shake(settings, 0.2);
    BoxMesh box(settings);
    for (const scalar around : {0.0, 1.0, 30.0})
    {
        const Vec3 more = Vec3::Constant(around);
        for (const Vec3& x : randomPoints(200, -more, Vec3(5, 4, 3) + more))
        {
            const BorderFace found = nearestBorder(box.mesh(), toFoam(x));
            const BorderFace expected = nearestOfAllFaces(box.mesh(), toFoam(x));
            EXPECT_EQ(found.face, expected.face) << x.transpose();
            EXPECT_EQ(found.distance, expected.distance) << x.transpose();
        }
    }
}

} // End anonymous namespace
