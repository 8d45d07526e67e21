// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Shares of the ranks: balanced, complete, compact.
#include "parallel/grainPartition.hpp"
#include "sharedScene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace nscd;

namespace
{

const RankTree& tree()
{
    static const RankTree* const theTree = new RankTree{Communicator()};  // lives on: MPI ends before static objects do
    return *theTree;
}

/// The partition of a scene, known to all ranks: new owner per grain of `scene.all`.
std::vector<int> partition(const SharedScene& scene, const std::vector<double>& weight)
{
    const std::vector<int> own = scene.of(tree().all().rank());
    std::vector<Vec3> position;
    std::vector<double> ownWeight;
    for (int i : own)
    {
        position.push_back(scene.all.position[i]);
        ownWeight.push_back(weight[i]);
    }
    const std::vector<int> destination = partitionGrains(tree(), position, ownWeight);
    EXPECT_EQ(destination.size(), own.size());
    std::vector<double> everywhere(weight.size(), 0.0);
    for (std::size_t n = 0; n < own.size(); ++n) everywhere[own[n]] = destination[n];
    tree().all().sum(everywhere.data(), int(everywhere.size()));
    return std::vector<int>(everywhere.begin(), everywhere.end());
}

std::vector<double> loads(const std::vector<int>& owner, const std::vector<double>& weight)
{
    std::vector<double> load(tree().all().size(), 0.0);
    for (std::size_t i = 0; i < owner.size(); ++i) load[owner[i]] += weight[i];
    return load;
}

SharedScene latticeScene(int n)
{
    SharedScene scene;
    for (int i = 0; i < n*n*n; ++i)
    {
        scene.all.add(0.1*Vec3(i % n, i/n % n, i/(n*n)), 0.05, 2500.0, 0, i);
        scene.owner.push_back(0);
    }
    return scene;
}

void expectBalance(const SharedScene& scene, const std::vector<double>& weight, double tolerance)
{
    double total = 0.0;
    for (double w : weight) total += w;
    for (double load : loads(partition(scene, weight), weight)) EXPECT_NEAR(load, total/tree().all().size(), tolerance);
}

class GrainPartition : public testing::TestWithParam<Ownership>
{
};

} // namespace

TEST_P(GrainPartition, balancesWithinOneGrainsWeight)
{
    const SharedScene scene = randomScene(1000, 0, GetParam(), tree().all().size());
    std::vector<double> weight;
    for (int i = 0; i < 1000; ++i) weight.push_back(1.0 + i % 7);
    expectBalance(scene, std::vector<double>(1000, 1.0), 1.0);
    expectBalance(scene, weight, 7.0);
}

TEST_P(GrainPartition, doesNotDependOnOwners)
{
    const std::vector<double> weight(500, 1.0);
    const std::vector<int> owner = partition(randomScene(500, 0, GetParam(), tree().all().size()), weight);
    EXPECT_EQ(partition(randomScene(500, 0, Ownership::slabs, tree().all().size()), weight), owner);
}

TEST_P(GrainPartition, leavesAPartitionAsItIs)
{
    SharedScene scene = randomScene(500, 0, GetParam(), tree().all().size());
    scene.owner = partition(scene, std::vector<double>(500, 1.0));
    EXPECT_EQ(partition(scene, std::vector<double>(500, 1.0)), scene.owner);
}

INSTANTIATE_TEST_SUITE_P
(
    Owners, GrainPartition,
    testing::Values(Ownership::slabs, Ownership::scattered, Ownership::evenRanks, Ownership::lastRank)
);

TEST(GrainPartitionAlone, cutsALatticeBetweenPlanes)
{
    const SharedScene scene = latticeScene(8);
    const std::vector<double> weight(512, 1.0);
    // Cuts that fall on a plane of 64 grains miss by half of it; three in a row by less than a plane.
    const bool isExact = 512 % tree().all().size() == 0;
    expectBalance(scene, weight, isExact ? 0.0 : 64.0);
}

TEST(GrainPartitionAlone, cutsOnTheSideOfAHeavyGrainThatIsNearerToTheShare)
{
    const int size = tree().all().size();
    if (size % 2 != 0) GTEST_SKIP() << "halves are unequal";
    SharedScene scene = randomScene(3, 0, Ownership::scattered, size);
    for (int i = 0; i < 3; ++i) scene.all.position[i] = Vec3(i, 0, 0);
    const std::vector<int> below = partition(scene, {3.0, 10.0, 1.0}), above = partition(scene, {1.0, 10.0, 3.0});
    EXPECT_LT(below[0], size/2);
    EXPECT_GE(below[1], size/2);
    EXPECT_LT(above[1], size/2);
    EXPECT_GE(above[2], size/2);
}

TEST(GrainPartitionAlone, grainsInOnePlaceStayTogether)
{
    SharedScene scene = randomScene(50, 0, Ownership::scattered, tree().all().size());
    std::fill(scene.all.position.begin(), scene.all.position.end(), Vec3(0.1, 0.2, 0.3));
    const std::vector<int> owner = partition(scene, std::vector<double>(50, 1.0));
    EXPECT_EQ(std::count(owner.begin(), owner.end(), owner[0]), 50);
}

TEST(GrainPartitionAlone, fewGrainsGoToDifferentRanks)
{
    for (int count : {0, 1, 2, 3})
    {
        const SharedScene scene = randomScene(count, 0, Ownership::lastRank, tree().all().size());
        const std::vector<double> weight(count, 1.0);
        const int fair = (count + tree().all().size() - 1)/tree().all().size();
        for (double load : loads(partition(scene, weight), weight)) EXPECT_LE(load, fair);
    }
}

TEST(GrainPartitionAlone, theLowerRanksGetWhatLiesLower)
{
    SharedScene scene = randomScene(200, 0, Ownership::scattered, tree().all().size());
    for (Vec3& x : scene.all.position) x[1] *= 100.0;
    const std::vector<int> owner = partition(scene, std::vector<double>(200, 1.0));
    for (int i = 0; i < 200; ++i)
    {
        for (int j = 0; j < 200; ++j)
        {
            if (owner[i] < owner[j]) { EXPECT_LT(scene.all.position[i][1], scene.all.position[j][1]); }
        }
    }
}

TEST(GrainPartitionAlone, refusesBadInput)
{
    EXPECT_THROW(partitionGrains(tree(), {Vec3::Zero()}, {}), std::invalid_argument);
    EXPECT_THROW(partitionGrains(tree(), {Vec3::Zero()}, {-1.0}), std::invalid_argument);
    EXPECT_THROW(partitionGrains(tree(), {Vec3(0, std::nan(""), 0)}, {1.0}), std::invalid_argument);
}

TEST(GrainPartitionAlone, imbalanceIsLargestOverMean)
{
    const Communicator& all = tree().all();
    EXPECT_EQ(imbalance(all, 2.0), 1.0);
    EXPECT_EQ(imbalance(all, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(imbalance(all, all.rank() == 0 ? 1.0 : 0.0), all.size());
}
