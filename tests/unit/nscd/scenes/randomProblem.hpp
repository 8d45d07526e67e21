// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Random contacts between random bodies, for what works on blocks of contacts.
#pragma once

#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/problem/contactProblem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace scenes
{

/// Whether this processor has a vector path.
inline bool isAvailable(const std::string& path)
{
    try
    {
        nscd::chooseKernels(path.c_str());
        return true;
    }
    catch (const std::invalid_argument&)
    {
        return false;
    }
}

/// Forty bodies, and blocks of eight contacts without a common one. Velocities do not hold the impulses, which push.
struct RandomProblem
{
    std::vector<nscd::Body> bodies;
    std::vector<nscd::ContactBlock> blocks;
    std::vector<std::uint32_t> awake;
    std::vector<nscd::Vec3> position;
    nscd::Halo alone;
    nscd::SweepKernels kernels = nscd::chooseKernels("portable");

    nscd::BlockRange all() const { return {nullptr, blocks.size()}; }

    nscd::ContactProblem problem()
    {
        return {bodies, blocks, awake, blocks.size(), alone, kernels, true, 1e-3, 1.0, 1.0, position};
    }

    explicit RandomProblem(int nBlocks)
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        bodies.resize(40);
        for (nscd::Body& body : bodies)
        {
            body = {{unit(random), unit(random), unit(random)}, 1.5 + unit(random), {unit(random), unit(random), unit(random)}, 4 + unit(random)};
        }
        position.assign(bodies.size(), nscd::Vec3::Zero());
        blocks.resize(nBlocks);
        awake.resize(nBlocks);
        std::iota(awake.begin(), awake.end(), 0);
        std::vector<int> order(bodies.size());
        std::iota(order.begin(), order.end(), 0);
        for (nscd::ContactBlock& block : blocks)
        {
            std::shuffle(order.begin(), order.end(), random);
            for (int lane = 0; lane < nscd::blockLanes; ++lane)
            {
                const nscd::Vec3 n = nscd::Vec3(unit(random), unit(random), unit(random)).normalized();
                const nscd::Body& a = bodies[order[2*lane]];
                const nscd::Body& b = bodies[order[2*lane + 1]];
                for (int k = 0; k < 3; ++k)
                {
                    block.n[k][lane] = n[k];
                    block.r[k][lane] = 0.1*n[k];
                }
                block.bias[lane] = 0.2*unit(random);
                block.invWn[lane] = 1/(a.invMass + b.invMass);
                block.invWt[lane] = 1/(a.invMass + b.invMass + a.invSpin + b.invSpin);
                block.friction[lane] = 0.5;
                block.a[lane] = order[2*lane];
                block.b[lane] = order[2*lane + 1];
            }
        }
    }
};

inline void expectSameBodies(const std::vector<nscd::Body>& x, const std::vector<nscd::Body>& y, double tolerance)
{
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            ASSERT_NEAR(x[i].v[k], y[i].v[k], tolerance);
            ASSERT_NEAR(x[i].s[k], y[i].s[k], tolerance);
        }
    }
}

} // namespace scenes
