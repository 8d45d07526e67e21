// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of grains that another case has written as a source: from one mesh to another, as a hopper that is filled in one case and emptied in the
// next, from a case in parts or whole; what is refused.
#include "caseTools.H"
#include "programCase.H"
#include "writtenCase.H"

#include "coupling/case/walls/grainExits.H"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string glass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } ";
const std::string closed = "patches { front { type wall; } back { type exit; } } ";
const std::string tumbling = "fluid none; " + glass + closed + "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.16); count (3 3 5); diameter 0.01; "
    "spread 0.2; velocity (0.3 0.1 -0.5); omega (5 0 20); } ";

std::string fromTime(const ProgramCase& c, const std::string& time = "latestTime")
{
    return "grains { old { type time; case \"" + c.path("") + "\"; time " + time + "; } } ";
}

void expectSame(const nscd::Grains& a, const nscd::Grains& b, double accuracy)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        EXPECT_EQ(a.radius[i], b.radius[i]) << i;
        EXPECT_LE((a.position[i] - b.position[i]).norm(), accuracy) << i;
        EXPECT_LE((a.velocity[i] - b.velocity[i]).norm(), accuracy) << i;
        EXPECT_LE((a.omega[i] - b.omega[i]).norm(), accuracy) << i;
        EXPECT_LE((a.orientation[i].coeffs() - b.orientation[i].coeffs()).norm(), accuracy + 1e-15) << i;
    }
}

/// A funnel from 0.1 x 0.1 m at 0.1 m down to 0.04 x 0.04 m at 0.04 m, below a box; with a spout of 0.04 m below it, or closed.
std::string hopper(bool isOpen)
{
    const std::string spout = isOpen ? "hex (12 13 14 15 0 1 2 3) (4 4 4) simpleGrading (1 1 1) " : "";
    const std::string outlet = isOpen ? "type patch; faces ((12 13 14 15));" : "type wall; faces ((0 1 2 3));";
    return "convertToMeters 1; vertices ( (0.03 0.03 0.04) (0.07 0.03 0.04) (0.07 0.07 0.04) (0.03 0.07 0.04) (0 0 0.1) (0.1 0 0.1) (0.1 0.1 0.1) (0 0.1 0.1) "
        "(0 0 0.3) (0.1 0 0.3) (0.1 0.1 0.3) (0 0.1 0.3) (0.03 0.03 0) (0.07 0.03 0) (0.07 0.07 0) (0.03 0.07 0) ); "
        "blocks ( hex (0 1 2 3 4 5 6 7) (4 4 6) simpleGrading (1 1 1) hex (4 5 6 7 8 9 10 11) (4 4 8) simpleGrading (1 1 1) " + spout + "); "
        "edges (); defaultPatch { name walls; type wall; } boundary ( outlet { " + outlet + " } top { type patch; faces ((8 9 10 11)); } ); mergePatchPairs ();";
}

/// A case on the mesh of blockMesh.
struct HopperCase : ProgramCase
{
    HopperCase(const Files& files, const std::string& control, bool isOpen) : ProgramCase(files, control)
    {
        write("system/blockMeshDict", hopper(isOpen));
        EXPECT_TRUE(succeeds(run("blockMesh")));
    }
};

const std::string fill = "fluid none; " + glass + "patches { top { type exit; } } grains { type entering; region { type box; box (0.01 0.01 0.2) (0.09 0.09 0.28); } "
    "rate 1000; number 250; diameter 0.007; velocity (0 0 -1); }";
const std::string emptying = glass + "patches { top { type wall; } outlet { type exit; } } ";

} // namespace

/// All that makes them, in the order of their identities.
TEST(WrittenGrains, areReadAsTheyWereWritten)
{
    const std::string control = "writeFormat binary; endTime 0.1; writeInterval 50;";
    const ProgramCase whole(dryFiles(tumbling), control);
    EXPECT_TRUE(succeeds(whole.run()));
    const nscd::Grains half = writtenGrains(whole, "0.05"), latest = latestGrains(whole);
    EXPECT_EQ(latest.size(), 45u);
    EXPECT_GT((half.position[0] - latest.position[0]).norm(), 1e-3);
    expectSame(writtenGrains(whole, "0.1"), latest, 0);
    EXPECT_TRUE(std::is_sorted(latest.id.begin(), latest.id.end()));
    EXPECT_NEAR(latest.mass[0], 2500*M_PI/6*std::pow(2*latest.radius[0], 3), 1e-12);
}

/// They go on from where they were: as many, in the same places, as fast, in a case on a mesh of its own.
TEST(WrittenGrains, startAnotherCase)
{
    const ProgramCase old(dryFiles(tumbling), "writeFormat binary; endTime 0.05; writeInterval 50; deltaT 1e-3;");
    EXPECT_TRUE(succeeds(old.run()));
    BoxMeshSettings finer = programBox();
    finer.cells = labelVector(3, 5, 11);
    const std::string more = "more { type lattice; box (0.04 0.04 0.17) (0.06 0.06 0.19); count (1 1 1); diameter 0.01; } } ";
    const std::string sources = fromTime(old);
    const ProgramCase next(dryFiles("fluid none; " + glass + closed + sources.substr(0, sources.rfind('}')) + more), "writeFormat binary; deltaT 1e-9; endTime 1e-9; writeInterval 1; timePrecision 12;", finer);
    EXPECT_TRUE(succeeds(next.run()));
    nscd::Grains found = latestGrains(next);
    ASSERT_EQ(found.size(), 46u);
    nscd::Grains expected = latestGrains(old);
    const std::vector<std::size_t> last = {45};
    nscdCoupling::eraseGrains(found, last);
    for (std::size_t i = 0; i < 45; ++i) EXPECT_EQ(found.id[i], std::int64_t(i));
    // A step of 1 ns changes velocities by 1e-8 m/s, impacts by what they were; overlaps of up to 1e-3 d are corrected.
    ASSERT_EQ(found.radius, expected.radius);
    for (std::size_t i = 0; i < 45; ++i) EXPECT_LT((found.position[i] - expected.position[i]).norm(), 2e-5) << i;
    int asFast = 0;
    for (std::size_t i = 0; i < 45; ++i) asFast += (found.velocity[i] - expected.velocity[i]).norm() < 1e-6 && (found.omega[i] - expected.omega[i]).norm() < 1e-3;
    EXPECT_GT(asFast, 20);
}

/// OpenFOAM's hopper in two stages, smaller: filled in one case, emptied in the next, whose mesh goes on below; with grains alone, and through air.
TEST(WrittenGrains, emptyTheHopperThatWasFilledInAnotherCase)
{
    const HopperCase filling(dryFiles(fill), "deltaT 1e-3; endTime 0.8; writeInterval 800;", false);
    ASSERT_EQ(filling.reported("0", "grains").size(), 0u);
    EXPECT_TRUE(succeeds(filling.run()));
    EXPECT_EQ(filling.reported("0", "grains").back(), 250);
    EXPECT_EQ(filling.reported("0", "exited").back(), 0);
    const std::string properties = emptying + fromTime(filling);
    Files air{{"constant/grainProperties", properties}, {"constant/transportProperties", "transportModel Newtonian; nu 1.5e-5; rho 1.2;"}};
    air["0/U"] = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { walls { type noSlip; } "
        "\"(top|outlet)\" { type pressureInletOutletVelocity; value uniform (0 0 0); } }";
    air["0/p_rgh"] = "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { walls { type fixedFluxPressure; value uniform 0; } "
        "\"(top|outlet)\" { type fixedValue; value uniform 0; } }";
    for (const Files& files : {dryFiles("fluid none; " + properties), air})
    {
        const HopperCase next(files, "deltaT 1e-3; endTime 1.5; writeInterval 2000;", true);
        EXPECT_TRUE(succeeds(next.run()));
        const std::vector<double> inside = next.reported("0", "grains"), out = next.reported("0", "exited");
        ASSERT_FALSE(inside.empty());
        for (std::size_t k = 0; k < inside.size(); ++k) ASSERT_EQ(inside[k] + out[k], 250) << k;
        EXPECT_NEAR(next.reported("0", "massCenterZ").front(), filling.reported("0", "massCenterZ").back(), 1e-4);
        EXPECT_GT(out.back(), 125);
    }
}

TEST(WrittenGrains, areRefusedBeforeTheFirstStep)
{
    const ProgramCase old(dryFiles(tumbling), "endTime 2e-3; writeInterval 1;");
    EXPECT_TRUE(succeeds(old.run()));
    const auto dry = [](const std::string& properties) { return ProgramCase(dryFiles("fluid none; " + glass + closed + properties)); };
    EXPECT_TRUE(isRefused(dry(fromTime(old, "0.003")), {"grains.old.time", "was not written", "0.003", "latestTime, 0.001, 0.002", "at line"}));
    EXPECT_TRUE(isRefused(dry(fromTime(old, "lastTime")), {"grains.old.time", "is no time", "latestTime"}));
    EXPECT_TRUE(isRefused(dry("grains { old { type time; time latestTime; } }"), {"grains.old.case", "is missing"}));
    EXPECT_TRUE(isRefused(dry("grains { old { type time; case \"nowhere\"; time latestTime; } }"), {"grains.old.case", "leads to no folder", "nowhere"}));
    EXPECT_TRUE(isRefused(dry("grains { old { type time; case \".\"; time latestTime; } }"), {"grains.old.case", "holds no time that nscdDEMFoam completed"}));
    EXPECT_TRUE(isRefused(dry("grains { old { type time; case \".\"; time latestTime; velocity (0 0 1); } }"), {"velocity", "is not a keyword here"}));
    const std::string steel = "materials { steel { density 8000; } } contacts { default { friction 0.3; } } ";
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + steel + closed + fromTime(old))), {"grains.old.case", "material", "glass", "allowed: steel"}));
    BoxMeshSettings low = programBox();
    low.max = point(0.1, 0.1, 0.1);
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + glass + closed + fromTime(old)), "", low), {"grains", "puts 18 grains outside the mesh", "grain 27 at"}));

    const std::string orientation = old.contents("0.002/lagrangian/grains/orientationW");
    old.write("0.002/lagrangian/grains/orientationW", "45{-1e30}");
    EXPECT_TRUE(isRefused(dry(fromTime(old)), {"grains.old.case", "holds a damaged grain, 0", "orientationW -1e+30", "length 1"}));
    std::ofstream(old.path("0.002/lagrangian/grains/orientationW")) << orientation;
    old.write("0.002/lagrangian/grains/d", "3(0.01 0.01 0.01)");
    EXPECT_TRUE(isRefused(dry(fromTime(old)), {"lagrangian/grains/d", "does not fit the other files", "3 values", "45 values"}));
    old.write("0.002/lagrangian/grains/d", "45(0.01 0.01");
    EXPECT_TRUE(isRefused(dry(fromTime(old)), {"lagrangian/grains/d", "missing, truncated or damaged"}));
    old.write("0.002/uniform/grainState", "");
    rm(old.path("0.002/uniform/grainState"));
    EXPECT_EQ(latestGrains(old).size(), 45u);
}

/// Written by three ranks, gone on with on two: as on one; in parts and reconstructed.
TEST(Ranks, goOnFromGrainsOfAnotherCase)
{
    const ProgramCase old(dryFiles(tumbling), "writeFormat binary; endTime 0.05; writeInterval 50;");
    EXPECT_TRUE(succeeds(old.decompose(labelVector(1, 1, 3))));
    EXPECT_TRUE(succeeds(old.runOn(3)));
    const nscd::Grains ofParts = latestGrains(old);
    EXPECT_EQ(ofParts.size(), 45u);
    const std::string properties = glass + closed + fromTime(old);
    const ProgramCase alone({{"constant/grainProperties", properties}}), together({{"constant/grainProperties", properties}});
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 1))));
    EXPECT_TRUE(succeeds(together.runOn(2)));
    EXPECT_EQ(alone.reported("0", "grains"), std::vector<double>(10, 45));
    EXPECT_EQ(alone.reported("0", "grains"), together.reported("0", "grains"));
    const std::vector<double> here = alone.reported("0", "massCenterZ"), there = together.reported("0", "massCenterZ");
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(here[k], there.at(k), 1e-6) << k;
    EXPECT_TRUE(succeeds(old.run("reconstructPar", "-latestTime")));
    for (const char* part : {"processor0", "processor1", "processor2"}) rmDir(old.path(part));
    expectSame(ofParts, latestGrains(old), 0);
}
