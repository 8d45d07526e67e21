// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of constant/dynamicMeshDict: a closed box that swings with water and grains in it, a restart, and what does not go with it.
#include "programCase.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string grains =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; } }"
    "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; jitter 0.5; }"
    "patches { \"(front|back)\" { type wall; } } ";

const std::string swing =
    "dynamicFvMesh dynamicMotionSolverFvMesh;\nmotionSolver solidBody;\nsolidBodyMotionFunction oscillatingRotatingMotion;\n"
    "oscillatingRotatingMotionCoeffs { origin (0.05 0.05 0); amplitude (20 0 0); omega 30; }";

Files swinging(const std::string& more = "")
{
    return
    {
        {"constant/grainProperties", grains + more},
        {"constant/dynamicMeshDict", swing},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \".*\" { type movingWallVelocity; value uniform (0 0 0); } }"},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { \".*\" { type fixedFluxPressure; value uniform 0; } }"}
    };
}

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

TEST(MovingMesh, goesOnAsIfItHadNotStopped)
{
    const std::string steps = "deltaT 1e-3; writeControl timeStep; writeInterval 20; writeFormat binary; ";
    const ProgramCase whole(swinging(), steps + "endTime 0.04;"), parts(swinging(), steps + "endTime 0.02;");
    ASSERT_TRUE(succeeds(whole.run()));
    ASSERT_TRUE(succeeds(parts.run()));
    parts.writeControl(steps + "endTime 0.04;");
    ASSERT_TRUE(succeeds(parts.run()));
    const std::vector<double> expected = whole.reported("0", "massCenterZ"), z = parts.reported("0.02", "massCenterZ");
    ASSERT_EQ(z.size(), 20u);
    EXPECT_NEAR(z.back(), expected.back(), 1e-6);
}

TEST(MovingMesh, refusesInWordsWhatDoesNotGoWithIt)
{
    EXPECT_TRUE(isRefusedOnMovingMesh("timeStep { subCycles 2; }", {"`subCycles 1`"}));
    Files turning = swinging();
    turning["constant/MRFProperties"] = "rotor { cellZone rotor; origin (0 0 0); axis (0 0 1); omega 2; }";
    EXPECT_TRUE(isRefused(ProgramCase(turning), {"constant/dynamicMeshDict", "rotating frame"}));
    Files unnamed = swinging();
    unnamed["constant/dynamicMeshDict"] = "motionSolver solidBody;";
    EXPECT_TRUE(isRefused(ProgramCase(unnamed), {"constant/dynamicMeshDict", "dynamicFvMesh", "is missing"}));
    Files unknown = swinging();
    unknown["constant/dynamicMeshDict"] = "dynamicFvMesh movingFvMesh;";
    EXPECT_TRUE(isRefused(ProgramCase(unknown), {"movingFvMesh", "dynamicMotionSolverFvMesh"}));
}

} // namespace
