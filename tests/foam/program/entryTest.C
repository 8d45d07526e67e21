// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam with grains that enter: what a new grain feels in its first step, counts, restarts, empty to full to empty.
#include "caseTools.H"
#include "programCase.H"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string glass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } ";
const std::string open = "patches { front { type exit; } back { type exit; } } ";
const std::string closed = "patches { front { type wall; } back { type exit; } } ";
const std::string pour = "pour { type entering; region { type box; box (0.01 0.01 0.1) (0.09 0.09 0.19); } rate 1500; velocity (0 0 -1); "
    "sizes { type uniform; min 0.004; max 0.008; } } ";
const char* const entryColumns[] = {"entered", "enteredMass", "waiting", "waitingMass"};

/// In each row, grains that are there and those that left are those that entered and those of the start.
void expectAllCounted(const ProgramCase& c, const std::string& start, double first)
{
    const std::vector<double> inside = c.reported(start, "grains"), out = c.reported(start, "exited"), in = c.reported(start, "entered");
    ASSERT_FALSE(inside.empty());
    for (std::size_t k = 0; k < inside.size(); ++k) ASSERT_EQ(inside[k] + out[k], first + in[k]) << k;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double most = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return a.size() == b.size() ? most : GREAT;
}

/// Binary contents of fields and clouds that differ.
std::vector<std::string> filesThatDiffer(const ProgramCase& a, const ProgramCase& b, const std::string& time)
{
    std::vector<std::string> different;
    for (const char* file : {"U", "p_rgh", "alpha.fluid", "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/grains/origId",
        "lagrangian/grains/d", "lagrangian/contacts/impulse"})
    {
        const std::string path = time + "/" + file;
        if (a.contents(path).empty() || a.contents(path) != b.contents(path)) different.push_back(path);
    }
    return different;
}

/// Numbers of the cells of a field in ASCII.
std::vector<double> cellValues(std::string field)
{
    field = field.substr(field.find("internalField"), field.find("boundaryField") - field.find("internalField"));
    std::replace_if(field.begin(), field.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
    std::istringstream text(field.substr(field.find('\n')));
    return std::vector<double>(std::istream_iterator<double>(text), {});
}

double largestFieldDifference(const std::string& a, const std::string& b)
{
    const std::vector<double> x = cellValues(a), y = cellValues(b);
    return x.size() < 128 ? GREAT : largestDifference(x, y);
}

} // namespace

/// One grain that enters in the first step of water at rest, against one that was there: void fraction, drag and all are the same.
TEST(Entries, feelAndMoveTheFluidInTheirFirstStep)
{
    const Files entering{{"constant/grainProperties", glass + closed + "grains { type entering; region { type box; "
        "box (0.053 0.047 0.152) (0.053 0.047 0.152); } rate 1000; number 1; diameter 0.012; velocity (0.2 0 -0.5); omega (0 30 0); }"}};
    const Files lattice{{"constant/grainProperties", glass + closed + "grains { type lattice; box (0.043 0.037 0.142) (0.063 0.057 0.162); "
        "count (1 1 1); diameter 0.012; velocity (0.2 0 -0.5); omega (0 30 0); }"}};
    const ProgramCase enters(entering), isThere(lattice);
    EXPECT_TRUE(succeeds(enters.run()));
    EXPECT_TRUE(succeeds(isThere.run()));
    EXPECT_EQ(enters.reported("0", "entered"), std::vector<double>(10, 1));
    EXPECT_EQ(isThere.reported("0", "entered"), std::vector<double>(10, 0));
    for (const char* column : {"massCenterX", "massCenterZ", "kineticEnergy", "solidVolume", "courantMax", "momentumError"})
    {
        const std::vector<double> found = enters.reported("0", column), expected = isThere.reported("0", column);
        EXPECT_LT(largestDifference(found, expected), 1e-9*(1e-3 + std::abs(expected.back()))) << column;
    }
    EXPECT_NEAR(enters.reported("0", "solidVolume").front(), M_PI/6*std::pow(0.012, 3), 1e-15);
}

TEST(Entries, areCountedWithThoseOfTheStartAndThoseThatLeave)
{
    const std::string lattice = "first { type lattice; box (0 0 0) (0.1 0.1 0.05); count (3 3 1); diameter 0.01; } ";
    const std::string properties = glass + open + "grains { " + lattice + pour + "}";
    for (const Files& files : {Files{{"constant/grainProperties", properties}}, dryFiles("fluid none; " + properties)})
    {
        const ProgramCase c(files, "endTime 1.6; deltaT 4e-3; writeInterval 1000;");
        EXPECT_TRUE(succeeds(c.run()));
        expectAllCounted(c, "0", 9);
        EXPECT_GT(c.reported("0", "exited").back(), 100);
        const std::vector<double> entered = c.reported("0", "entered"), waiting = c.reported("0", "waiting");
        for (std::size_t k = 0; k < entered.size(); ++k) ASSERT_EQ(entered[k] + waiting[k], 6*(double(k) + 1));
    }
}

/// Stopped and continued in the middle of entering, of waiting, and of leaving.
TEST(Entries, goOnFromAWrittenTimeToTheBit)
{
    const std::string narrow = "narrow { type entering; region { type sphere; center (0.05 0.05 0.05); radius 0.02; } massRate 5; diameter 0.012; seed 7; } ";
    const Files files{{"constant/grainProperties", glass + open + "grains { " + pour + narrow + "} voidFraction { diffusion 2; }"}};
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 20; ";
    const ProgramCase whole(files, control + "endTime 0.08;"), parts(files, control + "endTime 0.04;");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_TRUE(succeeds(parts.run()));
    parts.writeControl(control + "endTime 0.08;");
    EXPECT_TRUE(succeeds(parts.run()));
    EXPECT_EQ(filesThatDiffer(whole, parts, "0.08"), std::vector<std::string>());
    EXPECT_GT(whole.reported("0", "waiting").back(), 10);
    for (const char* column : entryColumns)
    {
        const std::vector<double> all = whole.reported("0", column), rest = parts.reported("0.04", column);
        ASSERT_EQ(rest.size(), 20u);
        EXPECT_TRUE(std::equal(rest.begin(), rest.end(), all.begin() + 20)) << column;
    }
}

TEST(Entries, stayInTheMesh)
{
    const std::string reachesOut = "grains { type entering; region { type sphere; center (0.05 0.05 0.2); radius 0.05; } rate 1e5; diameter 0.004; }";
    const ProgramCase c(dryFiles("fluid none; " + glass + closed + reachesOut), "endTime 1e-3; deltaT 1e-3; writeInterval 1;");
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_GT(c.reported("0", "entered").back(), 50);
    EXPECT_EQ(c.reported("0", "exited").back(), 0);

    const std::string outside = "grains { type entering; region { type box; box (0.2 0 0) (0.3 0.1 0.1); } rate 1; diameter 0.004; }";
    const std::vector<std::string> pieces = {"region", "has no cell of the mesh", "in the mesh, which is bounded by"};
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + glass + closed + outside)), pieces));
    EXPECT_TRUE(isRefused(ProgramCase(Files{{"constant/grainProperties", glass + closed + outside}}), pieces));
}

TEST(Entries, areCheckedAsThoseOfTheStart)
{
    const std::string entering = "grains { type entering; region { type box; box (0 0 0.1) (0.1 0.1 0.2); } rate 1; diameter 0.02; }";
    const std::string noPair = "materials { glass { density 2500; } } contacts {} wallMaterial glass; ";
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + noPair + closed + entering)), {"contacts", "glass"}));
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + glass + entering)), {"does not say what the patch front is to the grains"}));
}

/// Discs in the mid-plane of a mesh that does not hold the origin.
TEST(Entries, liveInTheMidPlane)
{
    BoxMeshSettings box = programBox();
    box.cells = labelVector(6, 6, 1);
    box.min = point(0, 0, 0.01);
    box.max = point(0.1, 0.2, 0.03);
    box.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    Files files = dryFiles("fluid none; " + glass + "grains { type entering; region { type sphere; center (0.05 0.1 0.02); radius 0.04; } rate 5e3; diameter 0.006; }");
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);";
    const ProgramCase c(files, "", box);
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_GT(c.reported("0", "entered").back(), 20);
    for (const double z : c.reported("0", "massCenterZ")) EXPECT_NEAR(z, 0.02, 1e-14);
}

/// Empty, full, empty again: water that flows through ends as in a run that never had grains, to what its solvers leave.
TEST(Entries, leaveTheFluidAsItWas)
{
    const std::string inflow = "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { "
        "\"(left|right|bottom|top)\" { type noSlip; } front { type fixedValue; value uniform (0 0 0.05); } "
        "back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }";
    Files with{{"0/U", inflow}, {"constant/transportProperties", "transportModel Newtonian; nu 1e-3; rho 1000;"}};
    Files without = with;
    const std::string heavy = "materials { steel { density 8000; } } contacts { default { friction 0.3; } } ";
    const std::string some = "grains { pour { type entering; region { type box; box (0.01 0.01 0.1) (0.09 0.09 0.19); } rate 600; duration 0.1; "
        "velocity (0 0 -1); diameter 0.012; } }";
    with["constant/grainProperties"] = heavy + open + some;
    without["constant/grainProperties"] = glass + open + "grains {}";
    const std::string control = "endTime 12; deltaT 4e-3; writeInterval 3000; writePrecision 16;";
    const ProgramCase full(with, control), empty(without, control);
    EXPECT_TRUE(succeeds(full.run()));
    EXPECT_TRUE(succeeds(empty.run()));
    expectAllCounted(full, "0", 0);
    EXPECT_EQ(full.reported("0", "entered").back(), 60);
    EXPECT_EQ(full.reported("0", "grains").back(), 0);
    EXPECT_GT(full.reported("0", "grains").at(30), 50);
    EXPECT_EQ(full.reported("0", "solidVolume").back(), 0);
    EXPECT_GT(std::abs(full.reported("0", "courantMax").at(30) - empty.reported("0", "courantMax").at(30)), 1e-3);
    EXPECT_NEAR(full.reported("0", "courantMax").back(), empty.reported("0", "courantMax").back(), 1e-10);
    EXPECT_LT(largestFieldDifference(full.contents("12/U"), empty.contents("12/U")), 1e-10);
    EXPECT_LT(largestFieldDifference(full.contents("12/p_rgh"), empty.contents("12/p_rgh")), 1e-6);
}
