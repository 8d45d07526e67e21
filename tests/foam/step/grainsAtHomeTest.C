// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains owned anywhere: their homes against the whole mesh, and values on their way there and back.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/step/grainsAtHome.H"
#include "mappingTools.H"
#include "ranksMesh.H"

#include "parallel/mpiExchange.hpp"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Spheres anywhere in the box of 6 x 5 x 4 and somewhat beyond it, other ones, and more of them, on each rank.
::nscd::Grains scatteredGrains()
{
    const unsigned rank = unsigned(Pstream::myProcNo());
    ::nscd::Grains grains;
    for (const Vec3& x : randomPoints(10 + 3*rank, Vec3(-0.5, -0.5, -0.5), Vec3(6.5, 5.5, 4.5), rank))
    {
        grains.add(x, 0.1 + 0.001*scalar(grains.size()), 2500, 0, std::int64_t(1000*rank + grains.size()));
    }
    return grains;
}

struct OwnedAnywhere
{
    RanksMesh mesh;
    ::nscd::MpiExchange exchange;
    GrainHomes homes;
    ::nscd::Grains own = scatteredGrains();

    explicit OwnedAnywhere(const Decomposition& decomposition)
    :
        mesh(unitCells(labelVector(6, 5, 4)), decomposition),
        homes(mesh.part(), exchange.tree(), findHomeIn(mesh.part()))
    {}

    /// The cell of the whole mesh that a position is in, -1 outside.
    label wholeCell(const Vec3& x)
    {
        const SerialSection serial;
        return mesh.whole().findCell(toFoam(x));
    }

    void expectHomes()
    {
        const std::vector<CellHome>& found = homes.update(own);
        ASSERT_EQ(found.size(), own.size());
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            const label cell = wholeCell(own.position[i]);
            EXPECT_EQ(found[i].rank >= 0, cell >= 0) << i;
            if (cell < 0 || found[i].rank < 0) continue;
            EXPECT_EQ(found[i].rank, mesh.rankOf(cell)) << i;
            EXPECT_EQ(mesh.wholeCell(found[i].rank, found[i].cell), cell) << i;
        }
    }
};

void expectHomesWhile(const Decomposition& decomposition)
{
    if (!Pstream::parRun()) GTEST_SKIP() << "on several ranks";
    OwnedAnywhere grains(decomposition);
    grains.expectHomes();
    for (Vec3& x : grains.own.position) x += Vec3(0.6, -0.4, 0.3);
    grains.expectHomes();
    const std::vector<std::size_t> gone = {0, 4, 9};
    eraseGrains(grains.own, gone);
    grains.homes.erase(gone);
    EXPECT_EQ(grains.homes.homes().size(), grains.own.size());
    grains.expectHomes();
    grains.homes.forget();
    grains.expectHomes();
}

} // namespace

TEST(grainHomesRanks, slices) { expectHomesWhile(slices()); }

TEST(grainHomesRanks, scatteredCells) { expectHomesWhile(scattered()); }

TEST(GrainsAtHome, onOneRankAreTheOwnOnesAndNothingTravels)
{
    std::vector<scalar> numbers = {1, 2};
    std::vector<Vec3> vectors = {Vec3(1, 2, 3)};
    const GrainsAtHome atHome;
    atHome.toHomes({{&numbers}, {&vectors}});
    atHome.toOwners({{&numbers}, {&vectors}});
    EXPECT_EQ(numbers, (std::vector<scalar>{1, 2}));
    EXPECT_EQ(vectors[0], Vec3(1, 2, 3));
}

TEST(grainsAtHomeRanks, getTheirValuesAndSendThemBack)
{
    if (!Pstream::parRun()) GTEST_SKIP() << "on several ranks";
    OwnedAnywhere grains(blocks());
    const std::vector<CellHome> homes = grains.homes.update(grains.own);
    GrainsAtHome atHome(grains.exchange.tree());
    atHome.update(grains.own, homes, MappedBodies());

    // Who is there, in which cell, and how large.
    const ::nscd::Grains& here = atHome.grains();
    ASSERT_EQ(atHome.cells().size(), here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
    {
        EXPECT_EQ(grains.mesh.wholeCell(Pstream::myProcNo(), atHome.cells()[i]), grains.wholeCell(here.position[i]));
        EXPECT_EQ(here.radius[i], 0.1 + 0.001*scalar(here.id[i] % 1000));
    }
    double inside[2] = {0, double(here.size())};
    for (const CellHome& home : homes) inside[0] += home.rank >= 0;
    grains.exchange.sum(inside, 2);
    EXPECT_EQ(inside[0], inside[1]);

    std::vector<scalar> number(grains.own.id.begin(), grains.own.id.end());
    std::vector<Vec3> place = grains.own.position;
    atHome.toHomes({{&number}, {&place}});
    ASSERT_EQ(number.size(), here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
    {
        EXPECT_EQ(number[i], scalar(here.id[i]));
        EXPECT_EQ(place[i], here.position[i]);
        number[i] += 0.5;
        place[i] *= 2;
    }
    atHome.toOwners({{&number}, {&place}});
    ASSERT_EQ(number.size(), grains.own.size());
    for (std::size_t i = 0; i < grains.own.size(); ++i)
    {
        const bool isInside = homes[i].rank >= 0;
        EXPECT_EQ(number[i], isInside ? scalar(grains.own.id[i]) + 0.5 : 0.0);
        EXPECT_EQ(place[i], isInside ? Vec3(2*grains.own.position[i]) : Vec3(Vec3::Zero()));
    }
}
