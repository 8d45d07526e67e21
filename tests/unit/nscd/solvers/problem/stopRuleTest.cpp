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
    EXPECT_DOUBLE_EQ(slow.polishedMax, polish.perMotion*0.05*std::min(slow.maxLimit, polish.loneDefect*slow.rmsLimit));
}

TEST(StopRule, isMetWithinBothLimits)
{
    const nscd::StopRule rule{1.0, 3.0, 1.0, 0.1, 0.5};
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
    nscd::SolveReport report;
    nscd::reportResidual(report, {1.0, 3.0, 7.0, 0.1, 0.5}, {40.0, 4.0, 10.0});
    EXPECT_DOUBLE_EQ(report.residualRms, 2.0);
    EXPECT_DOUBLE_EQ(report.residualMax, 2.0);
    EXPECT_EQ(report.speedScale, 7.0);
    EXPECT_EQ(report.contacts, 10u);
    EXPECT_FALSE(report.converged);
}
