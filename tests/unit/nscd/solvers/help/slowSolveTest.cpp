// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// When the queue for the last contacts is used.
#include "nscd/solvers/help/slowSolve.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

/// Work beside sweeps that a solve does of a column of `size` grains where every tenth of the first ones moves, which puts two contacts each off.
int workBesideSweeps(int size, int moving)
{
    Column column = columnAtRest(size, 1, 0.0);
    for (int i = 0; i < moving; ++i) column.bodies[10*i + 5].v[2] = -1e-3;
    nscd::ContactProblem problem = column.problem();
    nscd::SolverStrategy sweepsAndQueue;
    sweepsAndQueue.mixing.isOn = sweepsAndQueue.momentum.isOn = false;
    nscd::SlowSolve solve(problem, sweepsAndQueue);
    const nscd::DefectSums sums = {1e-6*moving, 1e-6, double(size)};
    const nscd::StopRule rule = {1.0, 1e-4, 1.0, 1.0, 1e-4, 1.0, 1.0};
    return solve.afterSweep(20, sums, rule);
}

} // namespace

/// Of more than 5 % of the contacts, if those are more than 50, the sweeps take care: a queue would not come to an end.
TEST(SlowSolve, worksOffContactsByTheQueueWhereFewAreOff)
{
    EXPECT_GT(workBesideSweeps(2000, 48), 0);
    EXPECT_EQ(workBesideSweeps(2000, 52), 0);
    EXPECT_GT(workBesideSweeps(300, 24), 0);
    EXPECT_EQ(workBesideSweeps(300, 27), 0);
}
