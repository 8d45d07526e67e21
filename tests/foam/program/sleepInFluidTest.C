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

const std::string spheres = "grains { type table; file \"floor.txt\"; } ";
/// Six pairs of such spheres, each one body; the border goes through two of them.
const std::string clumps = "grains { type lattice; box (0.005 0.02 0) (0.095 0.08 0.01); count (3 2 1); diameter 0.01; "
    "clump { members ((-0.005 0 0) (0.005 0 0)); diameter 0.01; orientation asGiven; } } ";

/// Grains that do not roll, on a floor through which water flows: 0.05 m/s from floorFlow on, which lifts none, then enough to lift all.
Files onTheFloor(const std::string& sleep, const std::string& grains = spheres)
{
    return
    {
        {"constant/grainProperties",
            "materials { glass { density 2500; } } contacts { default { friction 0.3; rollingFriction 0.1; } } solver { sleep " + sleep + "; } forces { drag { law Gidaspow; } } "
            + grains + "patches { front { type wall; } back { type exit; } }"},
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

/// Of so many grains, members of clumps among them.
void expectWakesWithTheFlow(const std::string& grains, int number)
{
    const std::string control = "endTime 0.22; writeInterval 1000;";
    const ProgramCase sleeping(onTheFloor("on", grains), control), awake(onTheFloor("off", grains), control);
    const ProgramRun run = runOnTheFloor(sleeping);
    ASSERT_EQ(run.status, 0) << run.log;
    EXPECT_NE(run.log.find(std::to_string(number) + " grains asleep"), std::string::npos);
    ASSERT_EQ(runOnTheFloor(awake).status, 0);

    const std::vector<double> time = sleeping.reported("0", "time"), asleep = sleeping.reported("0", "asleep");
    const std::size_t begins = firstAfter(time, floorFlow), grows = firstAfter(time, liftingFlow);
    EXPECT_EQ(asleep[begins - 1], number);
    EXPECT_EQ(asleep[begins], 0);
    EXPECT_EQ(asleep[firstAfter(time, 0.18)], number) << "a flow that hardly changes and lifts none is slept in";
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

} // namespace

TEST(SleepInFluid, wakesInTheStepInWhichTheFlowBegins) { expectWakesWithTheFlow(spheres, 9); }
TEST(SleepInFluid, clumpsWakeSoToo) { expectWakesWithTheFlow(clumps, 12); }

// The border goes through three of the grains' centers.
void expectSleepOnRanksAsOnOne(const std::string& grains, int number)
{
    const std::string control = "endTime 0.22; writeInterval 1000;";
    const ProgramCase alone(onTheFloor("on", grains), control), together(onTheFloor("on", grains), control);
    ASSERT_EQ(runOnTheFloor(alone).status, 0);
    writeFloor(together);
    ASSERT_EQ(together.decompose(labelVector(2, 1, 1)).status, 0);
    const ProgramRun run = together.runOn(2);
    ASSERT_EQ(run.status, 0) << run.log;
    const std::vector<double> asleep = alone.reported("0", "asleep"), asleepTogether = together.reported("0", "asleep");
    EXPECT_EQ(asleepTogether, asleep);
    EXPECT_EQ(*std::max_element(asleep.begin(), asleep.end()), number);
    EXPECT_NEAR(together.reported("0", "massCenterZ").back(), alone.reported("0", "massCenterZ").back(), 1e-7);
}

TEST(Ranks, sleepInAFluidAsOnOne) { expectSleepOnRanksAsOnOne(spheres, 9); }
TEST(Ranks, clumpsSleepInAFluidAsOnOne) { expectSleepOnRanksAsOnOne(clumps, 12); }
