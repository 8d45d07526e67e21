// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of nscdDEMFoam on processor folders that do not fit: what is found, what is expected and what to do is said, and nothing hangs.
#include "caseTools.H"
#include "programCase.H"

#include "OSspecific.H"

#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Stopped by an error of OpenFOAM's kind, by none of the system's and not by running out of time, with these pieces of text.
::testing::AssertionResult isRefused(const ProgramCase& c, label ranks, const std::vector<std::string>& pieces)
{
    const ProgramRun run = c.runOn(ranks);
    if (run.status != 1) return ::testing::AssertionFailure() << "status " << run.status << ": " << run.log;
    return holds(run.log, pieces);
}

/// 18 grains in a fluid, cut into parts and not run yet.
struct CutCase : ProgramCase
{
    explicit CutCase(const labelVector& parts, const BoxMeshSettings& box = programBox())
    :
        ProgramCase(Files(), "endTime 0.002; writeInterval 2;", box)
    {
        EXPECT_TRUE(succeeds(decompose(parts)));
    }
};

/// Puts another case's folder in the place of this one's.
void replaceFolder(const ProgramCase& c, const ProgramCase& other, const fileName& folder)
{
    rmDir(c.path(folder));
    cp(other.path(folder), c.path(folder));
}

} // namespace

TEST(Ranks, refuseFoldersOfAnotherNumberOfRanks)
{
    const CutCase c(labelVector(2, 1, 1));
    rmDir(c.path("processor1"));
    EXPECT_TRUE(isRefused(c, 2, {"processor folders are missing", "processor1", "decomposePar -force"}));
    rmDir(c.path("processor0"));
    EXPECT_TRUE(isRefused(c, 2, {"cannot open case directory", "processor0"}));

    EXPECT_TRUE(succeeds(c.decompose(labelVector(3, 1, 1))));
    EXPECT_TRUE(isRefused(c, 2, {"decomposeParDict", "specifies 3 processors", "started with 2"}));
    c.write("system/decomposeParDict", "numberOfSubdomains 2; method simple; simpleCoeffs { delta 0.001; n (2 1 1); }");
    EXPECT_TRUE(isRefused(c, 2, {"are more than the ranks", "processor2 and 2 ranks", "decomposePar -force"}));
}

TEST(Ranks, refuseFoldersOfDifferentDecompositions)
{
    // As many faces are shared along y, and more along z.
    for (const auto& test : {std::make_pair(labelVector(1, 2, 1), "elsewhere"), std::make_pair(labelVector(1, 1, 2), "shares 32 faces")})
    {
        const CutCase c(labelVector(2, 1, 1)), other(test.first);
        replaceFolder(c, other, "processor1");
        EXPECT_TRUE(isRefused(c, 2, {"of different decompositions", test.second, "processor1", "decomposePar -force"}));
    }
}

TEST(Ranks, refuseFoldersCutFromAnotherMesh)
{
    BoxMeshSettings finer = programBox();
    finer.cells.z() = 10;
    const CutCase c(labelVector(2, 1, 1)), other(labelVector(2, 1, 1), finer);
    replaceFolder(c, other, "constant/polyMesh");
    EXPECT_TRUE(isRefused(c, 2, {"cut from another mesh", "128 cells in all", "160 cells", "constant/polyMesh"}));
}

TEST(Ranks, sayWhatAWrittenTimeLacks)
{
    const CutCase c(labelVector(2, 1, 1));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    c.writeControl("endTime 0.004;");
    const auto refusedWithout = [&](const fileName& file, const std::vector<std::string>& pieces)
    {
        const fileName path = c.path(file), aside = c.path("aside");
        mv(path, aside);
        const ::testing::AssertionResult result = isRefused(c, 2, pieces);
        mv(aside, path);
        return result;
    };
    EXPECT_TRUE(refusedWithout("processor1/0.002", {"0.002 is the latest time", "processor1", "remove the directory 0.002 of all"}));
    EXPECT_TRUE(refusedWithout("processor1/0.002/phi", {"phi is missing on some", "processor1", "0.002/phi", "remove the directory 0.002"}));
    mv(c.path("processor0/0.002/phi"), c.path("other"));
    EXPECT_TRUE(refusedWithout("processor1/0.002/phi", {"processor*/0.002/phi", "is missing", "processor0, processor1", "out of `files`"}));
    mv(c.path("other"), c.path("processor0/0.002/phi"));
    cp(c.path("processor1/0.002/phi"), c.path("other"));
    std::ofstream(c.path("processor1/0.002/phi")) << "";
    EXPECT_TRUE(isRefused(c, 2, {"processor*/0.002/phi", "is empty", "processor1"}));
    cp(c.path("other"), c.path("processor1/0.002/phi"));
    EXPECT_TRUE(refusedWithout("processor1/0.002/lagrangian/grains", {"origId", "no file on processor1", "18 values"}));
    EXPECT_TRUE(refusedWithout("processor1/0.002/lagrangian/grains/U", {"processor1/0.002/lagrangian/grains/U", "missing, truncated"}));
    EXPECT_TRUE(refusedWithout("processor0/0.002/uniform/grainState", {"processor0/0.002/uniform/grainState", "not written to its end"}));
    // The first rank completes its grainState when all others are done.
    rm(c.path("processor1/0.002/uniform/grainState"));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    EXPECT_EQ(c.reported("0.002", "time").size(), 2u);
}

TEST(Ranks, startFromATimeThatAllHave)
{
    // With startTime, what some lack at a later time does not matter.
    const CutCase c(labelVector(2, 1, 1));
    EXPECT_TRUE(succeeds(c.runOn(2)));
    rmDir(c.path("processor1/0.002"));
    c.writeControl("startFrom startTime; startTime 0; endTime 0.002; writeInterval 2;");
    EXPECT_TRUE(succeeds(c.runOn(2)));
}
