// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Limits of the stop rule by their formulas.
#include "nscd/solvers/problem/stopRule.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr nscd::DefectSums nothing{0.0, 0.0, 0.0};

/// d = 1 m, dt = 1 ms, forces of 1 m/s; grains that move by `motion` of it.
nscd::StopRule ruleOf(double motion, const nscd::DefectSums& first = nothing, double speedScale = 1.0)
{
    Column column(1, Vec3::UnitZ());
    nscd::ContactProblem problem = column.problem();
    problem.motion = motion;
    problem.speedScale = speedScale;
    return nscd::makeStopRule(problem, nscd::ContactSettings(), first);
}

} // namespace

TEST(StopRule, limitsAreThoseOfTheSettings)
{
    const nscd::ContactSettings settings;
    const nscd::StopRule rule = ruleOf(1.0);
    EXPECT_DOUBLE_EQ(rule.speedScale, 1.0);
    EXPECT_DOUBLE_EQ(rule.rmsLimit, settings.tolerance);
    EXPECT_DOUBLE_EQ(rule.maxLimit, settings.displacementTolerance/1e-3);
    EXPECT_EQ(rule.polishedRms, rule.rmsLimit);
    EXPECT_EQ(rule.polishedMax, rule.maxLimit);
    EXPECT_EQ(rule.forceLimit, settings.forceTolerance);
    EXPECT_EQ(rule.polishedForce, rule.forceLimit);
}

TEST(StopRule, speedScaleIsThatOfForcesApproachOrDeadBand)
{
    EXPECT_DOUBLE_EQ(ruleOf(1.0, {4e8, 0.0, 1.0}).speedScale, 1e-3*2e4);
    EXPECT_DOUBLE_EQ(ruleOf(1.0, nothing, 0.0).speedScale, 1e-3*nscd::ContactSettings().deadBand/1e-3);
}

TEST(StopRule, aBedThatHardlyMovesIsPolished)
{
    const nscd::SolverStrategy::Polish polish;
    const nscd::StopRule resting = ruleOf(0.0), slow = ruleOf(0.05);
    EXPECT_DOUBLE_EQ(resting.polishedRms, polish.finest*resting.rmsLimit);
    EXPECT_DOUBLE_EQ(slow.polishedRms, polish.perMotion*0.05*slow.rmsLimit);
    EXPECT_DOUBLE_EQ(slow.polishedForce, polish.perMotion*0.05*slow.forceLimit);
    EXPECT_DOUBLE_EQ(slow.polishedMax, polish.perMotion*0.05*std::min(slow.maxLimit, polish.loneDefect*slow.rmsLimit));
}

TEST(StopRule, isMetWithinBothLimits)
{
    const nscd::StopRule rule{1.0, 3.0, 1.0, 0.1, 0.5, 1.0, 1.0};
    EXPECT_TRUE(rule.isMet({10.0, 9.0, 10.0}));
    EXPECT_FALSE(rule.isMet({10.1, 9.0, 10.0}));
    EXPECT_FALSE(rule.isMet({10.0, 9.1, 10.0}));
    EXPECT_FALSE(rule.isMet({NAN, 0.0, 1.0}));
    EXPECT_TRUE(rule.isPolished({0.1, 0.25, 10.0}));
    EXPECT_FALSE(rule.hasLoneDefects({0.1, 0.25, 10.0}));
    EXPECT_TRUE(rule.hasLoneDefects({0.1, 0.26, 10.0}));
    EXPECT_FALSE(rule.hasLoneDefects({0.11, 0.26, 10.0}));
}

TEST(StopRule, reportsSayWhatWasReached)
{
    // One contact is a quarter short: its grain falls at 1/4 m/s, and the one below is not pressed down by as much.
    Column column = columnAtRest(10, 4, 0.25);
    nscd::ContactProblem problem = column.problem();
    nscd::SolveReport report;
    nscd::reportResidual(report, {1.0, 3.0, 7.0, 0.1, 0.5, 1.0, 1.0}, problem);
    EXPECT_DOUBLE_EQ(report.residualRms, std::sqrt((0.5*0.5 + 2*0.25*0.25)/10));
    EXPECT_DOUBLE_EQ(report.residualMax, 0.5);
    EXPECT_EQ(report.speedScale, 7.0);
    EXPECT_EQ(report.contacts, 10u);
    EXPECT_TRUE(report.converged);
    nscd::reportResidual(report, {1.0, 0.4, 7.0, 0.1, 0.5, 1.0, 1.0}, problem);
    EXPECT_FALSE(report.converged);
}

// A column that falls as one has one defect, at its floor: rms says little of it, the work all.
TEST(StopRule, forceErrorIsTheShareThatHasNotComeDown)
{
    constexpr int size = 400;
    constexpr double missing = 0.125;   // of each grain's weight, so that all move at 1/8 m/s
    Column column(size, Vec3::UnitZ());
    const std::vector<Vec3> freeVelocity(size, -Vec3::UnitZ());
    for (int k = 0; k < size; ++k)
    {
        column.blocks[k].r[2][0] = (1 - missing)*(size - k);
        column.bodies[k].v[2] = -missing;
    }
    nscd::ContactProblem problem = column.problem();
    nscd::StopRule rule{1e-2, 1.0, 1.0, 1e-2, 1.0, 0.02, 0.02};
    nscd::SolveReport report;
    nscd::DefectSums left = nscd::reportResidual(report, rule, problem);
    EXPECT_TRUE(rule.isMet(left));
    EXPECT_EQ(report.forceError, 0.0);   // free velocities are not known
    EXPECT_TRUE(report.converged);
    problem.freeVelocity = &freeVelocity;
    left = nscd::reportResidual(report, rule, problem);
    EXPECT_NEAR(report.forceError, missing, 1e-12);
    EXPECT_FALSE(report.converged);
    rule.forceLimit = 0.2;
    nscd::reportResidual(report, rule, problem);
    EXPECT_TRUE(report.converged);
}

TEST(StopRule, tightensByTheExcessWithinBounds)
{
    nscd::StopRule rule{1.0, 3.0, 1.0, 0.1, 0.5, 0.01, 0.01};
    rule.tighten({4.0, 1.0, 10.0}, 1.5);
    EXPECT_DOUBLE_EQ(rule.rmsLimit, std::sqrt(0.4)/1.5);
    rule.tighten({40.0, 1.0, 10.0}, 100.0);
    EXPECT_DOUBLE_EQ(rule.rmsLimit, std::sqrt(0.4)/3);
    rule.tighten({40.0, 1.0, 10.0}, 1.01);
    EXPECT_DOUBLE_EQ(rule.rmsLimit, 0.8*std::sqrt(0.4)/3);
}
