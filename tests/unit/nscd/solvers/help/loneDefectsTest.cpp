// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sweeps around lone defects: they go away, and nothing else is touched.
#include "unit/nscd/scenes/fallingColumn.hpp"
#include "nscd/solvers/help/loneDefects.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double limit = 1e-3;
constexpr nscd::StopRule rule{1e-2, 1.0, 1.0, 1e-3, limit, 1.0, 1.0};

} // namespace

TEST(LoneDefects, goAwayWhereTheyAre)
{
    constexpr int size = 60, contact = 30;
    Column column = columnAtRest(size, contact, 2e-3);
    nscd::ContactProblem problem = column.problem();
    ASSERT_GT(nscd::residual(problem).maxSquare, limit*limit);
    EXPECT_TRUE(nscd::polishLoneDefects(problem, rule, {}));
    EXPECT_LE(nscd::residual(problem).maxSquare, limit*limit);
    EXPECT_EQ(column.awake.size(), static_cast<std::size_t>(size));
    int changed = 0;
    for (int k = 0; k < size; ++k) changed += k != contact && column.blocks[k].r[2][0] != size - k;
    EXPECT_GT(changed, 0);
    EXPECT_LE(changed, 8);   // three to each side of the one and its neighbors, which it has spoilt
}

TEST(LoneDefects, belowRoundOffAreReported)
{
    Column column = columnAtRest(60, 30, 2e-3);
    nscd::ContactProblem problem = column.problem();
    EXPECT_FALSE(nscd::polishLoneDefects(problem, {1e-2, 1.0, 1.0, 1e-20, 1e-20, 1.0, 1.0}, {}));
    EXPECT_EQ(column.awake.size(), 60u);
}

TEST(LoneDefects, belowTheLimitAreLeftAlone)
{
    Column column = columnAtRest(60, 30, 0.2*limit);
    nscd::ContactProblem problem = column.problem();
    EXPECT_TRUE(nscd::polishLoneDefects(problem, rule, {}));
    EXPECT_EQ(column.blocks[30].r[2][0], 30 - 0.2*limit);
}
