// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam with grains that enter at patches and in zones of cells, as fast as the fluid, at rates and of sizes by OpenFOAM's models.
#include "caseTools.H"
#include "programCase.H"
#include "writtenCase.H"

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string glass = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } ";
const std::string open = "patches { front { type wall; } back { type exit; } } ";
const std::string weightless = "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);";

/// Water between slipping walls, with this velocity at the inlet, which grains do not change.
Files flowing(const std::string& inlet, const std::string& sources, const std::string& inside = "(0 0 0)")
{
    const std::string velocity = "dimensions [0 1 -1 0 0 0 0]; internalField uniform " + inside + "; boundaryField { \"(left|right|bottom|top)\" { type slip; } "
        "front { " + inlet + " } back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }";
    return {{"0/U", velocity}, {"constant/g", weightless}, {"constant/grainProperties", glass + open + "feedback off; grains { " + sources + "}"}};
}

/// Numbers of points in slices of equal width along an axis of a box of 0.1 m.
std::vector<double> inSlices(const std::vector<nscd::Vec3>& points, int axis, int slices)
{
    std::vector<double> numbers(slices, 0);
    for (const nscd::Vec3& x : points) ++numbers.at(int(slices*x[axis]/0.1));
    return numbers;
}

/// Within five standard deviations of what a share of all would be.
void expectShare(double number, double all, double share)
{
    EXPECT_NEAR(number, share*all, 5*std::sqrt(all*share*(1 - share)) + 1e-9);
}

const std::string zones = "actions ( "
    "{ name low; type cellSet; action new; source boxToCell; box (0 0 0) (0.05 0.05 0.05); } "
    "{ name low; type cellSet; action add; source boxToCell; box (0.06 0.05 0.1) (0.2 0.1 0.2); } "
    "{ name feed; type cellZoneSet; action new; source setToCellZone; set low; } );";

} // namespace

/// As far behind the patch as the largest radius; whole in the mesh; as many in each part of the area.
TEST(MeshEntries, enterAllOverAPatch)
{
    const std::string sources = "grains { type entering; region { type patch; patch front; } rate 4e5; number 400; sizes { type uniform; min 0.001; max 0.002; } }";
    const ProgramCase c(dryFiles("fluid none; " + glass + open + sources), "deltaT 1e-3; endTime 1e-3; writeInterval 1;");
    c.write("constant/g", weightless);
    EXPECT_TRUE(succeeds(c.run()));
    const nscd::Grains grains = latestGrains(c);
    ASSERT_EQ(grains.size(), 400u);
    for (const nscd::Vec3& x : grains.position) EXPECT_NEAR(x[2], 0.001, 2e-9);
    for (int axis : {0, 1})
    {
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            EXPECT_GE(grains.position[i][axis], grains.radius[i]);
            EXPECT_LE(grains.position[i][axis], 0.1 - grains.radius[i]);
        }
        for (const double number : inSlices(grains.position, axis, 4)) expectShare(number, 400, 0.25);
    }
}

/// Nothing flows in through the left half of the inlet; in the right quarter three times as much as beside it.
TEST(MeshEntries, enterWhereTheFluidDoes)
{
    const std::string row = "(0 0 0) (0 0 0) (0 0 0.1) (0 0 0.3) ";
    const std::string sources = "pour { type entering; region { type patch; patch front; by flux; } rate 4e5; number 400; diameter 0.001; }";
    const ProgramCase c(flowing("type fixedValue; value nonuniform List<vector> 16(" + row + row + row + row + ");", sources), "deltaT 1e-3; endTime 1e-3; writeInterval 1;");
    EXPECT_TRUE(succeeds(c.run()));
    const std::vector<double> numbers = inSlices(latestGrains(c).position, 0, 4);
    EXPECT_EQ(numbers[0] + numbers[1], 0);
    EXPECT_EQ(numbers[2] + numbers[3], 400);
    expectShare(numbers[2], 400, 0.25);
}

TEST(MeshEntries, waitForAFlowThatBringsThem)
{
    const std::string sources = "pour { type entering; region { type patch; patch front; by flux; } rate 1000; diameter 0.002; }";
    const ProgramCase c(flowing("type uniformFixedValue; uniformValue table ((0 (0 0 0)) (0.004 (0 0 0)) (0.005 (0 0 0.1)) (1 (0 0 0.1)));", sources));
    EXPECT_TRUE(succeeds(c.run()));
    const std::vector<double> entered = c.reported("0", "entered"), waiting = c.reported("0", "waiting");
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(entered.at(k), 0) << k;
    EXPECT_EQ(entered.back(), 10);
    EXPECT_EQ(waiting.at(4), 5);
}

/// A uniform flow that grains do not change: each has its velocity, and keeps it. Beside it, grains with a velocity of their own.
TEST(MeshEntries, areAsFastAsTheFluid)
{
    const std::string sources = "carried { type entering; region { type patch; patch front; } rate 2000; diameter 0.002; velocity fluid; } "
        "own { type entering; region { type box; box (0.01 0.01 0.15) (0.09 0.09 0.18); } rate 1000; diameter 0.003; velocity (0.02 0 0); } ";
    const ProgramCase c(flowing("type fixedValue; value uniform (0 0 0.1);", sources, "(0 0 0.1)"), "deltaT 1e-3; endTime 1e-3; writeInterval 1; writePrecision 16;");
    EXPECT_TRUE(succeeds(c.run()));
    const nscd::Grains grains = latestGrains(c);
    ASSERT_EQ(grains.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const bool isCarried = grains.radius[i] == 0.001;
        if (isCarried) EXPECT_LT((grains.velocity[i] - nscd::Vec3(0, 0, 0.1)).norm(), 1e-7);
        else EXPECT_GT(grains.velocity[i][0], 0.01);
    }
}

/// In cells whose bounding boxes overlap: points of two separate blocks, as many as their volumes say, none beside them.
TEST(MeshEntries, enterInAZoneOfCells)
{
    BoxMeshSettings box = programBox();
    box.movePoint = [](const point& x) { return point(x.x() + 0.4*x.z(), x.y(), x.z()); };
    const std::string sources = "grains { type entering; region { type cellZone; cellZone feed; } rate 6e5; number 600; diameter 0.001; }";
    const ProgramCase c(dryFiles("fluid none; " + glass + open + sources), "deltaT 1e-3; endTime 1e-3; writeInterval 1;", box);
    c.write("constant/g", weightless);
    c.write("system/topoSetDict", zones);
    EXPECT_TRUE(succeeds(c.run("topoSet")));
    EXPECT_TRUE(succeeds(c.run()));
    const std::vector<nscd::Vec3> found = latestGrains(c).position;
    ASSERT_EQ(found.size(), 600u);
    // Of cells of 25 mm, those with their centers in the boxes, sheared back.
    std::map<std::array<int, 3>, int> perCell;
    for (const nscd::Vec3& x : found) ++perCell[{int((x[0] - 0.4*x[2])/0.025), int(x[1]/0.025), int(x[2]/0.025)}];
    int low = 0;
    for (const auto& [cell, number] : perCell)
    {
        const double x = 0.025*(cell[0] + 0.5) + 0.4*0.025*(cell[2] + 0.5);
        const bool isLow = x < 0.05 && cell[1] < 2 && cell[2] < 2, isHigh = x > 0.06 && cell[1] >= 2 && cell[2] >= 4;
        EXPECT_TRUE(isLow || isHigh) << cell[0] << ' ' << cell[1] << ' ' << cell[2];
        if (isLow) low += number;
    }
    const double cells = double(perCell.size());
    EXPECT_GT(cells, 20);
    for (const auto& [cell, number] : perCell) expectShare(number, 600, 1/cells);
    EXPECT_GT(low, 30);
}

/// Any Function1: with 1000/s + 1.9e5/s2 t, 1000 t + 0.95e5 t^2 have entered.
TEST(MeshEntries, enterAtARateByFunction1)
{
    const std::string sources = "grains { type entering; region { type box; box (0.01 0.01 0.05) (0.09 0.09 0.15); } diameter 0.004; "
        "rate polynomial ((1000 0) (1.9e5 1)); }";
    const ProgramCase c(dryFiles("fluid none; " + glass + open + sources));
    EXPECT_TRUE(succeeds(c.run()));
    const std::vector<double> entered = c.reported("0", "entered");
    ASSERT_EQ(entered.size(), 10u);
    for (std::size_t k = 0; k < entered.size(); ++k)
    {
        const double t = 1e-3*(double(k) + 1);
        EXPECT_EQ(entered[k], std::floor(1000*t + 0.95e5*t*t)) << k;
    }
}

/// Density ~ exp(-2000/m d) between 1 and 3 mm, which none of our own distributions has: (1 - e^-1)/(1 - e^-4) are below 1.5 mm.
TEST(MeshEntries, haveSizesByOpenFOAMsModels)
{
    const std::string sizes = "sizes { type exponential; exponentialDistribution { minValue 0.001; maxValue 0.003; lambda 2000; } } ";
    const std::string sources = "grains { type entering; region { type box; box (0.01 0.01 0.02) (0.09 0.09 0.18); } rate 5e5; number 500; " + sizes + "}";
    const ProgramCase c(dryFiles("fluid none; " + glass + open + sources), "deltaT 1e-3; endTime 1e-3; writeInterval 1;");
    EXPECT_TRUE(succeeds(c.run()));
    const nscd::Grains grains = latestGrains(c);
    ASSERT_EQ(grains.size(), 500u);
    int small = 0;
    for (const double radius : grains.radius)
    {
        EXPECT_TRUE(radius >= 0.0005 && radius <= 0.0015) << radius;
        small += radius < 0.00075;
    }
    expectShare(small, 500, (1 - std::exp(-1.0))/(1 - std::exp(-4.0)));
}

TEST(MeshEntries, areRefusedBeforeTheFirstStep)
{
    const std::string rest = " rate 1; diameter 0.004; ";
    const std::string box = "region { type box; box (0 0 0) (0.1 0.1 0.1); } rate 1; ";
    struct Wrong { std::string source; std::vector<std::string> pieces; };
    const std::vector<Wrong> wrongs =
    {
        {"region { type pach; patch front; }" + rest, {"grains.region.type", "pach", "nearest: patch", "cellZone", "at line"}},
        {"region { type patch; }" + rest, {"grains.region.patch", "is missing"}},
        {"region { type patch; patch frnt; }" + rest, {"grains.region.patch", "frnt", "nearest: front", "back"}},
        {"region { type patch; patch front; by flow; }" + rest, {"grains.region.by", "flow", "area, flux"}},
        {"region { type patch; patch front; by flux; }" + rest, {"grains.region.by", "none is solved", "allowed: area"}},
        {"region { type patch; patch front; radius 1; }" + rest, {"grains.region.radius", "is not a keyword here"}},
        {"region { type cellZone; cellZone feed; }" + rest, {"grains.region.cellZone", "feed"}},
        {"region { type patch; patch front; } rate 1; diameter 0.5;", {"grains.region", "has no cell of the mesh"}},
        {box + "diameter 0.004; velocity fluid;", {"grains.velocity", "none is solved", "(x y z)"}},
        {box + "diameter 0.004; velocity fluit;", {"grains.velocity", "is not a vector"}},
        {box + "sizes { type multiNormal; }", {"grains.sizes.multiNormalDistribution", "is missing"}},
        {box + "sizes { type multiNormel; }", {"grains.sizes.type", "nearest: multiNormal", "logNormal", "exponential"}},
        {box + "sizes { type exponential; exponentialDistribution { minValue 0; maxValue 0.01; lambda 5; } }", {"exponentialDistribution", "has sizes from 0", "above 0"}},
        {box + "sizes { type exponential; exponentialDistribution { minValue 0.02; maxValue 0.01; lambda 5; } }", {"grains.sizes", "Maximum value"}},
        {box + "sizes { type exponential; exponentialDistribution { minValue 0.001; maxValue 0.01; } }", {"lambda"}}
    };
    for (const Wrong& wrong : wrongs)
    {
        SCOPED_TRACE(wrong.source);
        EXPECT_TRUE(isRefused(ProgramCase(dryFiles("fluid none; " + glass + open + "grains { type entering; " + wrong.source + " }")), wrong.pieces));
    }
}

/// Continued in the middle, with a flux that changes from step to step, places and velocities are those of the run in one go.
TEST(MeshEntries, goOnFromAWrittenTimeToTheBit)
{
    const std::string row = "(0 0 0) (0 0 0.05) (0 0 0.1) (0 0 0.3) ";
    Files files = flowing("type fixedValue; value nonuniform List<vector> 16(" + row + row + row + row + ");",
        "pour { type entering; region { type patch; patch front; by flux; } rate 2000; diameter 0.004; velocity fluid; }");
    files["constant/grainProperties"] = glass + open + "grains { pour { type entering; region { type patch; patch front; by flux; } rate 2000; diameter 0.004; velocity fluid; } }";
    const std::string control = "writeFormat binary; deltaT 2e-3; writeInterval 10; ";
    const ProgramCase whole(files, control + "endTime 0.04;"), parts(files, control + "endTime 0.02;");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_TRUE(succeeds(parts.run()));
    parts.writeControl(control + "endTime 0.04;");
    EXPECT_TRUE(succeeds(parts.run()));
    for (const char* file : {"U", "p_rgh", "alpha.fluid", "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/grains/origId"})
    {
        const std::string path = std::string("0.04/") + file;
        EXPECT_FALSE(whole.contents(path).empty()) << path;
        EXPECT_TRUE(whole.contents(path) == parts.contents(path)) << path;
    }
}
