// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains at rest in a fluid sleep, wake in the step in which the flow changes, and end where grains that never slept do.
#include "caseTools.H"
#include "programCase.H"

#include <algorithm>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr double floorFlow = 0.1, liftingFlow = 0.2;  // when the flow through the floor begins, and when it grows [s]

/// Nine grains that do not roll, on a floor through which water flows: 0.05 m/s from floorFlow on, which lifts none, then enough to lift all.
Files onTheFloor(const std::string& sleep)
{
    return
    {
        {"constant/grainProperties",
            "materials { glass { density 2500; } } contacts { default { friction 0.3; rollingFriction 0.1; } } solver { sleep " + sleep + "; } forces { drag { law Gidaspow; } } "
            "grains { type table; file \"floor.txt\"; } patches { front { type wall; } back { type exit; } }"},
        {"0/U",
            "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { "
            "\"(left|right|bottom|top)\" { type slip; } front { type uniformFixedValue; uniformValue table "
            "((0 (0 0 0)) (0.1 (0 0 0)) (0.101 (0 0 0.05)) (0.2 (0 0 0.05)) (0.201 (0 0 1))); value uniform (0 0 0); } "
            "back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }"}
    };
}

void writeFloor(const ProgramCase& c)
{
    std::ofstream file(c.path("constant/floor.txt"));
    for (int k = 0; k < 9; ++k) file << 0.03 + 0.02*(k % 3) << " " << 0.03 + 0.02*(k/3) << " 0.005 0.01\n";
}

ProgramRun runOnTheFloor(const ProgramCase& c)
{
    writeFloor(c);
    return c.run();
}

/// Row of the first step that ends after a time.
std::size_t firstAfter(const std::vector<double>& time, double moment)
{
    std::size_t row = 0;
    while (row < time.size() && time[row] < moment + 1e-9) ++row;
    return row;
}

} // namespace

TEST(SleepInFluid, wakesInTheStepInWhichTheFlowBegins)
{
    const std::string control = "endTime 0.22; writeInterval 1000;";
    const ProgramCase sleeping(onTheFloor("on"), control), awake(onTheFloor("off"), control);
    const ProgramRun run = runOnTheFloor(sleeping);
    ASSERT_EQ(run.status, 0) << run.log;
    EXPECT_NE(run.log.find("9 grains asleep"), std::string::npos);
    ASSERT_EQ(runOnTheFloor(awake).status, 0);

    const std::vector<double> time = sleeping.reported("0", "time"), asleep = sleeping.reported("0", "asleep");
    const std::size_t begins = firstAfter(time, floorFlow), grows = firstAfter(time, liftingFlow);
    EXPECT_EQ(asleep[begins - 1], 9);
    EXPECT_EQ(asleep[begins], 0);
    EXPECT_EQ(asleep[firstAfter(time, 0.18)], 9) << "a flow that hardly changes and lifts none is slept in";
    EXPECT_EQ(asleep[grows], 0);
    for (const double count : awake.reported("0", "asleep")) EXPECT_EQ(count, 0);

    const std::vector<double> height = sleeping.reported("0", "massCenterZ"), expected = awake.reported("0", "massCenterZ");
    const std::vector<double> force = sleeping.reported("0", "wallForceZ"), expectedForce = awake.reported("0", "wallForceZ");
    ASSERT_EQ(height.size(), expected.size());
    EXPECT_GT(expected.back(), 0.006);
    for (std::size_t k = 0; k < height.size(); ++k)
    {
        EXPECT_NEAR(height[k], expected[k], 1e-3*(expected[k] - 0.005) + 1e-8) << time[k];
        EXPECT_NEAR(force[k], expectedForce[k], 2e-3*std::abs(expectedForce[0])) << time[k];
    }
}

// The border goes through three of the grains' centers.
TEST(Ranks, sleepInAFluidAsOnOne)
{
    const std::string control = "endTime 0.22; writeInterval 1000;";
    const ProgramCase alone(onTheFloor("on"), control), together(onTheFloor("on"), control);
    ASSERT_EQ(runOnTheFloor(alone).status, 0);
    writeFloor(together);
    ASSERT_EQ(together.decompose(labelVector(2, 1, 1)).status, 0);
    const ProgramRun run = together.runOn(2);
    ASSERT_EQ(run.status, 0) << run.log;
    const std::vector<double> asleep = alone.reported("0", "asleep"), asleepTogether = together.reported("0", "asleep");
    EXPECT_EQ(asleepTogether, asleep);
    EXPECT_EQ(*std::max_element(asleep.begin(), asleep.end()), 9);
    EXPECT_NEAR(together.reported("0", "massCenterZ").back(), alone.reported("0", "massCenterZ").back(), 1e-7);
}
