// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The length of the next step: what limits it, and what does not.
#include "boxMesh.H"
#include "coupling/step/timeStepControl.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// The step after one of 1 ms that reached so far.
scalar nextStep(const StepReach& reach, scalar maxDisplacement, const std::string& control)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(1, 1, 1);
    settings.deltaT = 1e-3;
    IStringStream text(control);
    settings.control = dictionary(text);
    BoxMesh box(settings);
    adjustTimeStep(box.time(), reach, maxDisplacement);
    return box.time().deltaTValue();
}

} // namespace

TEST(TimeStepControl, leavesTheStepAloneUnlessAsked)
{
    EXPECT_EQ(nextStep({100, 100, true}, 0.1, ""), 1e-3);
    EXPECT_EQ(nextStep({100, 100, true}, 0.1, "adjustTimeStep no; maxCo 0.5;"), 1e-3);
}

TEST(TimeStepControl, growsByAFifthAtTheMost)
{
    EXPECT_NEAR(nextStep({0, 0, true}, 0, "adjustTimeStep yes;"), 1.2e-3, 1e-15);
    EXPECT_NEAR(nextStep({0.01, 0.01, true}, 0.5, "adjustTimeStep yes; maxCo 0.5;"), 1.2e-3, 1e-15);
}

TEST(TimeStepControl, keepsTheNarrowerLimit)
{
    EXPECT_NEAR(nextStep({2, 0.01, true}, 0.5, "adjustTimeStep yes; maxCo 0.5;"), 0.25e-3, 1e-15);
    EXPECT_NEAR(nextStep({0.5, 2, true}, 0.2, "adjustTimeStep yes; maxCo 0.5;"), 0.1e-3, 1e-15);
    EXPECT_NEAR(nextStep({0.45, 0.5, true}, 0, "adjustTimeStep yes; maxCo 0.5;"), 1e-3/0.9, 1e-15) << "no limit for grains";
    EXPECT_NEAR(nextStep({0.5, 0, true}, 0.5, "adjustTimeStep yes;"), 1.2e-3, 1e-15) << "maxCo is 1 where nothing is said";
    EXPECT_NEAR(nextStep({2, 0, true}, 0.5, "adjustTimeStep yes;"), 0.5e-3, 1e-15);
}

TEST(SubCycles, areThoseAskedForOrWhatImpactsAskFor)
{
    GrainTimeSettings settings;
    settings.subCycles = 3;
    EXPECT_EQ(subCyclesOf(settings, 1e-3, 1e6), 3) << "no limit of impacts";
    settings.maxGrainImpacts = 0.25;
    EXPECT_EQ(subCyclesOf(settings, 1e-3, 0), 3);
    EXPECT_EQ(subCyclesOf(settings, 1e-3, 1000), 4) << "one in a step";
    EXPECT_EQ(subCyclesOf(settings, 1e-3, 1001), 5);
    EXPECT_EQ(subCyclesOf(settings, 2e-3, 1000), 8);
    EXPECT_EQ(subCyclesOf(settings, 1e-3, 1e9), 50);
    EXPECT_EQ(expectedImpactRate(100, 0.5, 1e-3), 500);
    EXPECT_EQ(expectedImpactRate(1000, 0.5, 1e-3), 900) << "a peak is forgotten within some steps";
}

TEST(TimeStepControl, endsAtTheLongestStepAllowed)
{
    EXPECT_NEAR(nextStep({0, 0, true}, 0, "adjustTimeStep yes; maxDeltaT 1.1e-3;"), 1.1e-3, 1e-15);
    EXPECT_NEAR(nextStep({0, 0, true}, 0, "adjustTimeStep yes; maxDeltaT 0.2e-3;"), 0.2e-3, 1e-15);
}
