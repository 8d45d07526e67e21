// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of constant/dynamicMeshDict: a closed box that swings with water and grains in it, a restart, and what does not go with it.
#include "swingingCase.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

::testing::AssertionResult isRefusedOnMovingMesh(const std::string& more, const std::vector<std::string>& pieces)
{
    std::vector<std::string> all = {"constant/dynamicMeshDict", "dynamicFvMesh", "moves the mesh"};
    all.insert(all.end(), pieces.begin(), pieces.end());
    return isRefused(ProgramCase(swinging(more)), all);
}

TEST(MovingMesh, keepsGrainsAndTheirVolumeInABoxThatSwings)
{
    const ProgramCase c(swinging(), "deltaT 1e-3; endTime 0.05; writeInterval 50; writeFormat binary; ");
    ASSERT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "grains").back(), 18);
    EXPECT_LT(largest(c.reported("0", "volumeError")), 1e-10);
    EXPECT_LT(largest(c.reported("0", "overlapMax")), 1e-3);
    // A box that swings by 20 degrees takes along what is in it; in one at rest grains fall straight down.
    Files still = swinging();
    still.erase("constant/dynamicMeshDict");
    const ProgramCase atRest(still, "deltaT 1e-3; endTime 0.05; writeInterval 50; ");
    ASSERT_TRUE(succeeds(atRest.run()));
    const auto sideways = [](const ProgramCase& which)
    {
        const std::vector<double> y = which.reported("0", "massCenterY");
        return std::abs(y.back() - y.front());
    };
    EXPECT_GT(sideways(c), 20*sideways(atRest));
    EXPECT_GT(sideways(c), 1e-3);
}

TEST(MovingMesh, mayRunOverGrainsThatMoveAfterIt)
{
    const ProgramCase c(swingingFast(), "deltaT 2e-3; endTime 0.1; writeInterval 50; writeFormat binary; ");
    ASSERT_TRUE(succeeds(c.run()));
    EXPECT_EQ(c.reported("0", "time").size(), 50u);
    EXPECT_EQ(c.reported("0", "grains").back(), 12);
    EXPECT_LT(largest(c.reported("0", "volumeError")), 1e-10);
    EXPECT_LT(largest(c.reported("0", "overlapMax")), 1e-3);
}

TEST(MovingMesh, goesOnAsIfItHadNotStopped)
{
    const std::string steps = "deltaT 1e-3; writeControl timeStep; writeInterval 20; writeFormat binary; ";
    const ProgramCase whole(swinging(), steps + "endTime 0.04;"), parts(swinging(), steps + "endTime 0.02;");
    ASSERT_TRUE(succeeds(whole.run()));
    ASSERT_TRUE(succeeds(parts.run()));
    parts.writeControl(steps + "endTime 0.04;");
    ASSERT_TRUE(succeeds(parts.run()));
    ASSERT_EQ(parts.reported("0.02", "massCenterZ").size(), 20u);
    for (const char* file : {"U", "p_rgh", "alpha.fluid", "polyMesh/points", "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/contacts/impulse"})
    {
        const std::string expected = whole.contents("0.04/" + std::string(file));
        EXPECT_FALSE(expected.empty()) << file;
        EXPECT_TRUE(parts.contents("0.04/" + std::string(file)) == expected) << file;
    }
}

TEST(MovingMesh, refusesInWordsWhatDoesNotGoWithIt)
{
    EXPECT_TRUE(isRefusedOnMovingMesh("timeStep { subCycles 2; }", {"`subCycles 1`"}));
    EXPECT_TRUE(isRefusedOnMovingMesh("timeStep { maxGrainImpacts 0.3; }", {"no `maxGrainImpacts`"}));
    Files turning = swinging();
    turning["constant/MRFProperties"] = "rotor { cellZone rotor; origin (0 0 0); axis (0 0 1); omega 2; }";
    EXPECT_TRUE(isRefused(ProgramCase(turning), {"constant/dynamicMeshDict", "rotating frame"}));
    Files seldom = swinging();
    seldom["constant/dynamicMeshDict"] += " updateControl timeStep; updateInterval 2;";
    EXPECT_TRUE(isRefused(ProgramCase(seldom), {"constant/dynamicMeshDict", "updateInterval", "now and then", "every step"}));
    Files unnamed = swinging();
    unnamed["constant/dynamicMeshDict"] = "motionSolver solidBody;";
    EXPECT_TRUE(isRefused(ProgramCase(unnamed), {"constant/dynamicMeshDict", "dynamicFvMesh", "is missing"}));
    Files unknown = swinging();
    unknown["constant/dynamicMeshDict"] = "dynamicFvMesh movingFvMesh;";
    EXPECT_TRUE(isRefused(ProgramCase(unknown), {"movingFvMesh", "dynamicMotionSolverFvMesh"}));
}

} // namespace
