// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The patch by which a grain left, asked of the ranks of a decomposed mesh, against the whole mesh.

#include "coupling/case/walls/grainExits.H"
#include "mappingTools.H"
#include "ranksMesh.H"

#include "parallel/mpiExchange.hpp"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

// Points near the box of 6 x 5 x 4 and far from it; other ones, and more of them, on each rank.
pointField pointsAround(const scalar spread)
{
    std::mt19937 generator(7 + Pstream::myProcNo());
    std::uniform_real_distribution<scalar> random(-1, 1);
    pointField points(3*Pstream::myProcNo() + (Pstream::parRun() ? 0 : 3));
    for (point& x : points) x = point(3, 2.5, 2) + (3 + spread)*vector(random(generator), random(generator), random(generator));
    return points;
}

void expectTheWholeMeshsPatches(const Decomposition& decomposition, const scalarList& weights = scalarList())
{
    RanksMesh mesh(unitCells(labelVector(6, 5, 4), wordList(6, word("wall"))), decomposition);
    const ::nscd::MpiExchange exchange;
    for (const scalar spread : {0.1, 3.0, 300.0})
    {
        const pointField points = pointsAround(spread);
        const labelList found = nearestPatches(mesh.part(), points, Pstream::parRun() ? &exchange.tree() : nullptr, weights);
        const SerialSection serial;
        EXPECT_EQ(found, nearestPatches(mesh.whole(), points, nullptr, weights)) << "spread " << spread;
    }
}

TEST(exitsRanks, slices) { expectTheWholeMeshsPatches(slices()); }

TEST(exitsRanks, blocks) { expectTheWholeMeshsPatches(blocks()); }

TEST(exitsRanks, scatteredCells) { expectTheWholeMeshsPatches(scattered()); }

TEST(exitsRanks, patchesThatCountAsNearer) { expectTheWholeMeshsPatches(blocks(), scalarList({2, 1, 2, 2, 1, 2})); }

} // End anonymous namespace
