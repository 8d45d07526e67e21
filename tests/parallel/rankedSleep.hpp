// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes asleep on several ranks.
#pragma once

#include "rankedScene.hpp"

#include "unit/nscd/scenes/sleepSteps.hpp"

#include <gtest/gtest.h>

namespace scenes
{

constexpr int stepsToSleep = 112;

/// What a test does with a scene asleep, for each cut, with a roller that never rests and without: test(scene, withRoller).
template<class Test>
void withSleepers(Scene (*sceneOf)(bool withRoller), const std::vector<OwnerOf>& cuts, std::size_t sleepers, const Test& test)
{
    for (const bool withRoller : {false, true})
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
        SCOPED_TRACE("cut " + std::to_string(k) + (withRoller ? " with a roller" : ""));
        RankedScene scene(sceneOf(withRoller), fineEnoughToSleep(), cuts[k]);
        const nscd::StepReport report = run(scene.dynamics(), stepsToSleep);
        ASSERT_EQ(report.asleep, sleepers);
        EXPECT_EQ(report.solve.sweeps > 0, withRoller);
        test(scene, withRoller);
    }
}

} // namespace scenes
