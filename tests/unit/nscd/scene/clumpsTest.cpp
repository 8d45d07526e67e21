// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps and their members: where they are, how they move, what is refused.
#include "nscd/scene/clumps.hpp"
#include "unit/nscd/scenes/clumpScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

const Quaternion turned = Quaternion(1, 0.3, -0.5, 0.2).normalized();
const Vec3 place(0.09, 0.02, 0.3), velocity(1, 2, 3), spin(5, -7, 11);

/// A pebble near a periodic side, beside a single grain.
Scene onePebble()
{
    Scene scene(3, 0.3, 0.0);
    scene.box.length = Vec3(0.1, 0, 0);
    scene.addGrain(Vec3(0.05, 1, 0), memberRadius);
    addClump(scene, addShape(scene, pebble()), place, turned, velocity, spin);
    return scene;
}

} // namespace

TEST(Clumps, membersAreWhereTheShapePutsThemAndMoveAsOneBody)
{
    const Scene scene = onePebble();
    const nscd::Grains& grains = scene.grains;
    const nscd::ClumpShape& shape = grains.clumps.shapeOf(0);
    ASSERT_EQ(grains.size(), 4u);
    double mass = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Vec3 arm = turned*shape.members[k].center;
        EXPECT_LT(scene.box.nearestImage(grains.position[1 + k] - place - arm).norm(), 1e-15);
        EXPECT_LT((grains.velocity[1 + k] - velocity - spin.cross(arm)).norm(), 1e-14);
        EXPECT_LT((grains.omega[1 + k] - spin).norm(), 1e-13);
        mass += grains.mass[1 + k];
    }
    EXPECT_NEAR(mass, shape.mass, 1e-14*mass);
    EXPECT_EQ(nscd::clumpOfGrains(grains), (std::vector<int>{-1, 0, 0, 0}));
    EXPECT_TRUE(nscd::clumpOfGrains(nscd::Grains()).empty());
    EXPECT_NO_THROW(nscd::checkClumps(grains, scene.box));
}

/// m v^2/2 + w.J w/2 with J turned to the world's axes.
TEST(Clumps, energyAndMomentumAreThoseOfARigidBody)
{
    const nscd::Clumps clumps = onePebble().grains.clumps;
    const nscd::ClumpShape& shape = clumps.shapeOf(0);
    const Eigen::Matrix3d inertia = turned.toRotationMatrix()*shape.inertia*turned.toRotationMatrix().transpose();
    EXPECT_LT((nscd::worldInertia(clumps, 0) - inertia).norm(), 1e-14*inertia.norm());
    EXPECT_LT((clumps.angularMomentum[0] - inertia*spin).norm(), 1e-13*clumps.angularMomentum[0].norm());
    EXPECT_LT((nscd::angularVelocity(clumps, 0) - spin).norm(), 1e-12);
    const double energy = 0.5*(shape.mass*velocity.squaredNorm() + spin.dot(inertia*spin));
    EXPECT_NEAR(nscd::kineticEnergy(clumps, 0), energy, 1e-13*energy);
}

TEST(Clumps, membersFollowAClumpThatIsMoved)
{
    Scene scene = onePebble();
    nscd::Clumps& clumps = scene.grains.clumps;
    clumps.position[0] += Vec3(0, 0.5, 0);
    clumps.orientation[0] = Quaternion::Identity();
    EXPECT_THROW(nscd::checkClumps(scene.grains, scene.box), std::invalid_argument);
    nscd::placeMembers(scene.grains, 0, scene.box);
    EXPECT_NO_THROW(nscd::checkClumps(scene.grains, scene.box));
    EXPECT_NEAR(scene.grains.position[1][1], place[1] + 0.5 + clumps.shapeOf(0).members[0].center[1], 1e-15);
}

TEST(Clumps, whatIsNoClumpIsRefused)
{
    const auto isRefused = [](const auto& change)
    {
        Scene scene = onePebble();
        change(scene);
        try
        {
            nscd::checkClumps(scene.grains, scene.box);
            return false;
        }
        catch (const std::invalid_argument&)
        {
            return true;
        }
    };
    EXPECT_FALSE(isRefused([](Scene&) {}));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.clumps.shape[0] = 1; }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.clumps.firstMember[0] = 2; }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.clumps.velocity[0][1] = NAN; }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.clumps.orientation[0].coeffs() *= 1.1; }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.position[2] += Vec3(0, 1e-4, 0); }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.grains.isFixed[3] = 1; }));
    EXPECT_TRUE(isRefused([](Scene& s) { s.box.length[2] = 0.04; }));
    Scene scene = onePebble();
    EXPECT_THROW(addClump(scene, 1, Vec3::Zero()), std::invalid_argument);
    EXPECT_THROW(addClump(scene, 0, Vec3(NAN, 0, 0)), std::invalid_argument);
}
