// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heat on 2 to 4 ranks: the same as on one, balanced, and restarts on the same and on other numbers.
#include "caseTools.H"
#include "heatCase.H"
#include "rankRuns.H"

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const char* const columns[] = {"heatFluid", "heatGrains", "heatIn", "heatToGrains", "heatEntered", "fluidTMin", "fluidTMax", "grainTMin", "grainTMax"};

/// Values of the first steps: later, single grains part ways.
void expectSame(const ProgramCase& alone, const ProgramCase& together, double share)
{
    for (const char* column : columns)
    {
        const std::vector<double> here = alone.reported("0", column), there = together.reported("0", column);
        double size = 0;
        for (const double value : here) size = std::max(size, std::abs(value));
        for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(here.at(k), there.at(k), share*size) << column << ' ' << k;
    }
}

void expectBalance(const ProgramCase& c, const std::string& start)
{
    const std::vector<double> error = c.reported(start, "heatError"), fluid = c.reported(start, "heatFluid"), grains = c.reported(start, "heatGrains");
    EXPECT_FALSE(error.empty());
    for (std::size_t k = 0; k < error.size(); ++k) EXPECT_LT(std::abs(error[k]), 1e-13*(fluid[k] + grains[k])) << k;
}

} // namespace

TEST(Ranks, shareHeatAsOneRankHasIt)
{
    const ProgramCase alone(pouringFiles(), "endTime 0.04; deltaT 2e-3;");
    EXPECT_TRUE(succeeds(alone.run()));
    runOnTwoAndThree(pouringFiles(), "endTime 0.04; deltaT 2e-3;", [&](const ProgramCase& together)
    {
        expectSame(alone, together, 1e-8);
        expectBalance(together, "0");
    });
}

/// The stack is cut between two grains by two ranks and twice by three: a rank that kept heat from those of others would leave the top cold.
TEST(Ranks, letHeatThroughContactsBetweenThem)
{
    const std::string control = "endTime 0.1; deltaT 2e-3; writeInterval 100; writePrecision 15;";
    const ProgramCase alone(stackFiles(), control);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_GT(alone.reported("0", "grainTMin").back(), 310);
    runOnTwoAndThree(stackFiles(), control, [&](const ProgramCase& together)
    {
        for (const char* column : {"heatGrains", "heatHeld", "grainTMin"})
        {
            const std::vector<double> here = alone.reported("0", column), there = together.reported("0", column);
            ASSERT_EQ(here.size(), there.size());
            for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(there[k]/here[k], 1, 1e-5) << column << ' ' << k;
        }
        expectBalance(together, "0");
    });
}

TEST(Ranks, goOnWithHeatThroughContactsToTheBit)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 10; ";
    const ProgramCase whole(stackFiles(), control + "endTime 0.04;"), parts(stackFiles(), control + "endTime 0.02;");
    runWholeAndInParts(whole, parts, labelVector(1, 1, 2), control + "endTime 0.04;");
    EXPECT_EQ(filesThatDiffer(whole, parts, 2, "0.04", {"T", "lagrangian/grains/T"}), std::vector<std::string>());
}

TEST(Ranks, goOnWithHeatToTheBit)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 10; ";
    const ProgramCase whole(pouringFiles(), control + "endTime 0.04;"), parts(pouringFiles(), control + "endTime 0.02;");
    runWholeAndInParts(whole, parts, labelVector(1, 1, 2), control + "endTime 0.04;");
    EXPECT_EQ(filesThatDiffer(whole, parts, 2, "0.04", {"T", "lagrangian/grains/T"}), std::vector<std::string>());
}

TEST(Ranks, goOnWithHeatOnAnotherNumber)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 5; ";
    const ProgramCase c(pouringFiles(), control + "endTime 0.01;");
    c.goOnOnFourOneAndTwo(control + "endTime 0.02;", control + "endTime 0.03;");
    for (const char* start : {"0", "0.01", "0.02"}) expectBalance(c, start);
    const std::vector<double> before = c.reported("0", "heatGrains"), after = c.reported("0.01", "heatGrains");
    const std::vector<double> entered = c.reported("0.01", "heatEntered"), toGrains = c.reported("0.01", "heatToGrains");
    EXPECT_NEAR(after.at(0), before.back() + entered.at(0) + toGrains.at(0), 1e-12*before.back());
}
