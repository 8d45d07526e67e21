// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What grains find of themselves in cells of a unit side: alone, across faces, with others near, in a periodic box.
#include "mappingTools.H"

#include "closures/ownWake.hpp"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const scalar inCell = closures::flowInOwnCell(1, 0);
const scalar ahead = closures::flowInOtherCell(Vec3(0, 1, 0), 1, 0)(1, 1);
const scalar beside = closures::flowInOtherCell(Vec3(0, 1, 0), 1, 0)(0, 0);

OwnTrace traceIn(BoxMesh& box, const ::nscd::Grains& grains, const ::nscd::PeriodicBox& periodic = {}, scalar diffusion = 0)
{
    GrainMapping mapping(box.mesh(), mappingDict("exact", diffusion), 0.5);
    mapping.update(grains, periodic);
    return mapping.ownTrace();
}

void expectDiagonal(const OwnTrace& trace, std::size_t i, const Vec3& expected)
{
    EXPECT_LT((trace.flowDiagonal[i] - expected).norm(), 1e-13) << trace.flowDiagonal[i].transpose();
    EXPECT_LT(trace.flowOffDiagonal[i].norm(), 1e-14);
}

} // namespace

TEST(OwnTrace, aloneInACellAndAcrossAFace)
{
    BoxMesh box(unitCells(labelVector(5, 5, 5)));
    const ::nscd::Grains one = makeGrains({Vec3(2.5, 2.5, 2.5)}, 0.3);
    const OwnTrace inside = traceIn(box, one);
    EXPECT_NEAR(inside.fraction[0], one.volume(0), 1e-14);
    EXPECT_NEAR(inside.others[0], 0, 1e-14);
    expectDiagonal(inside, 0, closures::wakeInFraction(inside.fraction[0])*Vec3::Constant(inCell));

    const OwnTrace across = traceIn(box, makeGrains({Vec3(2.5, 2, 2.5)}, 0.3));
    EXPECT_NEAR(across.fraction[0], one.volume(0)/2, 1e-14);
    EXPECT_NEAR(across.others[0], 0, 1e-14);
    const Vec3 other(beside/2, ahead/2, beside/2);
    expectDiagonal(across, 0, closures::wakeInFraction(across.fraction[0])*(Vec3::Constant(inCell/2) + other));
}

TEST(OwnTrace, atACornerTheFlowIsTheSameAlongAllAxes)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4)));
    const OwnTrace trace = traceIn(box, makeGrains({Vec3(2, 2, 2)}, 0.3));
    EXPECT_NEAR(trace.others[0], 0, 1e-14);
    EXPECT_NEAR(trace.flowDiagonal[0].maxCoeff() - trace.flowDiagonal[0].minCoeff(), 0, 1e-14);
    EXPECT_LT(trace.flowOffDiagonal[0].norm(), 1e-14);
    EXPECT_LT(trace.flowDiagonal[0][0], inCell);
}

TEST(OwnTrace, overACyclicBorderAsInside)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4), allCyclic()));
    ::nscd::PeriodicBox periodic;
    periodic.length = Vec3(4, 4, 4);
    const OwnTrace inside = traceIn(box, makeGrains({Vec3(2.5, 2.1, 2.5)}, 0.3), periodic);
    const OwnTrace border = traceIn(box, makeGrains({Vec3(2.5, 0.1, 2.5)}, 0.3), periodic);
    expectDiagonal(border, 0, inside.flowDiagonal[0]);
    EXPECT_NEAR(border.fraction[0], inside.fraction[0], 1e-13);
}

TEST(OwnTrace, othersInTheCellOrBesideItCount)
{
    BoxMesh box(unitCells(labelVector(5, 5, 5)));
    const ::nscd::Grains grains = makeGrains({Vec3(2.5, 2.5, 2.5), Vec3(3.5, 2.5, 2.5), Vec3(0.5, 0.5, 0.5)}, 0.3);
    const scalar volume = grains.volume(0);
    const OwnTrace trace = traceIn(box, grains);
    EXPECT_NEAR(trace.others[0], volume/6, 1e-14);
    EXPECT_NEAR(trace.others[2], 0, 1e-14);
    const OwnTrace together = traceIn(box, makeGrains({Vec3(2.2, 2.5, 2.5), Vec3(2.8, 2.5, 2.5)}, 0.15));
    EXPECT_NEAR(together.others[0], together.fraction[0], 1e-14);
}

/// A sphere in every cell: each is alone in its cell, and none is lone.
TEST(OwnTrace, aLatticeHasNoLoneGrains)
{
    BoxMesh box(unitCells(labelVector(3, 3, 3), allCyclic()));
    ::nscd::PeriodicBox periodic;
    periodic.length = Vec3(3, 3, 3);
    std::vector<Vec3> points;
    for (int k = 0; k < 27; ++k) points.emplace_back(0.5 + k%3, 0.5 + (k/3)%3, 0.5 + k/9);
    const ::nscd::Grains grains = makeGrains(points, 0.4);
    const OwnTrace trace = traceIn(box, grains, periodic);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        EXPECT_NEAR(trace.others[i], grains.volume(i), 1e-13);
        EXPECT_EQ(trace.flowDiagonal[i].norm(), 0);
    }
}

/// Smoothed over four cells, a grain finds of itself what the kernel's own overlap says, wherever in its cell it is.
TEST(OwnTrace, smoothedFieldsHoldTheGrainItself)
{
    BoxMesh box(unitCells(labelVector(16, 16, 16), allCyclic()));
    ::nscd::PeriodicBox periodic;
    periodic.length = Vec3(16, 16, 16);
    for (const scalar offset : {0.5, 1.0})
    {
        const OwnTrace trace = traceIn(box, makeGrains({Vec3(8 + offset, 8.5, 8.5)}, 0.3), periodic, 4);
        EXPECT_NEAR(trace.others[0]/trace.fraction[0], 0, 0.2) << offset;
    }
}
