// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains and what belongs to them arrive once, unchanged and in one order.
#include "parallel/migration.hpp"
#include "sharedScene.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace nscd;

namespace
{

/// Grains on the move, each rank's with destinations at random.
struct Move
{
    Communicator all;
    SharedScene scene;
    Grains own;
    std::vector<int> newOwner;
    Migration migration;

    explicit Move(Ownership ownership)
    :
        scene(randomScene(300, 0, ownership, all.size())),
        own(scene.grainsOf(all.rank())),
        newOwner(randomScene(300, 0, Ownership::scattered, all.size(), 5).owner),
        migration(all, destinations())
    {}

    std::vector<int> destinations() const
    {
        std::vector<int> destination;
        for (int i : scene.of(all.rank())) destination.push_back(newOwner[i]);
        return destination;
    }

    /// Grains that arrive here, by their index in scene.all: from rank after rank, in the order they had there.
    std::vector<int> arriving() const
    {
        std::vector<int> grains;
        for (int rank = 0; rank < all.size(); ++rank)
        {
            for (int i : scene.of(rank))
            {
                if (newOwner[i] == all.rank()) grains.push_back(i);
            }
        }
        return grains;
    }
};

class MigrationTest : public testing::TestWithParam<Ownership>
{
};

} // namespace

TEST_P(MigrationTest, grainsArriveWithAllTheirProperties)
{
    const Move move(GetParam());
    const Grains got = move.migration.moveGrains(move.own);
    const std::vector<int> expected = move.arriving();
    const Grains& all = move.scene.all;
    ASSERT_EQ(got.size(), expected.size());
    EXPECT_EQ(got.nOwned, got.size());
    for (std::size_t n = 0; n < got.size(); ++n)
    {
        const int i = expected[n];
        EXPECT_EQ(got.id[n], all.id[i]);
        EXPECT_EQ(got.position[n], all.position[i]);
        EXPECT_EQ(got.velocity[n], all.velocity[i]);
        EXPECT_EQ(got.omega[n], all.omega[i]);
        EXPECT_EQ(got.orientation[n].coeffs(), all.orientation[i].coeffs());
        EXPECT_EQ(got.radius[n], all.radius[i]);
        EXPECT_EQ(got.mass[n], all.mass[i]);
        EXPECT_EQ(got.material[n], all.material[i]);
        EXPECT_EQ(got.isFixed[n], all.isFixed[i]);
    }
}

TEST_P(MigrationTest, attachedValuesArriveInTheOrderOfTheGrains)
{
    const Move move(GetParam());
    const Grains grains = move.migration.moveGrains(move.own);
    EXPECT_EQ(move.migration.move(move.own.id), grains.id);
    EXPECT_EQ(move.migration.move(move.own.isFixed), grains.isFixed);
    EXPECT_EQ(move.migration.move(move.own.omega), grains.omega);
    const std::vector<Quaternion> orientation = move.migration.move(move.own.orientation);
    ASSERT_EQ(orientation.size(), grains.size());
    for (std::size_t n = 0; n < grains.size(); ++n) EXPECT_EQ(orientation[n].coeffs(), grains.orientation[n].coeffs());
}

TEST_P(MigrationTest, grainsGoInOneMessagePerPairOfRanks)
{
    const Move move(GetParam());
    std::set<int> others;
    for (int rank : move.destinations()) others.insert(rank);
    others.erase(move.all.rank());
    move.migration.moveGrains(move.own);
    EXPECT_EQ(move.all.traffic().messages, int(others.size()));
}

INSTANTIATE_TEST_SUITE_P
(
    Owners, MigrationTest,
    testing::Values(Ownership::slabs, Ownership::scattered, Ownership::evenRanks, Ownership::lastRank)
);

TEST(MigrationAlone, shapeAndGhosts)
{
    const Communicator all;
    Grains grains;
    grains.shape = {2, 0.01};
    grains.add(Vec3::Zero(), 0.1, 1.0, 0, all.rank());
    grains.add(Vec3::Zero(), 0.1, 1.0, 0, 100);
    grains.nOwned = 1;
    const Grains got = Migration(all, {0}).moveGrains(grains);
    EXPECT_EQ(got.size(), all.rank() == 0 ? std::size_t(all.size()) : 0u) << "ghosts stay behind";
    EXPECT_EQ(got.shape.dimensions, 2);
    EXPECT_EQ(got.shape.thickness, 0.01);
}

TEST(MigrationAlone, refusesWhatIsNoRankOrTooFewValues)
{
    const Communicator all;
    EXPECT_THROW(Migration(all, {all.size()}), std::invalid_argument);
    EXPECT_THROW(Migration(all, {-1}), std::invalid_argument);
    EXPECT_THROW(Migration(all, {0, 0}).move(std::vector<int>(1)), std::invalid_argument);
}
