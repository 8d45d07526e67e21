// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Parts of scenes: lattice, random numbers, box, weight.
#include "nscd/tools/sceneParts.hpp"

#include <gtest/gtest.h>

using namespace nscd;

namespace
{

const GrainLattice lattice{Vec3(-1, 0, 2), Vec3(1, 1, 5), {8, 4, 12}, 0.2, 0.2, 1.0, 7};

Grains grainsOf(const GrainLattice& given)
{
    Grains grains;
    addLattice(grains, given, 1000.0, 3);
    return grains;
}

} // namespace

TEST(SceneParts, aLatticeFillsItsBoxWithoutOverlap)
{
    const Grains grains = grainsOf(lattice);
    ASSERT_EQ(grains.size(), 8u*4*12);
    double smallest = 1.0, largest = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3 r = Vec3::Constant(grains.radius[i]);
        EXPECT_GE((grains.position[i] - r - lattice.lower).minCoeff(), -1e-12);
        EXPECT_LE((grains.position[i] + r - lattice.upper).maxCoeff(), 1e-12);
        for (std::size_t j = 0; j < i; ++j)
        {
            EXPECT_GE((grains.position[i] - grains.position[j]).norm(), grains.radius[i] + grains.radius[j] - 1e-12);
        }
        smallest = std::min(smallest, 2*grains.radius[i]);
        largest = std::max(largest, 2*grains.radius[i]);
        EXPECT_EQ(grains.id[i], static_cast<std::int64_t>(i));
        EXPECT_EQ(grains.material[i], 3);
    }
    EXPECT_GE(smallest, 0.16);
    EXPECT_LT(smallest, 0.165);
    EXPECT_LE(largest, 0.24);
    EXPECT_GT(largest, 0.235);
}

TEST(SceneParts, withoutJitterGrainsAreInTheMiddleOfTheirCells)
{
    GrainLattice regular = lattice;
    regular.jitter = regular.spread = 0.0;
    const Grains grains = grainsOf(regular);
    EXPECT_LT((grains.position[0] - Vec3(-0.875, 0.125, 2.125)).norm(), 1e-15);
    EXPECT_LT((grains.position[1] - Vec3(-0.625, 0.125, 2.125)).norm(), 1e-15);   // x runs fastest
    EXPECT_LT((grains.position.back() - Vec3(0.875, 0.875, 4.875)).norm(), 1e-15);
}

/// The ten thousandth number of the standard's generator is prescribed by the standard.
TEST(SceneParts, randomNumbersAreTheSameEverywhere)
{
    const RandomNumbers random = randomNumbers(5489);
    for (int k = 1; k < 10000; ++k)
    {
        const double x = random();
        ASSERT_TRUE(x >= 0.0 && x < 1.0);
    }
    EXPECT_EQ(random(), std::ldexp(static_cast<double>(9981545732273789042ULL >> 11), -53));
    GrainLattice other = lattice;
    other.seed = 8;
    EXPECT_EQ(grainsOf(lattice).position, grainsOf(lattice).position);
    EXPECT_NE(grainsOf(lattice).position, grainsOf(other).position);
}

TEST(SceneParts, latticesThatCannotBeAreRefused)
{
    const auto refused = [](auto change)
    {
        GrainLattice bad = lattice;
        change(bad);
        EXPECT_THROW(grainsOf(bad), std::invalid_argument);
    };
    refused([](GrainLattice& l) { l.count[1] = 0; });
    refused([](GrainLattice& l) { l.spread = 1.0; });
    refused([](GrainLattice& l) { l.jitter = 1.1; });
    refused([](GrainLattice& l) { l.diameter = -0.1; });
}

TEST(SceneParts, aBoxHasSixSidesThatFaceInward)
{
    Walls walls;
    const Vec3 lower(0, 1, 2), upper(1, 3, 6), x(0.25, 1.5, 5);
    addBox(walls, walls.addPatch("box", 0), lower, upper);
    ASSERT_EQ(walls.regions.size(), 6u);
    std::vector<double> distances;
    for (const WallRegion& side : walls.regions) distances.push_back(nearestPoint(side, x).distance);
    EXPECT_EQ(distances, (std::vector<double>{0.25, 0.75, 0.5, 1.5, 3, 1}));
    EXPECT_THROW(addBox(walls, 0, lower, Vec3(1, 1, 6)), std::invalid_argument);
}

TEST(SceneParts, weightIsMassTimesGravity)
{
    const Grains grains = grainsOf(lattice);
    const Vec3 g(1, 2, -9);
    const ExternalForces forces = gravityForces(grains, g, 0.5);
    ASSERT_EQ(forces.force.size(), grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_EQ(forces.force[i], grains.mass[i]*g);
    EXPECT_DOUBLE_EQ(forces.speedScale, 0.5*g.norm());
    EXPECT_TRUE(forces.torque.empty() && forces.implicitDrag.empty());
}
