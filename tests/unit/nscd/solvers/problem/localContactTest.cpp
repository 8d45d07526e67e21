// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One contact solved with all others held: Signorini's and Coulomb's conditions.
#include "nscd/solvers/problem/localContact.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

using namespace scenes;
using nscd::Vec3;

namespace
{

Vec3 at(const double (&x)[3][nscd::blockLanes], int lane) { return Vec3(x[0][lane], x[1][lane], x[2][lane]); }

Vec3 relativeVelocity(const RandomProblem& random, const nscd::ContactBlock& block, int lane)
{
    const nscd::Body& a = random.bodies[block.a[lane]];
    const nscd::Body& b = random.bodies[block.b[lane]];
    return Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(at(block.n, lane));
}

} // namespace

TEST(LocalContact, obeysSignoriniAndCoulomb)
{
    RandomProblem random(60);
    nscd::ContactProblem problem = random.problem();
    int open = 0, sticking = 0, sliding = 0;
    for (std::size_t slot = 0; slot < random.blocks.size()*nscd::blockLanes; ++slot)
    {
        nscd::ContactBlock& block = random.blocks[slot/nscd::blockLanes];
        const int lane = slot % nscd::blockLanes;
        nscd::apply(problem, slot, nscd::localChange(problem, slot));
        const Vec3 n = at(block.n, lane), r = at(block.r, lane), u = relativeVelocity(random, block, lane);
        const double rn = r.dot(n), gapSpeed = u.dot(n) + block.bias[lane];
        const Vec3 rt = r - rn*n, ut = u - u.dot(n)*n;
        EXPECT_GE(rn, -1e-14);
        EXPECT_GE(gapSpeed, -1e-13);
        EXPECT_NEAR(rn*gapSpeed, 0.0, 1e-13);
        EXPECT_LE(rt.norm(), 0.5*rn + 1e-13);
        EXPECT_LT((0.5*rn*ut + ut.norm()*rt).norm(), 1e-12);   // against the slip, and none where it sticks
        ++(rn <= 1e-14 ? open : ut.norm() > 1e-9 ? sliding : sticking);
        EXPECT_LT(nscd::localChange(problem, slot).defect, 1e-12);
    }
    EXPECT_GT(std::min({open, sticking, sliding}), 20) << open << ' ' << sticking << ' ' << sliding;
}

TEST(LocalContact, aLargerMobilityMakesAShorterStep)
{
    RandomProblem random(1);
    nscd::ContactProblem problem = random.problem();
    random.blocks[0].bias[3] = -2.0;   // well closed
    random.blocks[0].friction[3] = 100.0;
    const double wn = 1/random.blocks[0].invWn[3], wt = 1/random.blocks[0].invWt[3];
    const Vec3 whole(nscd::localChange(problem, 3).impulse), half(nscd::localChange(problem, 3, 2*wn, 2*wt).impulse);
    EXPECT_LT((half - 0.5*whole).norm(), 1e-14);
}

TEST(LocalContact, defectiveSlotsAreThoseAboveTheLimit)
{
    RandomProblem random(20);
    const nscd::ContactProblem problem = random.problem();
    for (double limit : {0.1, 1.0, 2.5})
    {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t slot = 0; slot < 20*nscd::blockLanes; ++slot)
        {
            if (nscd::localChange(problem, slot).defect > limit) expected.push_back(slot);
        }
        EXPECT_EQ(nscd::defectiveSlots(problem, problem.all(), limit), expected);
        EXPECT_FALSE(expected.empty());
    }
}
