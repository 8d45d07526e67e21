// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The guard against caps that are too small: when it acts, what it says, and a deep column it brings to rest.
#include "nscd/solvers/help/capGuard.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

nscd::ContactSettings capped(int maxSweeps)
{
    nscd::ContactSettings settings;
    settings.maxSweeps = maxSweeps;
    return settings;
}

/// Cap in force after so many steps that all ended at it, or all met the rule in a sweep.
int capAfter(nscd::CapGuard& guard, int steps, bool converged, const nscd::ContactSettings& settings)
{
    for (int k = 0; k < steps; ++k)
    {
        nscd::SolveReport report;
        report.converged = converged;
        report.sweeps = converged ? 1 : guard.apply(settings).maxSweeps;
        guard.note(report, settings);
    }
    return guard.apply(settings).maxSweeps;
}

} // namespace

TEST(CapGuard, doublesACapThatStepAfterStepEndsAt)
{
    const int patience = nscd::SolverStrategy().cap.patience;
    const nscd::ContactSettings settings = capped(30);
    nscd::CapGuard guard;
    EXPECT_EQ(capAfter(guard, patience - 1, false, settings), 30);
    EXPECT_EQ(capAfter(guard, 1, true, settings), 30);
    EXPECT_EQ(capAfter(guard, patience - 1, false, settings), 30);
    EXPECT_EQ(capAfter(guard, 1, false, settings), 60);
    EXPECT_EQ(capAfter(guard, 2*patience, false, settings), 240);
    EXPECT_EQ(capAfter(guard, 10*patience, false, settings), nscd::SolverStrategy().cap.enough);
    EXPECT_EQ(capAfter(guard, patience - 1, true, settings), nscd::SolverStrategy().cap.enough);
    EXPECT_EQ(capAfter(guard, 1, true, settings), 30);
}

TEST(CapGuard, leavesAloneWhatIsLargeEnoughOrWanted)
{
    nscd::CapGuard guard;
    EXPECT_EQ(capAfter(guard, 100, false, capped(1000)), 1000);
    EXPECT_EQ(capAfter(guard, 100, false, capped(5000)), 5000);
    nscd::ContactSettings fixed = capped(30);
    fixed.raiseCap = false;
    EXPECT_EQ(capAfter(guard, 100, false, fixed), 30);
}

TEST(CapGuard, saysBothCaps)
{
    nscd::SolveReport report;
    EXPECT_EQ(nscd::warning(report), "");
    report.userCap = 30;
    report.raisedCap = 120;
    const std::string text = nscd::warning(report);
    EXPECT_NE(text.find("30 sweeps"), std::string::npos) << text;
    EXPECT_NE(text.find("now 120"), std::string::npos) << text;
}

// A stack from cold, by a solver that no direct method helps.
TEST(CapGuard, actsOnTheStepsOfAScene)
{
    for (const bool raiseCap : {false, true})
    {
        Scene scene(3, 0.5, 0.0);
        for (int i = 0; i < 100; ++i) scene.addGrain(Vec3(0, 0, 0.01*(2*i + 1)), 0.01);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        nscd::ContactSettings settings = capped(5);
        settings.solver = "NNCG";
        settings.raiseCap = raiseCap;
        auto dynamics = scene.build(settings);
        int mostSweeps = 0, largestCap = 0;
        for (int k = 0; k < 20; ++k)
        {
            const nscd::StepReport report = step(dynamics, scene.g, 1e-3);
            mostSweeps = std::max(mostSweeps, report.solve.sweeps);
            largestCap = std::max(largestCap, report.solve.raisedCap);
        }
        EXPECT_EQ(mostSweeps > 5, raiseCap);
        EXPECT_EQ(largestCap > 5, raiseCap);
    }
}
