// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam on 2 to 4 ranks with grains that enter: the same as on one rank, and restarts on the same and on other numbers.
#include "caseTools.H"
#include "rankRuns.H"

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string glass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } "
    "patches { front { type exit; } back { type exit; } } ";

/// One source finds room at once, the other fills a small place; both reach across any cut.
const std::string sources = "grains { pour { type entering; region { type box; box (0.01 0.01 0.1) (0.09 0.09 0.19); } rate 1500; "
    "velocity (0 0 -1); sizes { type uniform; min 0.004; max 0.008; } } "
    "narrow { type entering; region { type sphere; center (0.05 0.05 0.03); radius 0.015; } massRate 20; velocity (0 0 -1); diameter 0.009; seed 7; } } ";

const std::string control = "writeFormat binary; deltaT 2e-3; ";
const char* const counts[] = {"grains", "exited", "entered", "enteredMass", "waiting", "waitingMass"};

Files coupled() { return {{"constant/grainProperties", glass + sources}, {"system/fvSolution", solutionWith(8)}}; }

void expectSameCounts(const ProgramCase& alone, const ProgramCase& together, const std::vector<std::string>& starts = {"0"})
{
    for (const char* column : counts) EXPECT_EQ(alone.reported("0", column), joined(together, starts, column)) << column;
}

} // namespace

TEST(Ranks, letInTheGrainsThatOneRankLetsIn)
{
    for (const Files& files : {coupled(), dryFiles("fluid none; " + glass + sources)})
    {
        const ProgramCase alone(files, control + "endTime 0.06;");
        EXPECT_TRUE(succeeds(alone.run()));
        EXPECT_GT(alone.reported("0", "waiting").back(), 10);
        EXPECT_GT(alone.reported("0", "exited").back(), 5);
        for (const labelVector& parts : {labelVector(2, 1, 1), labelVector(1, 1, 3), labelVector(2, 2, 1)})
        {
            const label ranks = cmptProduct(parts);
            SCOPED_TRACE(ranks);
            const ProgramCase together(files, control + "endTime 0.06;");
            EXPECT_TRUE(succeeds(together.decompose(parts)));
            EXPECT_TRUE(succeeds(together.runOn(ranks)));
            expectSameCounts(alone, together);
            const std::vector<double> here = alone.reported("0", "massCenterZ"), there = together.reported("0", "massCenterZ");
            for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(here[k], there[k], 1e-6) << k;
            for (const double error : together.reported("0", "momentumError")) EXPECT_LT(error, 1e-9);
            const std::vector<double> solid = alone.reported("0", "solidVolume"), solidThere = together.reported("0", "solidVolume");
            for (std::size_t k = 0; k < solid.size(); ++k) EXPECT_NEAR(solid[k], solidThere.at(k), 1e-12*solid[k]) << k;
        }
    }
}

/// Through a patch by the flux, with the fluid's velocity, and in a zone of cells.
TEST(Ranks, letInTheGrainsThatOneRankLetsInAtPatchesAndInZones)
{
    const std::string row = "(0 0 0) (0 0 0.05) (0 0 0.1) (0 0 0.3) ";
    const std::string meshSources = "grains { carried { type entering; region { type patch; patch front; by flux; } rate 3000; diameter 0.004; velocity fluid; } "
        "fed { type entering; region { type cellZone; cellZone feed; } rate 1000; diameter 0.005; } } ";
    Files files{{"constant/grainProperties", "materials { glass { density 2500; } } contacts { default { friction 0.3; } } "
        "patches { front { type wall; } back { type exit; } } " + meshSources}, {"system/fvSolution", solutionWith(8)}};
    files["0/U"] = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \"(left|right|bottom|top)\" { type noSlip; } "
        "front { type fixedValue; value nonuniform List<vector> 16(" + row + row + row + row + "); } back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }";
    files["system/topoSetDict"] = "actions ( { name some; type cellSet; action new; source boxToCell; box (0 0 0.1) (0.1 0.06 0.2); } "
        "{ name feed; type cellZoneSet; action new; source setToCellZone; set some; } );";
    const ProgramCase alone(files, control + "endTime 0.04;");
    EXPECT_TRUE(succeeds(alone.run("topoSet")));
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_GT(alone.reported("0", "entered").back(), 50);
    for (const labelVector& parts : {labelVector(2, 1, 1), labelVector(1, 1, 3), labelVector(2, 2, 1)})
    {
        SCOPED_TRACE(cmptProduct(parts));
        const ProgramCase together(files, control + "endTime 0.04;");
        EXPECT_TRUE(succeeds(together.run("topoSet")));
        EXPECT_TRUE(succeeds(together.decompose(parts)));
        EXPECT_TRUE(succeeds(together.runOn(cmptProduct(parts))));
        expectSameCounts(alone, together);
        for (const char* column : {"massCenterX", "massCenterZ"})
        {
            const std::vector<double> here = alone.reported("0", column), there = together.reported("0", column);
            for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(here[k], there.at(k), 1e-6) << column << ' ' << k;
        }
    }
}

TEST(Ranks, goOnLettingGrainsInToTheBit)
{
    const ProgramCase whole(coupled(), control + "writeInterval 10; endTime 0.04;"), parts(coupled(), control + "writeInterval 10; endTime 0.02;");
    runWholeAndInParts(whole, parts, labelVector(1, 1, 3), control + "writeInterval 10; endTime 0.04;");
    EXPECT_EQ(filesThatDiffer(whole, parts, 3, "0.04", {"U", "p_rgh", "alpha.fluid"}), std::vector<std::string>());
    expectSameCounts(whole, parts, {"0", "0.02"});
}

/// Four ranks, one, and two, against one rank all the time.
TEST(Ranks, goOnLettingGrainsInOnAnotherNumber)
{
    const ProgramCase whole(coupled(), control + "writeInterval 10; endTime 0.06;"), parts(coupled(), control + "writeInterval 10; endTime 0.02;");
    EXPECT_TRUE(succeeds(whole.run()));
    parts.goOnOnFourOneAndTwo(control + "writeInterval 10; endTime 0.04;", control + "writeInterval 10; endTime 0.06;");
    expectSameCounts(whole, parts, {"0", "0.02", "0.04"});
}

/// All enter in one rank's part of the mesh, first one of them, which no two ranks can share, then many.
TEST(Ranks, shareGrainsThatEnterInOnePart)
{
    const std::string properties = glass + "grains { type entering; region { type box; box (0.01 0.01 0.11) (0.09 0.09 0.19); } rate table ((0 100) (0.012 100) (0.013 2e4) (1 2e4)); "
        "number 400; "
        "diameter 0.005; }";
    const ProgramCase alone(dryFiles("fluid none; " + properties), "endTime 0.05;"), together(dryFiles("fluid none; " + properties), "endTime 0.05;");
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(1, 1, 2))));
    const ProgramRun run = together.runOn(2);
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(holds(run.log, {"grains shared out anew: largest over mean load of the ranks 1"}));
    EXPECT_EQ(together.reported("0", "entered").back(), 400);
    expectSameCounts(alone, together);
}
