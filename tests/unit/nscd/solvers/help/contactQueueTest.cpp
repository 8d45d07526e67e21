// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The queue of contacts: what it solves, what it visits, when it stops.
#include "nscd/solvers/help/contactQueue.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace scenes;

namespace
{

constexpr int size = 12;

} // namespace

TEST(ContactQueue, workedOffSolvesAColumn)
{
    Column column(size, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    nscd::ContactQueue queue(problem, problem.all());
    EXPECT_EQ(queue.slots().size(), static_cast<std::size_t>(size));
    EXPECT_EQ(queue.defective(1e-9), std::vector<std::uint32_t>{0});   // all others fall alike
    queue.work(queue.slots(), 1e-9, 1000000);
    EXPECT_TRUE(queue.defective(1e-9).empty());
    for (int k = 0; k < size; ++k) EXPECT_NEAR(column.blocks[k].r[2][0], size - k, 1e-6);
}

TEST(ContactQueue, visitsNeighborsOfWhatChangedAndNoOthers)
{
    Column column = columnAtRest(size, 6, 1e-3);
    nscd::ContactProblem problem = column.problem();
    nscd::ContactQueue queue(problem, problem.all());
    // The defect goes, and leaves less than the threshold with its two neighbors, which are looked at and left as they are.
    EXPECT_EQ(queue.work({6*nscd::blockLanes}, 0.6e-3, 1000), 3u);
    EXPECT_NEAR(column.blocks[6].r[2][0], size - 6, 1e-15);
    EXPECT_EQ(column.blocks[5].r[2][0], size - 5);
}

TEST(ContactQueue, stopsAfterTheVisitsAllowed)
{
    Column column(size, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    nscd::ContactQueue queue(problem, problem.all());
    EXPECT_EQ(queue.work(queue.slots(), 1e-9, 7), 7u);
    EXPECT_FALSE(queue.defective(1e-9).empty());
}

TEST(ContactQueue, isOfTheContactsOfARange)
{
    Column column(size, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    const std::vector<std::uint32_t> index = {3, 9};
    nscd::ContactQueue queue(problem, {index.data(), index.size()});
    EXPECT_EQ(queue.slots(), (std::vector<std::uint32_t>{3*nscd::blockLanes, 9*nscd::blockLanes}));
}

TEST(ContactQueue, refusesAVelocityThatIsNoNumber)
{
    Column column(size, Vec3::UnitZ());
    column.bodies[4].v[2] = NAN;
    nscd::ContactProblem problem = column.problem();
    nscd::ContactQueue queue(problem, problem.all());
    EXPECT_THROW(queue.work({4*nscd::blockLanes}, 1e-9, 10), std::runtime_error);
}
