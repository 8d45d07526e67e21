// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Residual, sweeps and waking of a contact problem against code of their own.
#include "nscd/solvers/problem/contactProblem.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

using namespace scenes;

namespace
{

Vec3 at(const double (&x)[3][nscd::blockLanes], int lane) { return Vec3(x[0][lane], x[1][lane], x[2][lane]); }

/// The natural map of all contacts, by the formulas beside residual().
nscd::DefectSums naturalMap(const RandomProblem& random)
{
    nscd::DefectSums sums{0.0, 0.0, 0.0};
    for (const nscd::ContactBlock& block : random.blocks)
    for (int lane = 0; lane < nscd::blockLanes; ++lane)
    {
        const nscd::Body& a = random.bodies[block.a[lane]];
        const nscd::Body& b = random.bodies[block.b[lane]];
        const Vec3 n = at(block.n, lane), r = at(block.r, lane), u = Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(n);
        const double rn = r.dot(n), un = u.dot(n), pn = std::max(0.0, rn - (un + block.bias[lane])*block.invWn[lane]);
        const Vec3 rt = r - rn*n, q = rt - block.invWt[lane]*(u - un*n);
        const Vec3 pt = std::min(1.0, block.friction[lane]*std::max(0.0, rn)/std::max(q.norm(), 1e-300))*q;
        const double normal = (rn - pn)/block.invWn[lane], tangential = (rt - pt).norm()/block.invWt[lane];
        const double square = normal*normal + tangential*tangential;
        sums.work += (pn - rn)/block.invWn[lane]*rn + rt.dot(pt - rt)/block.invWt[lane];
        const bool isActive = rn > 0.0 || pn > 0.0;
        sums.sumSquares += isActive ? square : 0.0;
        sums.active += isActive;
        sums.maxSquare = std::max(sums.maxSquare, square);
    }
    return sums;
}

} // namespace

TEST(ContactProblem, residualIsTheNaturalMap)
{
    RandomProblem random(20);
    nscd::ContactProblem problem = random.problem();
    for (int sweep = 0; sweep < 4; ++sweep)
    {
        const nscd::DefectSums expected = naturalMap(random), found = nscd::residual(problem);
        EXPECT_NEAR(found.sumSquares, expected.sumSquares, 1e-12*expected.sumSquares);
        EXPECT_NEAR(found.maxSquare, expected.maxSquare, 1e-12*expected.maxSquare);
        EXPECT_EQ(found.active, expected.active);
        EXPECT_NEAR(found.work, expected.work, 1e-12*expected.sumSquares);
        nscd::sweepActive(problem);
    }
    EXPECT_DOUBLE_EQ(nscd::rms({8.0, 9.0, 2.0}), 2.0);
    EXPECT_DOUBLE_EQ(nscd::rms({0.0, 0.0, 0.0}), 0.0);
}

TEST(ContactProblem, netImpulseIsWhatContactsMadeOfTheFreeVelocities)
{
    Column column = columnAtRest(5, 2, 0.25);
    const std::vector<Vec3> freeVelocity(5, -Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    problem.freeVelocity = &freeVelocity;
    EXPECT_DOUBLE_EQ(nscd::netImpulse(problem), 5.0);   // a quarter less on one body, a quarter more on another
    column.bodies[0].invMass = 0.0;                     // held: nothing moves it
    column.bodies[4].invMass = 0.5;
    EXPECT_DOUBLE_EQ(nscd::netImpulse(problem), 5.0);
}

TEST(ContactProblem, sweepsPassOverActiveBlocksAndHoldVelocitiesToImpulses)
{
    RandomProblem random(8);
    random.awake = {1, 4, 5};
    nscd::ContactProblem problem = random.problem();
    const std::vector<nscd::ContactBlock> before = random.blocks;
    Vec3 momentum = Vec3::Zero();
    for (const nscd::Body& body : random.bodies) momentum += Vec3(body.v)/body.invMass;
    nscd::sweepActive(problem);
    for (const nscd::Body& body : random.bodies) momentum -= Vec3(body.v)/body.invMass;
    EXPECT_LT(momentum.norm(), 1e-12);
    for (std::size_t k = 0; k < 8; ++k)
    {
        const bool isSame = std::equal(before[k].r[0], before[k].r[0] + 3*nscd::blockLanes, random.blocks[k].r[0]);
        EXPECT_EQ(isSame, k != 1 && k != 4 && k != 5) << k;
    }
}

TEST(ContactProblem, blocksBetweenRanksStandBehindInnerOnes)
{
    RandomProblem random(8);
    random.awake = {1, 4, 5};
    nscd::ContactProblem problem = random.problem();
    EXPECT_EQ(problem.inner().count, 3u);
    problem.interfaceBlock = 5;
    ASSERT_EQ(problem.inner().count, 2u);
    ASSERT_EQ(problem.interface().count, 1u);
    EXPECT_EQ(problem.interface()[0], 5u);
    EXPECT_EQ(problem.all().count, 8u);
    EXPECT_EQ(problem.active().count, 3u);
}

TEST(ContactProblem, blocksWakeWhenAContactShouldCarryAnImpulse)
{
    Column column(5, Vec3::UnitZ());
    column.awake = {3};
    nscd::ContactProblem problem = column.problem();
    EXPECT_TRUE(nscd::wakeBlocks(problem));   // all fall alike: the floor alone is met
    EXPECT_EQ(column.awake, (std::vector<std::uint32_t>{0, 3}));
    EXPECT_FALSE(nscd::wakeBlocks(problem));
    nscd::sweepActive(problem);
    EXPECT_TRUE(nscd::wakeBlocks(problem));   // the lowest stands, the next one falls on it
    EXPECT_EQ(column.awake, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(ContactProblem, impulsesAreReplacedByWhatIsAdmissibleAndVelocitiesFollow)
{
    Column column(1, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    std::vector<double> target(3*nscd::blockLanes, 0.0);
    target[2*nscd::blockLanes] = 0.25;
    nscd::replaceImpulses(problem, target);
    EXPECT_EQ(column.blocks[0].r[2][0], 0.25);
    EXPECT_EQ(column.bodies[0].v[2], -0.75);
    target[2*nscd::blockLanes] = -0.5;   // contacts do not pull
    nscd::replaceImpulses(problem, target);
    EXPECT_EQ(target[2*nscd::blockLanes], 0.0);
    EXPECT_EQ(column.bodies[0].v[2], -1.0);
}
