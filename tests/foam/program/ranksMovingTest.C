// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Meshes that move on 2 to 4 ranks: the same as on one, slivers between sliding halves and exits included, and restarts.
#include "rankRuns.H"
#include "swingingCase.H"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr double diameter = 0.01;

void expectSame(const ProgramCase& alone, const ProgramCase& together, double length)
{
    const std::size_t all = alone.reported("0", "time").size();
    EXPECT_GT(all, 0u);
    EXPECT_EQ(together.reported("0", "time").size(), all);
    EXPECT_EQ(difference(alone, together, "grains", all), 0);
    EXPECT_EQ(difference(alone, together, "exited", all), 0);
    for (const char* axis : {"X", "Y", "Z"}) EXPECT_LT(difference(alone, together, std::string("massCenter") + axis, all), length) << axis;
    // All of the grains' volume is in cells; what is beyond an interface between halves, in those on this side of it.
    const std::vector<double> solid = together.reported("0", "solidVolume"), grains = together.reported("0", "grainVolume");
    for (std::size_t k = 0; k < solid.size(); ++k) EXPECT_NEAR(solid[k], grains[k], 1e-10*grains[k]) << k;
    EXPECT_LT(difference(alone, together, "volumeOutside", all), 1e-3*largest(alone.reported("0", "grainVolume")));
    EXPECT_LT(largest(together.reported("0", "overlapMax")), 1e-3);
}

std::string readFile(const fileName& path)
{
    std::ifstream is(path);
    EXPECT_TRUE(is.good()) << path;
    return std::string((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
}

/// The contents of a file behind its header, which ProgramCase writes anew, by the dimensions.
std::string bodyOf(const fileName& path)
{
    const std::string text = readFile(path);
    const std::string body = text.substr(text.find('}', text.find("FoamFile")) + 1);
    return std::regex_replace(body, std::regex("dimensions +"), "dimensions ");
}

/// The paddle of tutorials/coupled/stirredTank, among whose cells there are grains from the start: some on both sides of the interface.
Files stirred(const std::string& more)
{
    const fileName tank = fileName(Foam::getEnv("NSCDDEMFOAM_DIR"))/"tutorials/coupled/stirredTank";
    Files files;
    for (const char* file : {"0/U", "0/p_rgh", "constant/dynamicMeshDict", "constant/g", "constant/transportProperties", "system/blockMeshDict",
        "system/fvSchemes", "system/fvSolution"})
    {
        files[file] = bodyOf(tank/file);
    }
    files["constant/grainProperties"] = "materials { acrylic { density 1190; } } contacts { default { friction 0.3; } } "
        "grains { type lattice; box (-0.048 -0.048 0) (0.048 -0.012 0.0015); count (24 9 1); diameter 1.5e-3; jitter 0.5; } " + more;
    return files;
}

/// In two and in three parts as alone, to a length.
void expectSameInParts(const Files& files, const std::string& control, double length)
{
    const ProgramCase alone(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    for (const labelVector& parts : {labelVector(1, 2, 1), labelVector(1, 1, 3)})
    {
        const label ranks = cmptProduct(parts);
        SCOPED_TRACE(ranks);
        const ProgramCase together(files, control);
        EXPECT_TRUE(succeeds(together.decompose(parts)));
        EXPECT_TRUE(succeeds(together.runOn(ranks)));
        expectSame(alone, together, length);
    }
}

} // namespace

TEST(Ranks, swingWithTheirPartsOfTheMesh)
{
    expectSameInParts(swinging(), "deltaT 1e-3; endTime 0.03; writeInterval 30; writeFormat binary;", 1e-4*diameter);
}

TEST(Ranks, areRunOverByTheMeshThatMovesFirst)
{
    expectSameInParts(swingingFast(), "deltaT 2e-3; endTime 0.04; writeInterval 30; writeFormat binary;", 1e-6);
}

TEST(Ranks, loseGrainsThroughExitsThatMove)
{
    // Dry: homes are asked of the mesh alone.
    Files files = dryFiles("materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid none; "
        "grains { type lattice; box (0.01 0.01 0.005) (0.09 0.09 0.045); count (4 4 2); diameter 0.01; jitter 0.5; velocity (0 0 -1); } "
        "patches { front { type exit; } back { type wall; } }");
    files["constant/dynamicMeshDict"] = swinging().at("constant/dynamicMeshDict");
    const std::string control = "deltaT 1e-3; endTime 0.03; writeInterval 10;";
    const ProgramCase alone(files, control), together(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(1, 2, 2))));
    EXPECT_TRUE(succeeds(together.runOn(4)));
    EXPECT_EQ(alone.reported("0", "exited"), together.reported("0", "exited"));
    EXPECT_GT(alone.reported("0", "exited").back(), 10);
    EXPECT_GT(alone.reported("0", "grains").back(), 0);
}

TEST(Ranks, stirWithHalvesThatSlide)
{
    const std::string control = "deltaT 2e-3; endTime 0.02; writeInterval 10; writeFormat binary;";
    const ProgramCase alone(stirred(""), control);
    EXPECT_TRUE(succeeds(alone.run("blockMesh")));
    EXPECT_TRUE(succeeds(alone.run()));
    for (const labelVector& parts : {labelVector(2, 1, 1), labelVector(1, 3, 1)})
    {
        const label ranks = cmptProduct(parts);
        SCOPED_TRACE(ranks);
        const ProgramCase together(stirred(""), control);
        EXPECT_TRUE(succeeds(together.run("blockMesh")));
        EXPECT_TRUE(succeeds(together.decompose(parts)));
        EXPECT_TRUE(succeeds(together.runOn(ranks)));
        expectSame(alone, together, 1e-3*1.5e-3);
    }
}

TEST(Ranks, goOnWithAMeshThatMovesToTheBit)
{
    const std::string control = "writeFormat binary; deltaT 1e-3; writeInterval 10; ";
    const ProgramCase whole(swinging(), control + "endTime 0.02;"), parts(swinging(), control + "endTime 0.01;");
    runWholeAndInParts(whole, parts, labelVector(1, 2, 1), control + "endTime 0.02;");
    EXPECT_EQ(filesThatDiffer(whole, parts, 2, "0.02", {"U", "p_rgh", "alpha.fluid", "polyMesh/points"}), std::vector<std::string>());
}

TEST(Ranks, goOnWithAMeshThatMovesOnAnotherNumber)
{
    const std::string control = "writeFormat binary; deltaT 1e-3; writeInterval 10; ";
    const ProgramCase whole(swinging(), control + "endTime 0.03;"), parts(swinging(), control + "endTime 0.01;");
    EXPECT_TRUE(succeeds(whole.run()));
    parts.goOnOnFourOneAndTwo(control + "endTime 0.02;", control + "endTime 0.03;");
    for (const char* axis : {"X", "Y", "Z"})
    {
        const std::string column = std::string("massCenter") + axis;
        EXPECT_NEAR(parts.reported("0.02", column).back(), whole.reported("0", column).back(), 1e-3*diameter) << axis;
    }
    EXPECT_EQ(parts.reported("0.02", "grains").back(), 18);
}
