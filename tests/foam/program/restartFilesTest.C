// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Restarts from times of which files are missing or empty: refused where the run would go on otherwise than it would have, and no others.
#include "caseTools.H"
#include "programCase.H"

#include "OSspecific.H"

#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// A second order in time keeps fluxes of two steps.
ProgramCase stoppedRun()
{
    const ProgramCase c;
    const std::string text = c.contents("system/fvSchemes"), schemes = text.substr(text.find("ddtSchemes"));
    return ProgramCase(Files{{"system/fvSchemes", with(schemes, "Euler", "backward")}}, "writeInterval 5;");
}

/// A run to 0.01, gone on with to 0.02.
void runOnce(const ProgramCase& c)
{
    ASSERT_TRUE(succeeds(c.run()));
    c.writeControl("writeInterval 5; endTime 0.02;");
}

::testing::AssertionResult isRestartRefused(const ProgramCase& c, const std::vector<std::string>& pieces)
{
    const std::string last = c.latestTime();
    const ProgramRun run = c.run();
    if (run.status != 1) return ::testing::AssertionFailure() << "status " << run.status << ": " << run.log;
    if (c.latestTime() != last) return ::testing::AssertionFailure() << "it went on: " << run.log;
    return holds(run.log, pieces);
}

/// A file as it was, when this ends.
class Aside
{
public:
    explicit Aside(const fileName& path) : path_(path) { mv(path, path + ".aside"); }
    ~Aside() { mv(path_ + ".aside", path_); }

private:
    fileName path_;
};

} // namespace

TEST(RestartFiles, thatAreMissingOrEmptyAreNamed)
{
    const ProgramCase c = stoppedRun();
    runOnce(c);
    const std::vector<fileName> files =
    {
        "phi", "phi_0", "divTau", "alpha.fluid", "balancedGradient", "U", "uniform/time", "lagrangian/grains/ownWake", "lagrangian/grains/fFluid"
    };
    for (const fileName& file : files)
    {
        ASSERT_TRUE(isFile(c.path("0.01"/file))) << file;
        const Aside aside(c.path("0.01"/file));
        EXPECT_TRUE(isRestartRefused(c, {"0.01/" + file, "is missing", "would not go on", "as 0.005", "out of `files` in uniform/grainState"})) << file;
        std::ofstream(c.path("0.01"/file)) << "";
        EXPECT_TRUE(isRestartRefused(c, {"0.01/" + file})) << file;
    }
    EXPECT_TRUE(succeeds(c.run()));
}

TEST(RestartFiles, thatARunMakesAnewMayBeMissing)
{
    const ProgramCase c = stoppedRun();
    runOnce(c);
    for (const fileName file : {"p", "lagrangian/grains/positions", "lagrangian/grains/coordinates", "lagrangian/contacts/origProcId"})
    {
        EXPECT_TRUE(rm(c.path("0.01"/file))) << file;
    }
    EXPECT_TRUE(succeeds(c.run()));
}

TEST(RestartFiles, mayBeMissingWhereTheTimeDoesNotNameThem)
{
    const ProgramCase c = stoppedRun();
    runOnce(c);
    rm(c.path("0.01/phi"));
    const std::string state = c.contents("0.01/uniform/grainState");
    std::ofstream(c.path("0.01/uniform/grainState")) << with(state, "\"phi\"", "");
    EXPECT_TRUE(succeeds(c.run()));
}

/// The first files of a time, as a copy leaves them that was killed.
TEST(RestartFiles, ofATimeThatWasNotCopiedToItsEnd)
{
    const ProgramCase c = stoppedRun();
    runOnce(c);
    mkDir(c.path("0.011"));
    for (const char* file : {"U", "alpha.fluid"}) cp(c.path(fileName("0.01")/file), c.path(fileName("0.011")/file));
    EXPECT_TRUE(isRestartRefused(c, {"0.011/uniform/grainState", "is missing or incomplete", "remove the directory 0.011"}));
    c.writeControl("startFrom startTime; startTime 0.011; endTime 0.02;");
    EXPECT_TRUE(isRestartRefused(c, {"0.011/p_rgh", "p_rgh is missing", "remove its directory", "an earlier one, as 0.01"}));
    // Who names the time may start anew from what was mapped to it.
    cp(c.path("0.01/p_rgh"), c.path("0.011/p_rgh"));
    EXPECT_TRUE(succeeds(c.run()));
}

TEST(RestartFiles, haveAVersionThatOpenFOAMCanRead)
{
    const ProgramCase c = stoppedRun();
    runOnce(c);
    for (const fileName file : {"uniform/grainState", "phi", "lagrangian/grains/d"})
    {
        const fileName path = c.path("0.01"/file);
        const std::string text = c.contents("0.01"/file);
        std::ofstream(path) << with(text, "2.0;", "-1e30;");
        EXPECT_TRUE(isRestartRefused(c, {"0.01/" + file, "FoamFile.version is out of range", "-1e+30"})) << file;
        std::ofstream(path) << text;
    }
    EXPECT_TRUE(succeeds(c.run()));
}
