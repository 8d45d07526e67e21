// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Times of parts of a step: a part within another is taken out of it, and all that a run's steps do is in one of them.
#include "nscd/base/stepTimes.hpp"

#include "unit/nscd/scenes/scenes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <thread>
#include <vector>

using nscd::GrainPart;

namespace
{

using Clock = std::chrono::steady_clock;

void pass(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

} // namespace

TEST(StepTimes, noSecondCountsTwice)
{
    nscd::StepTimes times;
    const Clock::time_point start = Clock::now();
    double inside = 0.0;
    {
        const auto outer = times.time(GrainPart::moveGrains);
        pass(2);
        const Clock::time_point entered = Clock::now();
        {
            const auto inner = times.time(GrainPart::rebound);
            pass(20);
        }
        inside = secondsSince(entered);
        pass(2);
    }
    const double all = secondsSince(start);
    EXPECT_GE(times.seconds(GrainPart::rebound), 0.02);
    EXPECT_LE(times.seconds(GrainPart::rebound), inside);
    EXPECT_GE(times.seconds(GrainPart::moveGrains), 0.004);
    EXPECT_LE(times.total(), all);
    EXPECT_GE(times.total(), all - 1e-3);
    EXPECT_EQ(times.seconds(GrainPart::findPairs), 0.0);
}

TEST(StepTimes, nothingIsMeasuredWithoutThem) { const nscd::StepTimes::Timer timer(nullptr, GrainPart::sleep); }

TEST(StepTimes, whatCameSinceACopy)
{
    nscd::StepTimes times;
    { const auto timer = times.time(GrainPart::sleep); pass(2); }
    const nscd::StepTimes copy = times;
    { const auto timer = times.time(GrainPart::findPairs); pass(2); }
    EXPECT_EQ(times.since(copy).seconds(GrainPart::sleep), 0.0);
    EXPECT_GE(times.since(copy).seconds(GrainPart::findPairs), 0.002);
}

TEST(StepTimes, partsAddUpToTheStepsOfABedThatRebounds)
{
    scenes::Scene scene(3, 0.3, 0.5);
    std::mt19937 random(1);
    scene.scatter(std::vector<double>(200, 1e-3), nscd::Vec3(2e-2, 2e-2, 2e-2), random);
    scene.addOpenBox(2e-2);
    auto dynamics = scene.build(nscd::ContactSettings());
    const Clock::time_point start = Clock::now();
    for (int k = 0; k < 50; ++k) scenes::step(dynamics, scene.g, 1e-3);
    const double all = secondsSince(start);
    const nscd::StepTimes& times = dynamics.times();
    EXPECT_LE(times.total(), all);
    for (GrainPart part : {GrainPart::findPairs, GrainPart::updateGeometry, GrainPart::buildContacts, GrainPart::solveContacts, GrainPart::judgeContacts,
        GrainPart::rebound, GrainPart::moveGrains}) EXPECT_GT(times.seconds(part), 0.0) << nscd::grainPartNames[static_cast<int>(part)];
}
