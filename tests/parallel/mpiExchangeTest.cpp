// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Numbers of ghosts to and from their owners, impulses to theirs.
#include "parallel/mpiExchange.hpp"
#include "sharedScene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace nscd;

namespace
{

double numberOf(std::int64_t id, int k) { return 10.0*id + k; }

/// A scene of scattered grains with all its ghosts connected, in an order that is not the search's.
struct Connected
{
    MpiExchange exchange;
    SharedScene scene;
    Grains own;
    std::vector<GhostGrain> ghosts;
    std::vector<int> shared;

    Connected()
    :
        scene(randomScene(300, 3, Ownership::scattered, exchange.tree().all().size())),
        own(scene.grainsOf(exchange.rank())),
        ghosts(exchange.findGhosts(own, scene.pathsOf(exchange.rank()), scene.box))
    {
        const auto byRadius = [](const GhostGrain& a, const GhostGrain& b) { return a.radius < b.radius; };
        std::sort(ghosts.begin(), ghosts.end(), byRadius);
        shared = exchange.connect(ghosts);
    }
};

} // namespace

TEST(MpiExchange, ghostsGetTheirOwnersNumbers)
{
    const Connected c;
    for (int width : {1, 3, 6})
    {
        std::vector<double> shared, ghosts;
        for (int index : c.shared)
        {
            for (int k = 0; k < width; ++k) shared.push_back(numberOf(c.own.id[index], k));
        }
        c.exchange.toGhosts(shared, ghosts, width);
        ASSERT_EQ(ghosts.size(), c.ghosts.size()*width);
        for (std::size_t i = 0; i < ghosts.size(); ++i) EXPECT_EQ(ghosts[i], numberOf(c.ghosts[i/width].id, i % width));
    }
}

TEST(MpiExchange, ownersGetTheirGhostsNumbers)
{
    const Connected c;
    for (int width : {1, 3, 6})
    {
        std::vector<double> ghosts, shared;
        for (const GhostGrain& ghost : c.ghosts)
        {
            for (int k = 0; k < width; ++k) ghosts.push_back(numberOf(ghost.id, k));
        }
        c.exchange.toOwners(ghosts, shared, width);
        ASSERT_EQ(shared.size(), c.shared.size()*width);
        for (std::size_t i = 0; i < shared.size(); ++i) EXPECT_EQ(shared[i], numberOf(c.own.id[c.shared[i/width]], i % width));
    }
}

TEST(MpiExchange, aGhostsNumbersComeBackToTheEntryTheyCameFrom)
{
    const Connected c;
    std::vector<double> sent, ghosts, back;
    for (std::size_t i = 0; i < c.shared.size(); ++i) sent.push_back(1000.0*c.exchange.rank() + i);
    c.exchange.toGhosts(sent, ghosts, 1);
    c.exchange.toOwners(ghosts, back, 1);
    EXPECT_EQ(back, sent);
}

TEST(MpiExchange, oneMessagePerNeighborAndCall)
{
    const Connected c;
    std::set<int> owners;
    for (const GhostGrain& ghost : c.ghosts) owners.insert(ghost.owner);
    const Traffic before = c.exchange.traffic();
    std::vector<double> shared;
    c.exchange.toOwners(std::vector<double>(3*c.ghosts.size()), shared, 3);
    EXPECT_EQ(c.exchange.traffic().messages - before.messages, int(owners.size()));
    EXPECT_EQ(c.exchange.traffic().bytes - before.bytes, int(24*c.ghosts.size()));
    EXPECT_EQ(c.exchange.traffic().reductions, before.reductions);
}

TEST(MpiExchange, connectsAgainAndWithoutGhosts)
{
    Connected c;
    EXPECT_TRUE(c.exchange.connect({}).empty());
    std::vector<double> none, ghosts(3);
    c.exchange.toGhosts(none, ghosts, 3);
    EXPECT_TRUE(ghosts.empty());
    EXPECT_EQ(c.exchange.connect(c.ghosts), c.shared);
}

TEST(MpiExchange, refusesNumbersOfTheWrongLength)
{
    const Connected c;
    std::vector<double> wrong(c.shared.size() + 1), ghosts;
    EXPECT_THROW(c.exchange.toGhosts(wrong, ghosts, 1), std::invalid_argument);
}

TEST(MpiExchange, deliversImpulsesToAllRanksByItselfToo)
{
    const MpiExchange exchange;
    const int size = exchange.tree().all().size(), own = exchange.rank();
    std::vector<ImpulseForOwner> sent;
    for (int n = 0; n < 3*size; ++n) sent.push_back({(7*n) % size, n, 100*own + n, Vec3(own, n, -1.0)});
    const std::vector<ImpulseForOwner> received = exchange.deliver(sent);

    std::vector<ImpulseForOwner> expected;
    for (int from = 0; from < size; ++from)
    {
        for (int n = 0; n < 3*size; ++n)
        {
            if ((7*n) % size == own) expected.push_back({own, n, 100*from + n, Vec3(from, n, -1.0)});
        }
    }
    ASSERT_EQ(received.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        EXPECT_EQ(received[i].rank, own);
        EXPECT_EQ(received[i].index, expected[i].index);
        EXPECT_EQ(received[i].id, expected[i].id);
        EXPECT_EQ(received[i].impulse, expected[i].impulse);
    }
}
