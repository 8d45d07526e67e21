// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Parcels in runs of the program: they settle, resist and warm up as their real grains, are counted in both, and go on over restarts and ranks.
#include "caseTools.H"
#include "heatCase.H"
#include "rankRuns.H"
#include "writtenCase.H"
#include "writtenFields.H"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string closed = "patches { front { type wall; } back { type exit; } } ";
const std::string open = "patches { front { type exit; } back { type exit; } } ";

/// Heights of one grain that falls through water.
std::vector<double> fall(const std::string& more, double diameter, const std::string& coupling)
{
    const ProgramCase c
    (
        Files{{"constant/grainProperties", glassOnly + closed + coupling + "forces { drag { law DiFelice; } } grains { type table; file \"grain.txt\"; " + more + " }"}},
        "endTime 0.2; deltaT 2e-3; writeInterval 1000;"
    );
    std::ofstream(c.path("constant/grain.txt")) << "0.0625 0.0375 0.17 " << diameter << "\n";
    EXPECT_TRUE(succeeds(c.run()));
    return c.reported("0", "massCenterZ");
}

double lastSpeed(const std::vector<double>& heights) { return (heights[heights.size() - 2] - heights.back())/2e-3; }

/// A parcel in each cell, or its eight grains: the fluid fraction is the same everywhere.
std::string lattice(bool isCoarse, const std::string& motion)
{
    const std::string how = isCoarse ? "count (4 4 8); coarseGraining 2;" : "count (8 8 16);";
    return glassOnly + "motion " + motion + "; grains { type lattice; box (0 0 0) (0.1 0.1 0.2); diameter 0.006; " + how + " } ";
}

const std::string viscousFluid = "transportModel Newtonian; nu 1e-2; rho 1000;";

/// Held grains that fluid passes between walls that slip.
ProgramCase bed(bool isCoarse)
{
    const Files files
    {
        {"constant/grainProperties", lattice(isCoarse, "fixed") + closed}, {"constant/transportProperties", viscousFluid},
        {"system/fvSolution", solutionWith(8)},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0.1); boundaryField { "
            "\"(left|right|bottom|top)\" { type slip; } front { type fixedValue; value uniform (0 0 0.1); } back { type zeroGradient; } }"},
    };
    return ProgramCase(files, "endTime 0.02; writeInterval 20;");
}

/// All sides are periodic, and the mixture as a whole is held.
ProgramCase suspension(bool isCoarse)
{
    BoxMeshSettings box = programBox();
    box.patchTypes = wordList(6, word("cyclic"));
    const std::string cyclic = "boundaryField { \".*\" { type cyclic; } }";
    const Files files
    {
        {"constant/grainProperties", lattice(isCoarse, "free") + "meanFlow (0 0 0);"}, {"constant/transportProperties", viscousFluid},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);" + cyclic},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;" + cyclic},
    };
    return ProgramCase(files, "endTime 0.06; writeInterval 60;", box);
}

/// Slip of the grains against the fluid [m/s].
scalar slipOf(const ProgramCase& c)
{
    return (cellValues<vector>(c, "0.06/U")[0] - grainVectors(c, "0.06/lagrangian/grains/U")[0]).z();
}

/// Parcels and real grains that fall among one another, leave, and parcels that enter.
const std::string mixed = glassOnly + open + "forces { drag { law Beetstra; polydisperse on; } } grains { "
    "coarse { type lattice; box (0.01 0.01 0.01) (0.09 0.09 0.06); count (4 4 2); diameter 0.005; jitter 0.5; coarseGraining 2; velocity (0 0 -3); } "
    "fine { type lattice; box (0.01 0.01 0.06) (0.09 0.09 0.1); count (5 5 3); diameter 0.006; jitter 0.5; } "
    "pour { type entering; region { type box; box (0.01 0.01 0.12) (0.09 0.09 0.19); } rate 12000; velocity (0 0 -1); coarseGraining 2; diameter 0.004; } } ";

const std::string withoutKeyword = glassOnly + open + "forces { drag { law Beetstra; polydisperse on; } } grains {} ";

std::vector<std::string> filesThatDiffer(const ProgramCase& a, const ProgramCase& b, const std::string& time)
{
    std::vector<std::string> different;
    for (const char* file : {"U", "p_rgh", "alpha.fluid", "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/grains/omega", "lagrangian/grains/d",
        "lagrangian/grains/fFluid", "lagrangian/grains/dragDebt"})
    {
        const std::string path = time + "/" + file;
        if (a.contents(path).empty() || a.contents(path) != b.contents(path)) different.push_back(path);
    }
    return different;
}

/// In each row, real grains that are there and those that left are those that entered and those of the start.
void expectAllCounted(const ProgramCase& c, const std::string& start, double first)
{
    const std::vector<double> inside = c.reported(start, "realGrains"), out = c.reported(start, "realExited"), in = c.reported(start, "realEntered");
    ASSERT_FALSE(inside.empty());
    for (std::size_t k = 0; k < inside.size(); ++k) ASSERT_EQ(inside[k] + out[k], first + in[k]) << k;
}

constexpr double realAtStart = 32*8 + 75;

} // namespace

TEST(Parcels, settleAsOneOfTheirGrains)
{
    const std::vector<double> real = fall("", 1e-3, "feedback off; "), parcel = fall("coarseGraining 5;", 1e-3, "feedback off; ");
    const std::vector<double> big = fall("", 5e-3, "feedback off; ");
    ASSERT_EQ(real.size(), parcel.size());
    for (std::size_t k = 0; k < real.size(); ++k) EXPECT_NEAR(real[k], parcel[k], 1e-14) << k;
    EXPECT_GT(lastSpeed(big), 3*lastSpeed(real));
}

/// A parcel's own wake is taken out as a grain's is; what is left of it goes like the number of its grains (measured.md).
TEST(Parcels, thatAreAloneSettleNearlyAsOneOfTheirGrainsInAFluidThatFeelsThem)
{
    const double alone = lastSpeed(fall("", 1e-3, "feedback off; "));
    EXPECT_NEAR(lastSpeed(fall("", 1e-3, ""))/alone, 1, 0.01);
    EXPECT_NEAR(lastSpeed(fall("coarseGraining 2;", 1e-3, ""))/alone, 1, 0.03);
}

TEST(Parcels, resistAsTheBedOfTheirGrains)
{
    const ProgramCase parcels = bed(true), real = bed(false);
    EXPECT_TRUE(succeeds(parcels.run()));
    EXPECT_TRUE(succeeds(real.run()));
    const scalarField p = cellValues<scalar>(parcels, "0.02/p_rgh"), pReal = cellValues<scalar>(real, "0.02/p_rgh");
    EXPECT_GT(pReal[0], 100);
    EXPECT_LT(max(mag(p - pReal)), 1e-9*pReal[0]);
    const vector force = sum(grainVectors(parcels, "0.02/lagrangian/grains/fFluid")), forceReal = sum(grainVectors(real, "0.02/lagrangian/grains/fFluid"));
    EXPECT_LT(mag(force - forceReal), 1e-9*mag(forceReal));
}

TEST(Parcels, sinkInASuspensionAsTheirGrains)
{
    const ProgramCase parcels = suspension(true), real = suspension(false);
    EXPECT_TRUE(succeeds(parcels.run()));
    EXPECT_TRUE(succeeds(real.run()));
    EXPECT_GT(slipOf(real), 1e-3);
    EXPECT_NEAR(slipOf(parcels)/slipOf(real), 1, 1e-6);
}

TEST(Parcels, ofOneGrainAreThatGrainToTheBit)
{
    const auto falling = [](const std::string& more)
    {
        return Files{{"constant/grainProperties", glassOnly + closed + "forces { saffmanLift on; magnusLift on; } grains { type lattice; "
            "box (0.01 0.01 0.01) (0.09 0.09 0.09); count (5 5 4); diameter 0.012; jitter 0.7; spread 0.2; velocity (0.5 0 -1); omega (20 -30 10); " + more + " }"}};
    };
    const std::string control = "writeFormat binary; endTime 0.04; writeInterval 40;";
    const ProgramCase without(falling(""), control), with(falling("coarseGraining 1;"), control);
    EXPECT_TRUE(succeeds(without.run()));
    EXPECT_TRUE(succeeds(with.run()));
    EXPECT_EQ(filesThatDiffer(without, with, "0.04"), std::vector<std::string>());
    EXPECT_TRUE(without.contents("0.04/lagrangian/grains/coarseGraining").empty());
    EXPECT_TRUE(without.reported("0", "contacts").back() > 0);
}

TEST(Parcels, areCountedInBothUnits)
{
    const ProgramCase c(Files{{"constant/grainProperties", mixed}}, "endTime 0.3; deltaT 2e-3; writeInterval 1000;");
    const ProgramRun run = c.run();
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(holds(run.log, {"107 parcels of 1 to 8 grains = 331 grains of diameter 0.005 to 0.006 m, ", "parcels of 8 grains", " real grains"}));
    expectAllCounted(c, "0", realAtStart);
    EXPECT_GT(c.reported("0", "realExited").back(), 100);
    const std::vector<double> entered = c.reported("0", "entered"), waiting = c.reported("0", "waiting"), mass = c.reported("0", "enteredMass");
    // 12000 real grains a second are 1500 parcels, 3 a step.
    for (std::size_t k = 0; k < entered.size(); ++k) ASSERT_EQ(entered[k] + waiting[k], 3*(double(k) + 1));
    EXPECT_NEAR(mass.back(), c.reported("0", "realEntered").back()*2500*M_PI/6*6.4e-8, 1e-12);
}

TEST(Parcels, enterInWholeOnes)
{
    const ProgramCase c(dryFiles("fluid none; " + glassOnly + closed + "grains { type entering; region { type box; box (0.01 0.01 0.1) (0.09 0.09 0.19); } "
        "rate 80000; number 100; diameter 0.004; coarseGraining 2; }"));
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "entered").back(), 12);
    EXPECT_EQ(c.reported("0", "realEntered").back(), 96);
    const ProgramCase filled(dryFiles("fluid none; " + glassOnly + closed + "grains { type filling; region { type box; box (0 0 0) (0.1 0.1 0.1); } number 1000; "
        "diameter 0.004; coarseGraining 2; }"));
    EXPECT_TRUE(succeeds(filled.run()));
    EXPECT_EQ(filled.reported("0", "grains").back(), 125);
    EXPECT_NEAR(filled.reported("0", "grainVolume").back(), 1000*M_PI/6*6.4e-8, 1e-12);
}

/// Stopped and continued, the second time with a grainProperties that knows nothing of parcels.
TEST(Parcels, goOnFromAWrittenTimeToTheBit)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 10; ";
    const std::string stops = with(mixed, "rate 12000;", "rate 12000; duration 0.02;");
    const Files files{{"constant/grainProperties", stops}};
    const ProgramCase whole(files, control + "endTime 0.06;"), parts(files, control + "endTime 0.02;");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_TRUE(succeeds(parts.run()));
    parts.writeControl(control + "endTime 0.04;");
    EXPECT_TRUE(succeeds(parts.run()));
    parts.write("constant/grainProperties", withoutKeyword);
    parts.writeControl(control + "endTime 0.06;");
    EXPECT_TRUE(succeeds(parts.run()));
    EXPECT_EQ(filesThatDiffer(whole, parts, "0.06"), std::vector<std::string>());
    EXPECT_EQ(whole.reported("0", "realGrains").back(), parts.reported("0.04", "realGrains").back());
    EXPECT_EQ(whole.reported("0", "realExited").back(), parts.reported("0.04", "realExited").back());
    EXPECT_GT(whole.reported("0", "realExited").back(), 0);
}

TEST(Parcels, ofAnotherCaseStayParcels)
{
    const ProgramCase old(Files{{"constant/grainProperties", mixed}}, "writeFormat binary; endTime 0.02; deltaT 2e-3; writeInterval 10;");
    EXPECT_TRUE(succeeds(old.run()));
    const std::string fromTime = glassOnly + open + "grains { old { type time; case \"" + old.path("") + "\"; time latestTime; } "
        "more { type lattice; box (0.09 0.09 0.19) (0.1 0.1 0.2); count (1 1 1); diameter 0.001; } } ";
    const ProgramCase next(Files{{"constant/grainProperties", fromTime}});
    EXPECT_TRUE(succeeds(next.run()));
    EXPECT_EQ(next.reported("0", "realGrains").front() + next.reported("0", "realExited").front(), old.reported("0", "realGrains").back() + 1);
    EXPECT_GT(next.reported("0", "realGrains").front(), next.reported("0", "grains").front() + 100);
}

/// A fluid whose temperature does not move, at rest: Nu is 2, of grains of half the diameter.
TEST(Parcels, warmUpAsTheirGrains)
{
    const std::string heat = "heat { law RanzMarshall; fluid { heatCapacity 1e15; conductivity 0.6; } materials { glass { heatCapacity 840; temperature 350; } } }\n";
    const ProgramCase c
    (
        Files
        {
            {"constant/grainProperties", glassOnly + heat + closed + "motion fixed; grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.18); count (3 3 5); "
                "diameter 0.005; coarseGraining 2; } "},
            {"0/T", temperatureField("300")}, {"system/fvSolution", heatSolution()}, {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);"}
        },
        "endTime 10; writeInterval 100; deltaT 0.5;"
    );
    EXPECT_TRUE(succeeds(c.run()));
    const double expected = 300 + 50*std::exp(-6*2*0.6*10/(2500*840*2.5e-5));
    EXPECT_NEAR(c.reported("0", "grainTMin").back(), expected, 1e-8);
    EXPECT_NEAR(c.reported("0", "grainTMax").back(), expected, 1e-8);
}

TEST(Parcels, refuseBadInput)
{
    const auto isRefusedWith = [](const std::string& source, const std::string& more, const std::vector<std::string>& pieces)
    {
        return isRefused(ProgramCase(Files{{"constant/grainProperties", closed + more + "grains { " + source + " }"}}), pieces);
    };
    const std::string one = "type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.002; ";
    EXPECT_TRUE(isRefusedWith(one + "coarseGraining 0.5;", glassOnly, {"grains.coarseGraining", "0.5", "1000", "constant/grainProperties"}));
    EXPECT_TRUE(isRefusedWith(one + "coarseGrainig 5;", glassOnly, {"grains.coarseGrainig", "nearest: coarseGraining"}));
    const std::string few = "type filling; region { type box; box (0 0 0) (0.1 0.1 0.1); } number 100; diameter 0.002; coarseGraining 5; ";
    EXPECT_TRUE(isRefusedWith(few, glassOnly, {"grains.number", "is less than one parcel", "at least 125"}));
    const std::string sticky = "materials { glass { density 2500; } } contacts { default { friction 0.3; cohesion 1e-5; } } ";
    EXPECT_TRUE(isRefusedWith(one + "coarseGraining 5;", sticky, {"has cohesion", "parcels", "constant/grainProperties"}));
    const std::string heat = "heat { law Gunn; contacts on; fluid { heatCapacity 4182; conductivity 6; } "
        "materials { glass { heatCapacity 840; temperature 350; conductivity 1; youngModulus 7e10; } } }\n";
    EXPECT_TRUE(isRefusedWith(one + "coarseGraining 5;", glassOnly + heat, {"heat lets heat through contacts", "coarseGraining"}));
}

TEST(Ranks, haveTheParcelsOfOneRank)
{
    const Files files{{"constant/grainProperties", mixed}, {"system/fvSolution", solutionWith(8)}};
    const std::string control = "endTime 0.06; deltaT 2e-3; writeInterval 1000;";
    const ProgramCase alone(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    runOnTwoAndThree(files, control, [&](const ProgramCase& together)
    {
        expectAllCounted(together, "0", realAtStart);
        for (const char* column : {"realGrains", "realExited", "realEntered"}) EXPECT_EQ(alone.reported("0", column), together.reported("0", column)) << column;
        const std::vector<double> here = alone.reported("0", "massCenterZ"), there = together.reported("0", "massCenterZ");
        for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(here[k], there.at(k), 1e-6) << k;
    });
}

TEST(Ranks, goOnWithParcelsOnAnotherNumber)
{
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 10; ";
    const ProgramCase c(Files{{"constant/grainProperties", mixed}}, control + "endTime 0.02;");
    c.goOnOnFourOneAndTwo(control + "endTime 0.04;", control + "endTime 0.06;");
    for (const char* start : {"0", "0.02", "0.04"}) expectAllCounted(c, start, realAtStart);
    EXPECT_GT(c.reported("0.04", "realExited").back(), 0);
}
