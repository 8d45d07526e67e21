// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A few contacts solved together: by the natural map of code of its own, and by what it does to the bodies.
#include "unit/nscd/scenes/randomProblem.hpp"

#include "nscd/solvers/help/clusterSolve.hpp"
#include "nscd/solvers/problem/localContact.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace scenes;
using nscd::Vec3;

namespace
{

constexpr int blocks = 6;

std::vector<std::uint32_t> slotsFrom(std::uint32_t first, int count)
{
    std::vector<std::uint32_t> slots(count);
    std::iota(slots.begin(), slots.end(), first);
    return slots;
}

double largestDefect(const nscd::ContactProblem& problem, const std::vector<std::uint32_t>& slots)
{
    double largest = 0.0;
    for (std::uint32_t slot : slots) largest = std::max(largest, nscd::localChange(problem, slot).defect);
    return largest;
}

} // namespace

TEST(ClusterSolve, meetsTheNaturalMapOfItsContacts)
{
    int solved = 0;
    for (std::uint32_t first = 0; first < 36; ++first)
    {
        RandomProblem random(blocks);
        nscd::ContactProblem problem = random.problem();
        const std::vector<std::uint32_t> slots = slotsFrom(first, 12);
        const double before = largestDefect(problem, slots);
        nscd::ClusterSolve(problem, slots).run(1e-9*before);
        const double after = largestDefect(problem, slots);
        EXPECT_LE(after, 3.0*before) << first;
        solved += after <= 3e-9*before;
    }
    EXPECT_GE(solved, 33);
}

// Velocities stay those of the impulses: what the contacts give is what the bodies get.
TEST(ClusterSolve, movesBodiesByItsImpulses)
{
    RandomProblem random(blocks);
    nscd::ContactProblem problem = random.problem();
    const std::vector<nscd::Body> bodies = random.bodies;
    const std::vector<nscd::ContactBlock> start = random.blocks;
    nscd::ClusterSolve(problem, slotsFrom(0, 16)).run(1e-9);
    std::vector<nscd::Body> expected = bodies;
    double largest = 0.0;
    for (std::size_t slot = 0; slot < 16; ++slot)
    {
        const nscd::ContactBlock &now = random.blocks[slot/nscd::blockLanes], &then = start[slot/nscd::blockLanes];
        const int lane = slot % nscd::blockLanes;
        const Vec3 n(now.n[0][lane], now.n[1][lane], now.n[2][lane]);
        const Vec3 r(now.r[0][lane] - then.r[0][lane], now.r[1][lane] - then.r[1][lane], now.r[2][lane] - then.r[2][lane]);
        nscd::Body &a = expected[now.a[lane]], &b = expected[now.b[lane]];
        const Vec3 turn = n.cross(r);
        for (int k = 0; k < 3; ++k)
        {
            a.v[k] += a.invMass*r[k];
            b.v[k] -= b.invMass*r[k];
            a.s[k] -= a.invSpin*turn[k];
            b.s[k] -= b.invSpin*turn[k];
        }
        largest = std::max(largest, r.norm());
    }
    EXPECT_GT(largest, 0.0);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        EXPECT_LT((Vec3(expected[i].v) - Vec3(random.bodies[i].v)).norm(), 1e-12) << i;
        EXPECT_LT((Vec3(expected[i].s) - Vec3(random.bodies[i].s)).norm(), 1e-12) << i;
    }
}
