// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The cells of grains in a run without fluid, against a look at all cells.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/step/grainLocations.H"
#include "mappingTools.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// The cell that holds a position, -1 for none.
label cellOf(const fvMesh& mesh, const Vec3& x)
{
    for (label cell = 0; cell < mesh.nCells(); ++cell)
    {
        if (isInCell(mesh, cell, toFoam(x))) return cell;
    }
    return -1;
}

} // namespace

TEST(GrainLocations, followGrainsThroughTheMeshAndOutOfIt)
{
    BoxMeshSettings settings = unitCells(labelVector(5, 4, 3));
    shake(settings, 0.2);
    BoxMesh box(settings);
    GrainLocations locations(box.mesh());
    ::nscd::Grains grains = makeGrains(randomPoints(50, Vec3(0, 0, 0), Vec3(5, 4, 3)), 0.1);
    for (int step = 0; step < 5; ++step)
    {
        const std::vector<label> cells = locations.update(grains);
        ASSERT_EQ(cells.size(), grains.size());
        label outside = 0;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            EXPECT_EQ(cells[i], cellOf(box.mesh(), grains.position[i])) << step << ' ' << i;
            outside += cells[i] < 0;
        }
        EXPECT_EQ(outside > 0, step > 0);
        for (std::size_t i = 0; i < grains.size(); ++i) grains.position[i] += 0.3*Vec3(1, -0.5, i % 2 ? 1 : -1);
        eraseGrains(grains, {0, 7});
        locations.erase({0, 7});
    }
}
