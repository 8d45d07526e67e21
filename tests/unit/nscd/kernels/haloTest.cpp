// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Giving and taking among ghosts, copies and owners, by a rank that is its own neighbor.
#include "nscd/kernels/halo.hpp"

#include <gtest/gtest.h>

using namespace nscd;

namespace
{

/// Ghosts of this rank are its own shared bodies: what another rank would have of them.
class OwnNeighbor : public Exchange
{
public:
    bool isParallel() const override { return true; }
    void toGhosts(const std::vector<double>& shared, std::vector<double>& ghosts, int) const override { ghosts = shared; }
    void toOwners(const std::vector<double>& ghosts, std::vector<double>& shared, int) const override { shared = ghosts; }
    void sum(double* values, int count) const override { for (int k = 0; k < count; ++k) values[k] *= 2.0; }
};

/// Five own bodies. Bodies 1 and 3 are shared, so bodies 5 and 6 are their ghosts; 3 and 4 have interface contacts here, so that two ranks move
/// body 3, which has a copy, body 7. Body 8 is the static one.
struct Rank
{
    OwnNeighbor exchange;
    Halo halo{exchange, 5, 2, {1, 3}, {3, 4}};
    std::vector<Body> bodies;

    Rank()
    {
        for (int i = 0; i < 5; ++i) bodies.push_back({{1.0*i, 2.0*i, 0}, 0.1*(i + 1), {0, 0, 3.0*i}, 0.2*(i + 1)});
        bodies.resize(9);
    }
};

} // namespace

TEST(Halo, numbersOwnBodiesGhostsAndCopies)
{
    const Rank rank;
    EXPECT_EQ(rank.halo.firstGhost(), 5);
    EXPECT_EQ(rank.halo.firstCopy(), 7);
    EXPECT_EQ(rank.halo.bodies(), 8u);
    EXPECT_EQ(rank.halo.copied(), std::vector<int>{3});
    EXPECT_EQ(rank.halo.parts(5), 1.0);
    EXPECT_EQ(rank.halo.parts(6), 2.0);
    EXPECT_EQ(rank.halo.parts(7), 2.0);
}

TEST(Halo, takesTheSmallestAndTheLargest)
{
    const Rank rank;
    std::vector<double> smallest = {1, 2, 3, 4, 5, 1.5, 7, 3.5}, largest = smallest;
    rank.halo.takeSmallest(smallest);
    rank.halo.takeLargest(largest);
    EXPECT_EQ(std::vector<double>(smallest.begin(), smallest.begin() + 5), (std::vector<double>{1, 1.5, 3, 3.5, 5}));
    EXPECT_EQ(std::vector<double>(largest.begin(), largest.begin() + 5), (std::vector<double>{1, 2, 3, 7, 5}));
}

TEST(Halo, ghostsAndCopiesMoveAsTheirOwnersWithAShareOfTheMass)
{
    Rank rank;
    rank.halo.giveBodies(rank.bodies);
    const int owner[] = {1, 3, 3};
    for (int k = 0; k < 3; ++k)
    {
        const Body& body = rank.bodies[5 + k];
        const Body& own = rank.bodies[owner[k]];
        EXPECT_EQ(body.invMass, rank.halo.parts(5 + k)*own.invMass);
        EXPECT_EQ(body.invSpin, rank.halo.parts(5 + k)*own.invSpin);
        EXPECT_EQ(body.v[1], own.v[1]);
        EXPECT_EQ(body.s[2], own.s[2]);
    }
}

TEST(Halo, ownersTakeTheMeanOfWhatWasMadeOfTheirParts)
{
    Rank rank;
    rank.halo.giveBodies(rank.bodies);
    rank.bodies[5].v[0] += 0.5;   // body 1, one part
    rank.bodies[6].v[0] += 1.0;   // body 3 elsewhere
    rank.bodies[7].v[0] += 3.0;   // and here
    rank.bodies[7].s[2] -= 4.0;
    rank.halo.takeVelocities(rank.bodies);
    EXPECT_DOUBLE_EQ(rank.bodies[1].v[0], 1.0 + 0.5);
    EXPECT_DOUBLE_EQ(rank.bodies[3].v[0], 3.0 + 0.5*(1.0 + 3.0));
    EXPECT_DOUBLE_EQ(rank.bodies[3].s[2], 9.0 - 2.0);
    EXPECT_EQ(rank.bodies[4].v[0], 4.0);
}

TEST(Halo, sumsOfEntriesGoToTheirOwners)
{
    Rank rank;
    std::vector<Vec3> values;
    for (int i = 0; i < 9; ++i) values.push_back(Vec3(i, 0, 0));
    std::vector<Vec3> given = values;
    rank.halo.give(given);
    EXPECT_EQ(given[5], values[1]);
    EXPECT_EQ(given[6], values[3]);
    EXPECT_EQ(given[7], values[3]);
    rank.halo.take(values);
    EXPECT_EQ(values[1][0], 1 + 5);
    EXPECT_EQ(values[3][0], 3 + 6 + 7);
    EXPECT_EQ(values[2][0], 2);
    EXPECT_EQ(rank.halo.sum(3.0), 6.0);
}

TEST(Halo, ofOneRankLeavesAllAsItIs)
{
    Halo alone;
    std::vector<Vec3> values = {Vec3(1, 2, 3)};
    std::vector<Body> bodies = {{{1, 2, 3}, 1.0, {4, 5, 6}, 2.5}};
    alone.give(values);
    alone.take(values);
    alone.giveBodies(bodies);
    alone.takeVelocities(bodies);
    EXPECT_EQ(values[0], Vec3(1, 2, 3));
    EXPECT_EQ(Vec3(bodies[0].v), Vec3(1, 2, 3));
    EXPECT_EQ(alone.sum(3.0), 3.0);
    EXPECT_FALSE(alone.isParallel() || alone.any(false));
    EXPECT_TRUE(alone.any(true));
}
