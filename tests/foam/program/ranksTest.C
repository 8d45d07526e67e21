// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam on 2 to 4 ranks: the same grains as on one, restarts on the same and on other numbers, and what is refused.
#include "caseTools.H"
#include "programCase.H"
#include "rankRuns.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr double diameter = 0.023;

const std::string glass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid none;";
const std::string closed = "patches { front { type wall; } back { type exit; } }";

const std::string wetGlass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } }";

/// 64 spheres that fall onto the floor and each other.
const std::string lattice = "grains { type lattice; box (0 0 0) (0.1 0.1 0.1); count (4 4 4); diameter 0.023; spread 0.04; jitter 0.7; "
    "velocity (0.1 0.05 -0.5); }";
const std::string heap = glass + lattice;
const std::string wetHeap = wetGlass + lattice;

/// Contacts of grains with walls in one folder's written time: ids of grain and wall region.
std::set<std::pair<label, label>> wallContacts(const ProgramCase& c, const std::string& time)
{
    const auto read = [&](const std::string& field)
    {
        IFstream is(c.path(time + "/lagrangian/contacts/" + field));
        token head(is);
        const dictionary header(is);
        return labelList(is);
    };
    const labelList idA = read("idA"), idB = read("idB");
    std::set<std::pair<label, label>> contacts;
    forAll(idA, k)
    {
        if (idB[k] < 0) contacts.emplace(idA[k], idB[k]);
    }
    return contacts;
}

} // namespace

TEST(Ranks, moveTheGrainsOfABoxAsOneRankDoes)
{
    const std::string control = "writeFormat binary; endTime 0.014; writeInterval 14;";
    const ProgramCase alone(dryFiles(heap + closed), control);
    EXPECT_TRUE(succeeds(alone.run()));
    // Cut across the heap; with parts of the mesh that hold no grain; with a corner of four ranks in the heap.
    for (const labelVector& parts : {labelVector(2, 1, 1), labelVector(1, 1, 3), labelVector(2, 2, 1)})
    {
        const label ranks = cmptProduct(parts);
        SCOPED_TRACE(ranks);
        const ProgramCase together(dryFiles(heap + closed), control);
        EXPECT_TRUE(succeeds(together.decompose(parts)));
        EXPECT_TRUE(succeeds(together.runOn(ranks)));
        expectSameMotion(alone, together, diameter, 8);
        if (ranks != 3) continue;

        const ProgramCase again(dryFiles(heap + closed), control);
        EXPECT_TRUE(succeeds(again.decompose(parts)));
        EXPECT_TRUE(succeeds(again.runOn(ranks)));
        EXPECT_EQ(again.contents("postProcessing/grains/0/report.csv"), together.contents("postProcessing/grains/0/report.csv"));
        EXPECT_EQ(filesThatDiffer(again, together, ranks, again.latestTime("processor0")), std::vector<std::string>());
    }
}

TEST(Ranks, numberTheWallsAsOneRankDoes)
{
    // Two of the sides are slanted, one is bent, and cuts run through all of them.
    BoxMeshSettings box = programBox();
    box.movePoint = [](const point& x) { return point(x.x() + 0.2*x.z(), x.y() - 0.1*std::abs(x.x() - 0.05), x.z()); };
    const Files files = dryFiles
    (
        glass + closed + "grains { type lattice; box (0.02 0 0.01) (0.1 0.094 0.09); count (4 4 4); diameter 0.0195; spread 0.04; jitter 0.7; "
        "velocity (0.8 0.6 -0.4); }"
    );
    const std::string control = "endTime 0.02; deltaT 2e-3; writeInterval 10;";
    const ProgramCase alone(files, control, box), together(files, control, box);
    const ProgramRun serial = alone.run();
    EXPECT_TRUE(succeeds(serial));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 2))));
    const ProgramRun parallel = together.runOn(4);
    EXPECT_TRUE(succeeds(parallel));
    const std::size_t at = serial.log.find("  walls");
    EXPECT_TRUE(holds(parallel.log, {serial.log.substr(at, serial.log.find('\n', at) - at)}));

    const auto expected = wallContacts(alone, "0.02");
    std::set<std::pair<label, label>> found;
    std::set<label> regions;
    for (label rank = 0; rank < 4; ++rank)
    {
        for (const auto& contact : wallContacts(together, "processor" + std::to_string(rank) + "/0.02")) found.insert(contact);
    }
    for (const auto& contact : expected) regions.insert(contact.second);
    EXPECT_GE(regions.size(), 4u);
    std::vector<std::pair<label, label>> different;
    std::set_symmetric_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(different));
    EXPECT_LT(different.size(), expected.size()/10) << expected.size();
}

TEST(Ranks, shareAPeriodicBox)
{
    BoxMeshSettings box = programBox();
    box.patchTypes = {"cyclic", "cyclic", "cyclic", "cyclic", "wall", "patch"};
    const std::string properties = heap + "patches { back { type exit; } }", control = "endTime 0.008; writeInterval 8;";
    const ProgramCase alone(dryFiles(properties), control, box), together(dryFiles(properties), control, box);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 2, 1))));
    EXPECT_TRUE(succeeds(together.runOn(4)));
    expectSameMotion(alone, together, diameter, 8);
}

namespace
{

/// Discs or spheres one cell deep, on one rank and on three.
void expectSameInAPlane(const std::string& shape)
{
    BoxMeshSettings box = programBox();
    box.cells = labelVector(6, 6, 1);
    box.max = point(0.1, 0.2, 0.02);
    box.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    Files files = dryFiles
    (
        shape + glass + "grains { type lattice; box (0 0 0) (0.1 0.15 0.02); count (6 9 1); diameter 0.0155; spread 0.03; jitter 0.5; "
        "velocity (0.1 -0.5 0); }"
    );
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);";
    const std::string control = "endTime 0.008; writeInterval 8;";
    const ProgramCase alone(files, control, box), together(files, control, box);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(3, 1, 1))));
    EXPECT_TRUE(succeeds(together.runOn(3)));
    const std::size_t steps = 8;
    EXPECT_EQ(difference(alone, together, "grains", steps), 0);
    for (const char* axis : {"X", "Y"})
    {
        const std::string center = std::string("massCenter") + axis, force = std::string("wallForce") + axis;
        EXPECT_LT(difference(alone, together, center, steps), 1e-4*0.0155) << axis;
        EXPECT_LT(difference(alone, together, force, steps), 0.01*largest(alone.reported("0", "wallForceY"))) << axis;
    }
    EXPECT_EQ(difference(alone, together, "massCenterZ", steps), 0);
}

} // namespace

TEST(Ranks, shareDiscs)
{
    expectSameInAPlane("");
}

TEST(Ranks, shareSpheresInAPlane)
{
    expectSameInAPlane("shape sphere; ");
}

TEST(Ranks, takeOutGrainsThatLeaveAndGoOnWithoutAny)
{
    // Fast enough to shorten the step, on all ranks alike.
    const Files files = dryFiles(with(heap, "(0.1 0.05 -0.5)", "(0 0 20)") + closed + "timeStep { maxGrainDisplacement 0.5; }");
    const std::string control = "adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.01;";
    const ProgramCase alone(files, control), together(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(1, 1, 2))));
    EXPECT_TRUE(succeeds(together.runOn(2)));
    for (const char* column : {"grains", "exited"}) EXPECT_EQ(alone.reported("0", column), together.reported("0", column));
    EXPECT_LT(difference(alone, together, "deltaT", alone.reported("0", "deltaT").size()), 1e-12);
    EXPECT_LT(together.reported("0", "deltaT").at(5), 0.7e-3);
    EXPECT_EQ(together.reported("0", "exited").back(), 64);
    EXPECT_GT(together.reported("0", "exited").at(10), 0);
    EXPECT_LT(together.reported("0", "exited").at(10), 64);
    together.writeControl("endTime 0.012;");
    EXPECT_TRUE(succeeds(together.runOn(2)));
    EXPECT_EQ(together.reported("0.01", "exited").back(), 64);
}

TEST(Ranks, mayOutnumberTheGrains)
{
    const Files files = dryFiles
    (
        glass + closed + "grains { type lattice; box (0 0 0) (0.1 0.1 0.05); count (2 1 1); diameter 0.0499; velocity (0 0 -1); }"
    );
    const ProgramCase alone(files), together(files);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(4, 1, 1))));
    EXPECT_TRUE(succeeds(together.runOn(4)));
    expectSameMotion(alone, together, diameter, 10);
}

TEST(Ranks, goOnFromAWrittenTimeAsIfNeverStopped)
{
    const std::string control = "writeFormat binary; writeInterval 6; ";
    const ProgramCase whole(dryFiles(heap + closed), control + "endTime 0.012;"), parts(dryFiles(heap + closed), control + "endTime 0.006;");
    runWholeAndInParts(whole, parts, labelVector(2, 1, 1), control + "endTime 0.012;");
    EXPECT_EQ(parts.reported("0.006", "time").size(), 6u);
    EXPECT_GT(whole.reported("0", "contacts").at(5), 10);
    EXPECT_EQ(filesThatDiffer(whole, parts, 2, "0.012"), std::vector<std::string>());
}

TEST(Ranks, goOnOnAnotherNumberWithTheImpulses)
{
    const std::string control = "writeFormat binary; writeInterval 5; ";
    const ProgramCase whole(dryFiles(heap + closed), control + "endTime 0.015;"), parts(dryFiles(heap + closed), control + "endTime 0.005;");
    EXPECT_TRUE(succeeds(whole.run()));
    parts.goOnOnFourOneAndTwo(control + "endTime 0.01;", control + "endTime 0.015;");

    const std::vector<std::string> starts = {"0", "0.005", "0.01"};
    const std::vector<double> force = whole.reported("0", "wallForceZ"), center = whole.reported("0", "massCenterZ");
    const std::vector<double> sweeps = whole.reported("0", "sweeps");
    ASSERT_EQ(joined(parts, starts, "time").size(), 15u);
    for (std::size_t k = 0; k < 15; ++k)
    {
        EXPECT_NEAR(joined(parts, starts, "wallForceZ")[k], force[k], 0.02*largest(force)) << k;
        EXPECT_NEAR(joined(parts, starts, "massCenterZ")[k], center[k], 1e-3*diameter) << k;
    }
    // The part on one rank begins with the impulses: with as many sweeps as the run that had them all the time.
    EXPECT_NEAR(joined(parts, starts, "sweeps")[5], sweeps[5], 1 + 0.1*sweeps[5]);
}

TEST(Ranks, moveGrainsInAFluidAsOneRankDoes)
{
    // Water that flows through the heap, and the predictor of contacts; then air, in which grains are handed over as they are.
    const std::string inflow = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { "
        "\"(left|right|bottom|top)\" { type noSlip; } front { type fixedValue; value uniform (0 0 0.05); } "
        "back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }";
    const std::string air = "transportModel Newtonian; nu 1.5e-5; rho 1.2;", water = "transportModel Newtonian; nu 1e-4; rho 1000;";
    for (const std::string& fluid : {water, air})
    {
        const Files files
        {
            {"constant/grainProperties", wetHeap + closed}, {"0/U", inflow}, {"constant/transportProperties", fluid},
            {"system/fvSolution", solutionWith(8)}
        };
        const std::string control = "writeFormat binary; endTime 0.012; writeInterval 12;";
        const ProgramCase alone(files, control);
        EXPECT_TRUE(succeeds(alone.run()));
        for (const labelVector& parts : {labelVector(2, 1, 1), labelVector(1, 1, 3), labelVector(2, 2, 1)})
        {
            const label ranks = cmptProduct(parts);
            SCOPED_TRACE(fluid + std::to_string(ranks));
            const ProgramCase together(files, control);
            EXPECT_TRUE(succeeds(together.decompose(parts)));
            EXPECT_TRUE(succeeds(together.runOn(ranks)));
            expectSameMotion(alone, together, diameter, 8);
            EXPECT_LT(largest(together.reported("0", "momentumError")), 1e-9);
        }
    }
}

namespace
{

/// Runs a wet heap with more files, on one rank and on two and three; what the files add moves it by ten times what ranks may differ by.
void expectSameMotionOnRanks(const std::string& heap, const Files& more)
{
    const std::string control = "writeFormat binary; endTime 0.012; writeInterval 12;";
    const Files plain{{"constant/grainProperties", heap}, {"system/fvSolution", solutionWith(8)}};
    Files files = more;
    files.insert(plain.begin(), plain.end());
    const ProgramCase alone(files, control), without(plain, control);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(without.run()));
    EXPECT_GT(difference(alone, without, "massCenterX", 8) + difference(alone, without, "massCenterY", 8), 1e-3*diameter);
    runOnTwoAndThree(files, control, [&](const ProgramCase& together)
    {
        expectSameMotion(alone, together, diameter, 8);
        EXPECT_LT(largest(together.reported("0", "momentumError")), 1e-9);
    });
}

} // namespace

TEST(Ranks, liftGrainsAsOneRankDoes)
{
    const std::string spinning = with(wetHeap, "jitter 0.7;", "jitter 0.7; omega (40 -30 20);") + closed;
    expectSameMotionOnRanks(spinning, {{"constant/grainProperties", spinning + "forces { saffmanLift on; magnusLift on; }"}});
}

TEST(Ranks, addMassToGrainsAsOneRankDoes)
{
    const std::string heap = wetHeap + closed + "voidFraction { filterWidth 0; }";
    const std::string law = "drag { law Gidaspow; }";
    expectSameMotionOnRanks(heap + "forces { " + law + " }", {{"constant/grainProperties", heap + "forces { addedMass on; basset on; " + law + " }"}});
}

/// A force on the fluid, whose pressure pushes the grains, and fluid from a point in one corner.
TEST(Ranks, haveSourcesInTheFluidAsOneRankDoes)
{
    const std::string options =
        "sideways { type vectorSemiImplicitSource; selectionMode all; volumeMode specific; injectionRateSuSp { U ((30 20 0) 0); } }"
        "spring { type scalarSemiImplicitSource; selectionMode points; points ((0.01 0.01 0.03)); volumeMode absolute; "
        "injectionRateSuSp { alpha.fluid (1e-4 0); } }";
    expectSameMotionOnRanks(wetHeap + closed, {{"constant/fvOptions", options}});
}

TEST(Ranks, goOnWithAFluidAsIfNeverStopped)
{
    const Files files{{"constant/grainProperties", wetHeap + closed}};
    const std::string control = "writeFormat binary; writeInterval 6; ";
    const ProgramCase whole(files, control + "endTime 0.012;"), parts(files, control + "endTime 0.006;");
    runWholeAndInParts(whole, parts, labelVector(1, 1, 3), control + "endTime 0.012;");
    EXPECT_EQ(filesThatDiffer(whole, parts, 3, "0.012", {"U", "p_rgh", "phi", "alpha.fluid"}), std::vector<std::string>());
}

TEST(Ranks, changeOwnersWhereLoadsAreUneven)
{
    // A dense heap beside a thin cloud: shared out by number at the start, by contacts later.
    const Files files = dryFiles
    (
        glass + closed + "grains { heap { type lattice; box (0 0 0) (0.05 0.1 0.05); count (4 8 4); diameter 0.0124; } "
        "cloud { type lattice; box (0.05 0 0.05) (0.1 0.1 0.2); count (4 4 8); diameter 0.004; } } "
        "parallel { maxLoadImbalance 1.05; }"
    );
    const std::string control = "endTime 0.012; writeInterval 12;";
    const ProgramCase alone(files, control), together(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 1))));
    const ProgramRun run = together.runOn(2);
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(holds(run.log, {"grains shared out anew"}));
    expectSameMotion(alone, together, diameter, 12);
}

TEST(Ranks, refuseWhatTheyCannotRun)
{
    const ProgramCase wet;
    EXPECT_TRUE(succeeds(wet.decompose(labelVector(2, 1, 1))));
    const ProgramRun collated = wet.runOn(2, "-parallel -fileHandler collated");
    EXPECT_NE(collated.status, 0);
    EXPECT_TRUE(holds(collated.log, {"uncollated"}));
    const ProgramRun wrongNumber = wet.runOn(3);
    EXPECT_NE(wrongNumber.status, 0);
    EXPECT_TRUE(holds(wrongNumber.log, {"umber of processor directories = 2"}));
}

TEST(Ranks, checkTheFirstGrainsTogether)
{
    const ProgramCase c(dryFiles(glass + closed + "grains { type table; file \"grains.txt\"; }"));
    EXPECT_TRUE(succeeds(c.decompose(labelVector(2, 1, 1))));
    // Across the cut at x = 0.05, and at a wall.
    std::ofstream(c.path("constant/grains.txt")) << "0.049 0.05 0.05 0.01\n0.055 0.05 0.05 0.01\n0.08 0.05 0.001 0.01\n";
    ProgramRun run = c.runOn(2);
    EXPECT_NE(run.status, 0);
    EXPECT_TRUE(holds(run.log, {"is exceeded by 2 pairs", "grains 0 and 1 overlap by 0.4", "grain 2 and the wall front overlap by 0.4"}));
    std::ofstream(c.path("constant/grains.txt")) << "0.05 0.05 0.05 0.01\n0.15 0.05 0.05 0.01\n";
    run = c.runOn(2);
    EXPECT_NE(run.status, 0);
    EXPECT_TRUE(holds(run.log, {"puts 1 grains outside the mesh", "grain 1 at (0.15 0.05 0.05)"}));
}

/// Loose and packed grains are where one rank puts them, whichever rank has them, and clear of all walls of the mesh.
TEST(Ranks, fillRegionsAsOneRankDoes)
{
    const std::string sources = "motion fixed; maxInitialOverlap 0; grains { loose { type filling; region { type box; box (0 0 0.05) (0.1 0.1 0.1); } solidFraction 0.2; "
        "sizes { type normal; mean 0.012; deviation 0.002; min 0.008; max 0.016; } } "
        "packed { type filling; region { type box; box (0 0 0) (0.1 0.1 0.05); } packing { solidFraction 0.55; } diameter 0.01; } }";
    const std::string control = "writeFormat binary; endTime 0.001; deltaT 1e-3; writeInterval 1;";
    const ProgramCase alone(dryFiles(glass + closed + sources), control), together(dryFiles(glass + closed + sources), control);
    const ProgramRun serial = alone.run();
    EXPECT_TRUE(succeeds(serial));
    EXPECT_TRUE(holds(serial.log, {"filling: ", "solid fraction 0.5", "sweeps"}));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 2))));
    EXPECT_TRUE(succeeds(together.runOn(4)));
    EXPECT_GT(alone.reported("0", "grains").at(0), 500);
    for (const char* column : {"grains", "grainVolume", "massCenterX", "massCenterY", "massCenterZ"})
    {
        EXPECT_LT(difference(alone, together, column, 1), 1e-12) << column;
    }
    // Beyond the mesh no grain is taken.
    const ProgramCase outside(dryFiles(glass + closed + with(sources, "(0.1 0.1 0.1)", "(0.2 0.1 0.1)")), control);
    EXPECT_TRUE(succeeds(outside.decompose(labelVector(2, 1, 1))));
    const ProgramRun refused = outside.runOn(2);
    EXPECT_NE(refused.status, 0);
    EXPECT_TRUE(holds(refused.log, {"grains outside the mesh"}));
}

TEST(Ranks, anErrorOnOneRankEndsAll)
{
    const Files files = dryFiles
    (
        glass + closed + "grains { type lattice; box (0 0 0.05) (0.1 0.1 0.08); count (4 2 1); diameter 0.01; }"
    );
    const ProgramCase c(files, "endTime 0.002; writeInterval 2;");
    EXPECT_TRUE(succeeds(c.decompose(labelVector(2, 1, 1))));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    c.writeControl("endTime 0.004;");
    // Two grains in one place, on one rank: all are told.
    const std::string file = "processor1/0.002/lagrangian/grains/position";
    std::string positions = c.contents(file);
    const std::size_t first = positions.find('(', positions.find("// *")) + 1;
    const std::size_t a = positions.find('(', first), afterA = positions.find(')', a) + 1;
    const std::size_t b = positions.find('(', afterA), afterB = positions.find(')', b) + 1;
    positions.replace(b, afterB - b, positions.substr(a, afterA - a));
    std::ofstream(c.path(file)) << positions;
    const ProgramRun run = c.runOn(2);
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.status, 124) << "hangs";
    EXPECT_TRUE(holds(run.log, {"FOAM FATAL IO ERROR", "have the same center at"}));
}
