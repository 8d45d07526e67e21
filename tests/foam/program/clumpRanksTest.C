// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps on 2 to 4 ranks: the same motion as on one, in a fluid too, through exits, over restarts on the same and on other numbers.
#include "caseTools.H"
#include "rankRuns.H"

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Of the members, which the report counts.
constexpr double diameter = 0.014;

/// 36 clumps of three balls, each in the others, and 36 spheres beside them; 27 mm long, on cells of 25 mm.
const std::string pebble = "clump { members ((0 0 0) (0.007 0 0) (0.003 0.006 0.002)); diameter 0.014; }";
const std::string velocity = "velocity (0.2 0.1 -0.5); ";
const std::string bed = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } patches { front { type wall; } back { type exit; } } "
    "grains { clumps { type lattice; box (0 0 0) (0.1 0.1 0.1); count (3 3 4); diameter 0.024; jitter 0.3; " + velocity + pebble + " } "
    "single { type lattice; box (0 0 0.1) (0.1 0.1 0.16); count (4 4 2); diameter 0.02; jitter 0.5; " + velocity + "} } ";
const std::string wet = "forces { drag { law HoelzerSommerfeld; } } ";

const std::vector<std::string> clumpFiles =
{
    "lagrangian/grains/clump", "lagrangian/grains/memberCenter", "lagrangian/grains/dragDebt", "lagrangian/clumps/origId", "lagrangian/clumps/position",
    "lagrangian/clumps/U", "lagrangian/clumps/orientation", "lagrangian/clumps/angularMomentum", "lagrangian/clumps/mass"
};

Files bedFiles(bool isWet)
{
    if (!isWet) return dryFiles(bed + "fluid none;");
    return {{"constant/grainProperties", bed + wet}, {"system/fvSolution", solutionWith(8)}};
}

/// As on one rank.
void expectSameOnRanks(const Files& files, const std::string& control, const labelVector& parts, std::size_t smooth, double momentumError)
{
    const ProgramCase alone(files, control);
    ASSERT_TRUE(succeeds(alone.run()));
    EXPECT_GT(alone.reported("0", "contacts").back(), 15);
    const ProgramCase together(files, control);
    ASSERT_TRUE(succeeds(together.decompose(parts)));
    const ProgramRun run = together.runOn(cmptProduct(parts));
    ASSERT_TRUE(succeeds(run));
    expectSameMotion(alone, together, diameter, smooth);
    EXPECT_NE(run.log.find("140 spheres, those of 36 clumps included"), std::string::npos) << run.log;
    EXPECT_LE(largest(together.reported("0", "momentumError")), momentumError);
    const std::vector<double> one = alone.reported("0", "solidVolume"), several = together.reported("0", "solidVolume");
    ASSERT_EQ(one.size(), several.size());
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(several[k], one[k], 1e-12*one[k]) << k;
}

} // namespace

// Cut across the bed.
TEST(Ranks, moveClumpsAsOneRankDoes)
{
    expectSameOnRanks(bedFiles(false), "writeFormat binary; endTime 0.03; writeInterval 30;", labelVector(1, 1, 3), 15, 0);
}

// With a corner of four ranks in it.
TEST(Ranks, moveClumpsInAFluidAsOneRankDoes)
{
    expectSameOnRanks(bedFiles(true), "writeFormat binary; endTime 0.02; writeInterval 20;", labelVector(2, 2, 1), 12, 1e-9);
}

TEST(Ranks, goOnWithClumpsAsIfNeverStopped)
{
    const std::string control = "writeFormat binary; writeInterval 10; ";
    const ProgramCase whole(bedFiles(true), control + "endTime 0.02;"), parts(bedFiles(true), control + "endTime 0.01;");
    runWholeAndInParts(whole, parts, labelVector(2, 1, 1), control + "endTime 0.02;");
    EXPECT_GT(whole.reported("0", "contacts").at(9), 10);
    EXPECT_EQ(filesThatDiffer(whole, parts, 2, "0.02", clumpFiles), std::vector<std::string>());
}

TEST(Ranks, goOnWithClumpsOnAnotherNumber)
{
    const std::string control = "writeFormat binary; writeInterval 8; ";
    const ProgramCase whole(bedFiles(true), control + "endTime 0.024;"), parts(bedFiles(true), control + "endTime 0.008;");
    ASSERT_TRUE(succeeds(whole.run()));
    parts.goOnOnFourOneAndTwo(control + "endTime 0.016;", control + "endTime 0.024;");
    const std::vector<std::string> starts = {"0", "0.008", "0.016"};
    for (const char* column : {"massCenterX", "massCenterZ", "kineticEnergy", "solidVolume"})
    {
        const std::vector<double> expected = whole.reported("0", column), found = joined(parts, starts, column);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-2*largest(expected)) << column << " " << k;
    }
    EXPECT_EQ(joined(parts, starts, "grains"), whole.reported("0", "grains"));
}

// With the first of its members that does; what is left goes on.
TEST(Ranks, countClumpsThatLeaveAsOneRankDoes)
{
    const std::string rising = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } patches { front { type wall; } back { type exit; } } "
        "grains { type lattice; box (0 0 0.12) (0.1 0.1 0.2); count (3 3 3); diameter 0.024; velocity (0 0 3); " + pebble + " } ";
    for (const bool isWet : {false, true})
    {
        Files files = bedFiles(isWet);
        files["constant/grainProperties"] = rising + (isWet ? wet : "fluid none;");
        const std::string control = "writeInterval 15; endTime 0.015;";
        const ProgramCase alone(files, control), together(files, control);
        ASSERT_TRUE(succeeds(alone.run()));
        ASSERT_TRUE(succeeds(together.decompose(labelVector(2, 1, 1))));
        ASSERT_TRUE(succeeds(together.runOn(2)));
        for (const char* column : {"grains", "clumps", "exited"}) EXPECT_EQ(alone.reported("0", column), together.reported("0", column)) << isWet;
        EXPECT_GT(together.reported("0", "exited").back(), 20) << isWet;
        EXPECT_GT(together.reported("0", "clumps").back(), 0) << isWet;
        together.writeControl("endTime 0.017;");
        EXPECT_TRUE(succeeds(together.runOn(2)));
    }
}
