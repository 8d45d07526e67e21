// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grain steps within a fluid step, as many as the grains' impacts ask for: dry and in a fluid, on ranks, over restarts.
#include "caseTools.H"
#include "programCase.H"
#include "rankRuns.H"

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Two swarms that fly into one another within a closed box.
const std::string swarms =
    "materials { bead { density 2500; } } contacts { default { friction 0.1; restitution 0.9; } } patches { front { type wall; } back { type wall; } } grains { "
    "left { type lattice; box (0 0 0) (0.05 0.1 0.1); count (3 5 5); diameter 0.015; jitter 0.3; velocity (1 0.1 0.2); } "
    "right { type lattice; box (0.05 0 0) (0.1 0.1 0.1); count (3 5 5); diameter 0.015; jitter 0.3; velocity (-1 0 0); } } ";
const std::string limited = swarms + "timeStep { maxGrainImpacts 0.1; } ";
const std::string steps = "deltaT 1e-3; writeControl timeStep; writeFormat binary; ";

Files with(const std::string& properties) { return {{"constant/grainProperties", properties}}; }

} // namespace

TEST(GrainSteps, areAsManyAsImpactsAskFor)
{
    for (const std::string fluid : {"", "fluid none;"})
    {
        SCOPED_TRACE(fluid);
        const ProgramCase free(with(swarms + fluid), steps + "endTime 0.03; writeInterval 30;"), bounded(with(limited + fluid), steps + "endTime 0.03; writeInterval 30;");
        ASSERT_TRUE(succeeds(free.run()));
        const ProgramRun run = bounded.run();
        ASSERT_TRUE(succeeds(run));
        EXPECT_TRUE(holds(run.log, {"at most 0.1 impacts of a grain", "grain steps: "}));
        EXPECT_EQ(largest(free.reported("0", "subCycles")), 1);
        EXPECT_GT(largest(free.reported("0", "impacts")), 0.4);
        const std::vector<double> cycles = bounded.reported("0", "subCycles"), impacts = bounded.reported("0", "impacts");
        // What an earlier step did not foresee the next one follows.
        for (std::size_t k = 1; k < cycles.size(); ++k) EXPECT_GE(cycles[k], std::floor(cycles[k - 1]*0.9)) << k;
        EXPECT_GT(largest(cycles), 4);
        EXPECT_LT(impacts.back(), 0.25);
    }
}

TEST(GrainSteps, goOnAsIfTheyHadNotStopped)
{
    for (const std::string fluid : {"", "fluid none;"})
    {
        SCOPED_TRACE(fluid);
        const ProgramCase whole(with(limited + fluid), steps + "endTime 0.02; writeInterval 10;"), parts(with(limited + fluid), steps + "endTime 0.01; writeInterval 10;");
        ASSERT_TRUE(succeeds(whole.run()));
        ASSERT_TRUE(succeeds(parts.run()));
        parts.writeControl(steps + "endTime 0.02; writeInterval 10;");
        ASSERT_TRUE(succeeds(parts.run()));
        EXPECT_GT(parts.reported("0.01", "subCycles").front(), 1);
        for (const char* file : {"position", "U", "omega"})
        {
            const std::string expected = whole.contents("0.02/lagrangian/grains/" + std::string(file));
            EXPECT_FALSE(expected.empty()) << file;
            EXPECT_TRUE(parts.contents("0.02/lagrangian/grains/" + std::string(file)) == expected) << file;
        }
    }
}

TEST(Ranks, takeAsManyGrainStepsAsOne)
{
    const std::string control = steps + "endTime 0.008; writeInterval 8;";
    const ProgramCase alone(with(limited), control);
    ASSERT_TRUE(succeeds(alone.run()));
    EXPECT_GT(largest(alone.reported("0", "subCycles")), 1);
    runOnTwoAndThree(with(limited), control, [&](const ProgramCase& together)
    {
        EXPECT_EQ(difference(alone, together, "subCycles", 8), 0);
        EXPECT_LT(difference(alone, together, "impacts", 8), 1e-12);
        EXPECT_LT(difference(alone, together, "massCenterX", 8), 1e-4*0.015);
    });
}
