// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The guard against caps that are too small: when it acts, what it says, and a deep column it brings to rest.
#include "capGuard.hpp"
#include "scenes.hpp"

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
    const int patience = nscd::CapGuard::patience;
    const nscd::ContactSettings settings = capped(30);
    nscd::CapGuard guard;
    EXPECT_EQ(capAfter(guard, patience - 1, false, settings), 30);
    EXPECT_EQ(capAfter(guard, 1, true, settings), 30);
    EXPECT_EQ(capAfter(guard, patience - 1, false, settings), 30);
    EXPECT_EQ(capAfter(guard, 1, false, settings), 60);
    EXPECT_EQ(capAfter(guard, 2*patience, false, settings), 240);
    EXPECT_EQ(capAfter(guard, 10*patience, false, settings), nscd::CapGuard::enough);
    EXPECT_EQ(capAfter(guard, patience - 1, true, settings), nscd::CapGuard::enough);
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

// A wall of spheres, staggered, 60 rows high, from cold: a cap of 4 sweeps lets it sink and bounce, whatever it starts from.
TEST(CapGuard, bringsADeepWallToRest)
{
    const auto kineticEnergy = [](bool raiseCap)
    {
        Scene scene(2, 0.5, 0.0);
        const double radius = 0.01, dt = 1e-3;
        const int rows = 60, perRow = 6;
        for (int row = 0; row < rows; ++row)
        {
            for (int i = 0; i < perRow; ++i) scene.addGrain(Vec3(radius*(2*i + 1 + row % 2), 0, radius*(1 + std::sqrt(3.0)*row)), radius);
        }
        scene.box.length = Vec3(2*radius*perRow, 0, 0);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        nscd::ContactSettings settings = capped(4);
        settings.raiseCap = raiseCap;
        settings.sleep = false;
        settings.accelerate = false;
        auto dynamics = scene.build(settings);
        for (int k = 0; k < 200; ++k) step(dynamics, scene.g, dt);
        return nscd::kineticEnergy(dynamics.grains())/(scene.grains.mass[0]*gravity*2*radius*rows*perRow);
    };
    EXPECT_GT(kineticEnergy(false), 1e-6);
    EXPECT_LT(kineticEnergy(true), 1e-12);
}
