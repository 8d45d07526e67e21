// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam itself on small cases: what stops it before the first step, what it writes, and restarts.
#include "caseTools.H"
#include "programCase.H"

#include "OSspecific.H"

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string grains =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.4; } }"
    "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; jitter 0.5; }"
    "patches { front { type wall; } back { type exit; } } ";

/// Stopped with status 1 and these pieces of text, and no step was taken.
::testing::AssertionResult isRefused(const ProgramCase& c, const std::vector<std::string>& pieces, const std::string& arguments = "")
{
    const ProgramRun run = c.run("nscdDEMFoam", arguments);
    if (run.status != 1) return ::testing::AssertionFailure() << "status " << run.status << ": " << run.log;
    if (!c.reported("0", "time").empty()) return ::testing::AssertionFailure() << "a step was taken: " << run.log;
    return holds(run.log, pieces);
}

::testing::AssertionResult isRefusedWith
(
    const std::string& file, const std::string& contents, const std::vector<std::string>& pieces
)
{
    return isRefused(ProgramCase(Files{{file, contents}}), pieces);
}

::testing::AssertionResult succeeds(const ProgramRun& run)
{
    return run.status == 0 ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << run.status << ": " << run.log;
}

} // namespace

TEST(Program, stopsAtBadGrainPropertiesWithFileAndLine)
{
    EXPECT_TRUE(isRefusedWith("constant/grainProperties", "\n\n" + grains + "\nfeedbak off;",
        {"constant/grainProperties", "line 5", "feedbak", "nearest: feedback"}));
}

TEST(Program, stopsWhereAFileIsMissing)
{
    const std::vector<std::string> files =
    {
        "constant/grainProperties", "constant/g", "constant/transportProperties", "constant/turbulenceProperties",
        "0/U", "0/p_rgh", "system/fvSchemes", "system/fvSolution"
    };
    for (const std::string& file : files) EXPECT_TRUE(isRefusedWith(file, "", {fileName(file).name()})) << file;
}

TEST(Program, stopsAtTimeControlsThatAreNotPositive)
{
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT 0;"), {"system/controlDict", "deltaT"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "deltaT -1e-3;"), {"system/controlDict", "deltaT"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "writeControl runTime; writeInterval -1;"), {"controlDict", "writeInterval"}));
    EXPECT_TRUE(isRefused(ProgramCase(Files(), "adjustTimeStep yes; maxDeltaT -1;"), {"controlDict", "maxDeltaT"}));
}

TEST(Program, runsWithTheShortestGrainProperties)
{
    const ProgramCase c;
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "time").size(), 10u);
    EXPECT_EQ(c.reported("0", "grains").back(), 18);
    for (const char* file : {"U", "p_rgh", "p", "alpha.fluid", "phi", "lagrangian/grains/positions", "lagrangian/grains/fFluid"})
    {
        EXPECT_TRUE(isFile(c.path("0.01")/file)) << file;
    }
}

TEST(Program, runsWithoutFluidFields)
{
    Files files;
    for (const char* file : {"constant/transportProperties", "constant/turbulenceProperties", "0/U", "0/p_rgh"}) files[file] = "";
    files["constant/grainProperties"] = grains + "fluid none;";
    const ProgramCase c(files);
    EXPECT_TRUE(succeeds(c.run()));
    // Free fall of all grains: z falls by g dt^2 n(n+1)/2 in n steps of the symplectic Euler scheme.
    const std::vector<double> z = c.reported("0", "massCenterZ");
    ASSERT_EQ(z.size(), 10u);
    EXPECT_NEAR(z[9] - z[0], -9.81e-6*(55 - 1), 1e-12);
}

TEST(Program, runsWithoutGrains)
{
    const ProgramCase c(Files{{"constant/grainProperties", "materials { glass { density 1; } } contacts {} grains {}"}});
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "grains").back(), 0);
}

TEST(Program, runsWithTheDragSwitchedOffAndSubCycles)
{
    const ProgramCase c(Files{{"constant/grainProperties", grains + "forces { drag { law none; } } timeStep { subCycles 3; }"}});
    EXPECT_TRUE(succeeds(c.run()));
}
