// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How long a solve goes on for forces, and what it asks for meanwhile.
#include "nscd/solvers/problem/forceRule.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double limit = 0.01, polished = 0.001;
const nscd::ContactSettings settings;

nscd::ForceRule makeRule(double forceLimit = limit) { return {{1e-2, 1.0, 1.0, 1e-2, 1.0, forceLimit, std::min(polished, forceLimit)}, settings}; }

/// A solution that meets the velocities after so many sweeps, its forces off by a share.
bool judge(nscd::ForceRule& rule, int sweeps, double forceError)
{
    nscd::SolveReport report;
    report.sweeps = sweeps;
    report.forceError = forceError;
    return rule.judge(report, {1e-6, 1e-6, 1.0});
}

/// A column that falls as one: an eighth of the weight has not come down, and the floor's contact alone tells.
class FallingAsOne
{
public:
    FallingAsOne()
    {
        for (int k = 0; k < size; ++k)
        {
            column_.blocks[k].r[2][0] = (1 - missing)*(size - k);
            column_.bodies[k].v[2] = -missing;
        }
    }

    nscd::ContactProblem problem(double motion)
    {
        nscd::ContactProblem problem = column_.problem();
        problem.freeVelocity = &freeVelocity_;
        problem.motion = motion;
        return problem;
    }

    static constexpr double missing = 0.125;

private:
    static constexpr int size = 400;
    Column column_{size, Vec3::UnitZ()};
    std::vector<Vec3> freeVelocity_ = std::vector<Vec3>(size, -Vec3::UnitZ());
};

} // namespace

TEST(ForceRule, seeksPolishedForcesForSomeSweepsThenTheLimit)
{
    nscd::ForceRule rule = makeRule();
    EXPECT_FALSE(judge(rule, 10, 0.5*limit));
    EXPECT_FALSE(rule.now().wereForcesOff);
    EXPECT_LT(rule.now().rmsLimit, rule.asked().rmsLimit);
    EXPECT_FALSE(judge(rule, 2*10 + settings.polishSweeps - 1, 0.5*limit));
    EXPECT_TRUE(judge(rule, 2*10 + settings.polishSweeps, 0.5*limit));
    EXPECT_FALSE(judge(rule, 500, 1.1*limit));
    EXPECT_TRUE(rule.now().wereForcesOff);
    nscd::ForceRule soon = makeRule();
    EXPECT_TRUE(judge(soon, 10, 0.5*polished));
    EXPECT_FALSE(soon.now().wereForcesOff);
}

TEST(ForceRule, forcesThatWereOffAreLookedAtWhereGrainsHardlyMove)
{
    FallingAsOne column;
    nscd::ContactProblem resting = column.problem(0.0), flowing = column.problem(1.0);
    const int due = 5*settings.strategy.forces.sweepsBetween;
    for (double forceLimit : {1.1*FallingAsOne::missing, 0.9*FallingAsOne::missing})
    {
        nscd::ForceRule rule = makeRule(forceLimit);
        EXPECT_FALSE(rule.areForcesMet(due, resting)) << "never judged";
        judge(rule, 10, 2*forceLimit);
        EXPECT_EQ(rule.areForcesMet(due, resting), forceLimit > FallingAsOne::missing);
        EXPECT_FALSE(rule.areForcesMet(due + 1, resting));
        EXPECT_FALSE(rule.areForcesMet(due, flowing));
    }
}

TEST(ForceRule, whatIsLookedAtIsToBePolishedForSomeSweeps)
{
    FallingAsOne column;
    nscd::ContactProblem resting = column.problem(0.0);
    const int met = 100;
    nscd::ForceRule rule = makeRule(1.1*FallingAsOne::missing);
    judge(rule, met, 2.0);
    ASSERT_LT(2*met + settings.polishSweeps, 3*met);
    EXPECT_FALSE(rule.areForcesMet(2*met, resting));
    EXPECT_TRUE(rule.areForcesMet(3*met, resting));
}

TEST(ForceRule, aFlowGivesForcesUp)
{
    FallingAsOne column;
    nscd::ContactProblem resting = column.problem(0.0), flowing = column.problem(1.0);
    const int last = nscd::lastSweepForForces(30, settings.strategy.forces);
    EXPECT_EQ(last, 30 + static_cast<int>(30*settings.strategy.forces.share));
    nscd::ForceRule rule = makeRule();
    EXPECT_FALSE(rule.areForcesGivenUp(last, flowing)) << "never judged";
    judge(rule, 30, 2*limit);
    EXPECT_FALSE(rule.areForcesGivenUp(last - 1, flowing));
    EXPECT_TRUE(rule.areForcesGivenUp(last, flowing));
    EXPECT_FALSE(rule.areForcesGivenUp(last, resting));
}
