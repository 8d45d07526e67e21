// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scaling of impulses by layers, against a column whose factors are known.
#include "layerScaling.hpp"
#include "scenes.hpp"
#include "sweepKernels.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

/// A column of unit masses and diameters that has fallen for a unit of speed; its contacts carry half the impulses that would stop it.
struct Column
{
    static constexpr int size = 60;
    std::vector<nscd::Body> bodies;
    std::vector<nscd::ContactBlock> blocks;
    std::vector<std::uint32_t> awake;
    std::vector<Vec3> position;
    nscd::Halo alone;
    nscd::SweepKernels kernels = nscd::chooseKernels("portable");

    /// `up`: unit vector, upwards.
    explicit Column(const Vec3& up)
    {
        for (int i = 0; i < size; ++i)
        {
            position.push_back((i + 0.5)*up);
            bodies.push_back({{-0.5*up[0], -0.5*up[1], -0.5*up[2]}, 1.0, {0, 0, 0}, 2.5});
            nscd::ContactBlock block{};
            std::fill(block.a, block.a + nscd::blockLanes, size);
            std::fill(block.b, block.b + nscd::blockLanes, size);
            block.a[0] = i;
            block.b[0] = i > 0 ? i - 1 : size;
            block.invWn[0] = i > 0 ? 0.5 : 1.0;
            block.invWt[0] = i > 0 ? 1.0/7.0 : 1.0/3.5;
            for (int m = 0; m < 3; ++m)
            {
                block.n[m][0] = up[m];
                block.r[m][0] = 0.5*(size - i)*up[m];
            }
            blocks.push_back(block);
            awake.push_back(i);
        }
        bodies.push_back({{0, 0, 0}, 0.0, {0, 0, 0}, 0.0});
    }

    nscd::ContactProblem problem()
    {
        return {bodies, blocks, awake, blocks.size(), alone, kernels, true, 1e-3, 1.0, 1.0, position};
    }
};

} // namespace

TEST(LayerScaling, findsTheFactorThatStopsAColumnAndOvershootsByHalf)
{
    for (const Vec3& up : {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(Vec3(1, 2, 3).normalized())})
    {
        Column column(up);
        nscd::ContactProblem problem = column.problem();
        nscd::LayerScaling layers(problem);
        EXPECT_NEAR(layers.apply(), 1.0, 1e-3);
        for (int i = 0; i < Column::size; ++i)
        {
            EXPECT_LT((Vec3(column.bodies[i].v) - 0.25*up).norm(), 2e-2) << i;
            EXPECT_LT(std::abs(column.blocks[i].r[2][0] - 1.25*(Column::size - i)*up[2]), 1e-2*Column::size) << i;
        }
    }
}

TEST(LayerScaling, leavesAloneWhatIsInBalance)
{
    Column column(Vec3::UnitZ());
    for (int i = 0; i < Column::size; ++i)
    {
        column.blocks[i].r[2][0] *= 2;
        column.bodies[i].v[2] = 0.0;
    }
    nscd::ContactProblem problem = column.problem();
    EXPECT_EQ(nscd::LayerScaling(problem).apply(), 0.0);
    for (int i = 0; i < Column::size; ++i) EXPECT_EQ(column.blocks[i].r[2][0], Column::size - i);
}

TEST(LayerScaling, bringsTheWeightOfADeepStackDownInSixtySweeps)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < 60; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-6;
    settings.maxSweeps = 60;
    auto dynamics = scene.build(settings);
    step(dynamics, scene.g, 1e-3);
    EXPECT_NEAR(-dynamics.wallForce()[0][2], 60*dynamics.grains().mass[0]*gravity, 0.2*60*dynamics.grains().mass[0]*gravity);
}
