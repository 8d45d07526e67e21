// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of reports: how those of several solves become one, and what users are warned of.
#include "unit/nscd/scenes/scenes.hpp"

#include "nscd/scene/stepWarnings.hpp"

#include <gtest/gtest.h>

using namespace scenes;

TEST(StepReport, takesTheWorkOfBothSolvesAndTheWorstOfWhatTheyReached)
{
    nscd::SolveReport first, second;
    first.sweeps = 7;
    first.converged = false;
    first.residualRms = 3e-3;
    first.hiddenMassRatio = 90.0;
    second.sweeps = 5;
    second.residualRms = 1e-3;
    const nscd::SolveReport both = nscd::worstOf(first, second);
    EXPECT_EQ(both.sweeps, 12);
    EXPECT_FALSE(both.converged);
    EXPECT_EQ(both.residualRms, 3e-3);
    EXPECT_EQ(both.hiddenMassRatio, 90.0);
    const nscd::SolveReport later = nscd::together(first, second);
    EXPECT_TRUE(later.converged);
    EXPECT_EQ(later.residualRms, 1e-3);
    EXPECT_EQ(later.sweeps, 12);
}

TEST(StepReport, warnsOfNothingWhereNothingIs)
{
    EXPECT_EQ(nscd::warning(nscd::SolveReport()), "");
}

TEST(StepReport, namesMassesThatDifferTooMuch)
{
    nscd::SolveReport report;
    report.hiddenMassRatio = 1e4;
    EXPECT_NE(nscd::warning(report).find("1:1e+04"), std::string::npos) << nscd::warning(report);
}

// A stack from cold, by a solver that no direct method helps: every step ends at the cap.
TEST(StepReport, warnsOfACapThatStepAfterStepEndsAt)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < 100; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.solver = "NNCG";
    settings.maxSweeps = 5;
    auto dynamics = scene.build(settings);
    for (int k = 1; k <= 6; ++k)
    {
        const nscd::SolveReport report = step(dynamics, scene.g, 1e-3).solve;
        EXPECT_FALSE(report.converged);
        EXPECT_EQ(report.stepsAtCap, k);
        EXPECT_EQ(nscd::warning(report).empty(), k < 5) << nscd::warning(report);
    }
}

/// One step of three grains between a floor and a lid that comes down, at a speed, in g dt, that the tolerance leaves room for: no impulse is ever enough.
nscd::SolveReport squeeze(double speedOfGrains, double speedOfBelt, double speedOfLid)
{
    Scene scene(3, 0.0, 0.0);
    for (int i = 0; i < 3; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
    for (Vec3& v : scene.grains.velocity) v = Vec3(speedOfGrains, 0, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3(0, 0, 0.06), -Vec3::UnitZ());
    const double closing = speedOfLid*scene.g.norm()*1e-3;
    scene.walls.setMotion(1, [closing](double time) { return nscd::WallPose(Eigen::Translation3d(0, 0, -closing*time)); });
    scene.walls.setSurfaceMotion(1, nscd::belt(Vec3(speedOfBelt, 0, 0)));
    auto dynamics = scene.build(nscd::ContactSettings());
    return step(dynamics, scene.g, 1e-3).solve;
}

// Where walls drive, the solve gives up, and says so, also where grains rest.
TEST(StepReport, boundsTheForcesOfABedThatABeltSlidesAlong)
{
    const nscd::SolveReport report = squeeze(0.0, 1.0, 0.015);
    EXPECT_FALSE(report.converged);
    EXPECT_FALSE(report.atCap);
    EXPECT_LT(report.sweeps, 200);
    EXPECT_TRUE(squeeze(0.0, 0.0, 0.015).atCap);
}

// The solve of a flow gives up, and says so.
TEST(StepReport, saysByHowMuchForcesOfAFlowAreOff)
{
    const nscd::SolveReport report = squeeze(1.0, 0.0, 0.025);
    EXPECT_FALSE(report.converged);
    EXPECT_FALSE(report.atCap);
    EXPECT_GT(report.forceError, 0.01);
    EXPECT_LT(report.sweeps, 200);
    ASSERT_EQ(nscd::warnings(report).size(), 1u);
    EXPECT_EQ(nscd::warnings(report)[0].kind, "forces off");
    EXPECT_EQ(nscd::warnings(report)[0].measure, report.forceError);
}

TEST(StepReport, namesFrictionThatIsHeldAndEnergyFromNowhere)
{
    nscd::SolveReport report;
    report.converged = false;
    report.isHeld = true;
    report.frictionOff = 0.25;
    ASSERT_EQ(nscd::warnings(report).size(), 1u);
    EXPECT_EQ(nscd::warnings(report)[0].kind, "friction held");
    EXPECT_EQ(nscd::warnings(report)[0].measure, 0.25);
    report.isHeld = false;
    report.atCap = true;
    report.createdEnergy = 3.0;
    ASSERT_EQ(nscd::warnings(report).size(), 1u);
    EXPECT_EQ(nscd::warnings(report)[0].kind, "energy from nowhere");
    EXPECT_EQ(nscd::warnings(report)[0].measure, 3.0);
    const nscd::SolveReport worst = nscd::worstOf(report, nscd::SolveReport());
    EXPECT_EQ(worst.createdEnergy, 3.0);
    EXPECT_FALSE(worst.isHeld);
}

TEST(WarningCounts, tellsStepsTheFirstAndTheWorstOfEachKind)
{
    nscd::WarningCounts counts;
    EXPECT_EQ(counts.lines(), "");
    EXPECT_TRUE(counts.count({"a", "text", 2.0, "m"}, 0.5));
    EXPECT_FALSE(counts.count({"a", "text", 7.0, "m"}, 1.0));
    EXPECT_FALSE(counts.count({"a", "text", 3.0, "m"}, 1.5));
    EXPECT_TRUE(counts.count({"b", "text", 1.0, "J"}, 2.0));
    EXPECT_EQ(counts.lines(), "  a                      3 steps, first at 0.5 s, worst 7 m\n  b                      1 steps, first at 2 s, worst 1 J\n");
}
