// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Overlapping clumps are shifted and turned apart: gaps, mass center, nothing else.
#include "nscd/step/generalCorrection.hpp"
#include "nscd/step/contactStep.hpp"
#include "nscd/step/generalMotion.hpp"
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/lists.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, deadBand = 1e-6*memberRadius, tolerance = 1e-5*memberRadius;

/// Two crossed dumbbells and a sphere, each of which overlaps the next one, off its middle.
Scene overlapping()
{
    Scene scene(3, 0.3, 0.0);
    const int shape = addShape(scene, dumbbell(1.5));
    addClump(scene, shape, Vec3::Zero());
    addClump(scene, shape, memberRadius*Vec3(0.7, 0.4, 1.8), Quaternion(Eigen::AngleAxisd(1.4, Vec3::UnitZ())));
    scene.addGrain(memberRadius*Vec3(-1.2, 0.3, -1.7), memberRadius);
    return scene;
}

} // namespace

TEST(GeneralCorrection, removesOverlapAndKeepsTheMassCenterAndVelocities)
{
    Scene scene = overlapping();
    nscd::ContactList list = listContacts(scene, 0.5*memberRadius);
    nscd::setFreeVelocities(list, scene.grains, nscd::ExternalForces(), deltaT, nscd::GrainSleep());
    nscd::setFreeGeneral(list, scene.grains, nscd::ExternalForces(), deltaT, nscd::GrainSleep());
    const nscd::Grains before = scene.grains;
    double deepest = nscd::measureOverlap(list).deepest;
    ASSERT_GT(deepest, 0.05*memberRadius);
    for (int pass = 0; pass < 6 && deepest > tolerance; ++pass)
    {
        EXPECT_LT(nscd::correctGeneralOverlaps(list, scene.grains, partsOf(scene), {}, deepest, tolerance, deadBand), 50);
        const double now = nscd::measureOverlap(list).deepest;
        EXPECT_LT(now, 0.5*deepest);
        deepest = now;
    }
    EXPECT_LT(deepest, tolerance);
    scene.grains.position.back() = list.position[bodyOf(list, 4)];   // the sphere, which the list alone has moved
    EXPECT_LT((nscd::massCenter(scene.grains) - nscd::massCenter(before)).norm(), 1e-12*memberRadius);
    EXPECT_GT(scene.grains.clumps.orientation[0].angularDistance(before.clumps.orientation[0]), 1e-3);
    EXPECT_EQ(scene.grains.clumps.velocity, before.clumps.velocity);
    EXPECT_EQ(scene.grains.velocity, before.velocity);
    EXPECT_NO_THROW(nscd::checkClumps(scene.grains, scene.box));
}
