// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a scene asks of the method, in words.
#include "nscd/tools/sceneWork.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace nscd;

namespace
{

std::string workOf(const ContactPair& pair, bool isSleeping = false, const GrainShape& shape = GrainShape())
{
    Materials materials;
    materials.add("glass");
    materials.setPair(0, 0, pair);
    ContactSettings settings;
    settings.vectorPath = "portable";
    settings.sleep = isSleeping;
    return describeWork(materials, shape, settings);
}

} // namespace

TEST(SceneWork, namesWhatIsDoneInEveryStep)
{
    EXPECT_EQ(workOf({0.0, 0.0}), "portable, normal impulses only, no restitution pass");
    EXPECT_EQ(workOf({0.5, 0.8}, true), "portable, friction, restitution, grains at rest may sleep");
    EXPECT_EQ(workOf({0.5, 0.0, 0.1, 0.0, 1e-3, 0.0}), "portable, friction, cohesion, rolling or spinning friction, no restitution pass");
    GrainShape discs;
    discs.dimensions = 2;
    EXPECT_EQ(workOf({0.5, 0.0}, false, discs), "portable, friction, no restitution pass");
    discs.emptyAxis = 1;
    EXPECT_EQ(workOf({0.5, 0.0}, false, discs), "portable, discs in a plane, no restitution pass");
}

TEST(SceneWork, aVectorPathThatIsNotThereIsRefused)
{
    ContactSettings settings;
    settings.vectorPath = "SSE9";
    EXPECT_THROW(describeWork(Materials(), GrainShape(), settings), std::invalid_argument);
}
