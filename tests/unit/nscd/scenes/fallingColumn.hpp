// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A contact problem whose solution is known: grains on top of one another.
#pragma once

#include "nscd/solvers/contactSolver.hpp"
#include "unit/nscd/scenes/scenes.hpp"
#include "nscd/kernels/sweepKernels.hpp"

#include <algorithm>
#include <vector>

namespace scenes
{

/// A column of unit masses and diameters, each grain falling at unit speed, and no impulses.
struct Column
{
    std::vector<nscd::Body> bodies;
    std::vector<nscd::ContactBlock> blocks;
    std::vector<std::uint32_t> awake;
    std::vector<Vec3> position;
    nscd::Halo alone;
    nscd::SweepKernels kernels = nscd::chooseKernels("portable");

    Column(int size, const Vec3& up)
    {
        for (int i = 0; i < size; ++i)
        {
            position.push_back((i + 0.5)*up);
            bodies.push_back({{-up[0], -up[1], -up[2]}, 1.0, {0, 0, 0}, 2.5});
            nscd::ContactBlock block{};
            std::fill(block.a, block.a + nscd::blockLanes, size);
            std::fill(block.b, block.b + nscd::blockLanes, size);
            block.a[0] = i;
            block.b[0] = i > 0 ? i - 1 : size;
            block.invWn[0] = i > 0 ? 0.5 : 1.0;
            block.invWt[0] = i > 0 ? 1.0/7.0 : 1.0/3.5;
            for (int m = 0; m < 3; ++m) block.n[m][0] = up[m];
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

/// A column that carries its weight, but for what one contact has too little of its impulse.
inline Column columnAtRest(int size, int contact, double missing)
{
    Column column(size, Vec3::UnitZ());
    for (nscd::Body& body : column.bodies) body.v[2] = 0.0;
    for (int k = 0; k < size; ++k) column.blocks[k].r[2][0] = size - k;
    column.blocks[contact].r[2][0] -= missing;
    column.bodies[contact].v[2] -= missing;
    column.bodies[contact - 1].v[2] += missing;
    return column;
}

} // namespace scenes
