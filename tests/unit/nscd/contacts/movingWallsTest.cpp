// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls that move: lids, belts, shakers, blades; forces, torques, restarts.
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/restarts.hpp"

#include <gtest/gtest.h>

using namespace scenes;
using nscd::Triangle;

namespace
{

constexpr double radius = 0.1, deltaT = 1e-3;

Scene onFloor(double friction)
{
    Scene scene(3, friction, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addGrain(Vec3(0, 0, radius), radius);
    return scene;
}

/// Share of a belt's speed that a sphere from rest takes on when it begins to roll: kappa/(1 + kappa).
constexpr double rollingShare = 2.0/7.0;

} // namespace

/// A sphere dropped on a belt slips for t = (2/7) v/(mu g), a/(mu g) = 1 meanwhile, and then rolls: v = v_belt - R omega.
TEST(MovingWall, aBeltDragsASphere)
{
    const double friction = 0.3, speed = 1.0;
    Scene scene = onFloor(friction);
    scene.walls.setSurfaceMotion(0, nscd::belt(Vec3(speed, 0, 0.7)));  // what is normal to the wall is left out
    auto dynamics = scene.build();
    const double slipping = rollingShare*speed/(friction*gravity);
    for (int k = 1; k <= 400; ++k)
    {
        step(dynamics, scene.g, deltaT);
        const double t = k*deltaT;
        const double expected = t < slipping ? friction*gravity*t : rollingShare*speed;
        ASSERT_NEAR(dynamics.grains().velocity[0][0], expected, 1e-9) << "time " << t;
        if (t > slipping) { ASSERT_NEAR(dynamics.grains().velocity[0][0] - radius*dynamics.grains().omega[0][1], speed, 1e-9); }
        const double weight = dynamics.grains().mass[0]*gravity;
        ASSERT_NEAR(dynamics.wallForce()[0][2], -weight, 1e-7*weight);
        if (t < slipping - deltaT) { ASSERT_NEAR(dynamics.wallForce()[0][0], -friction*weight, 1e-7*weight); }
    }
    EXPECT_NEAR(dynamics.grains().position[0][2], radius, 1e-12);
}

TEST(MovingWall, aTurningSurfaceDragsAlongItsCircle)
{
    Scene scene = onFloor(0.5);
    scene.walls.setSurfaceMotion(0, nscd::turningSurface(Vec3(0, 0, 0), Vec3(0, 0, 5)));
    scene.grains.position[0] = Vec3(0.02, 0, radius);
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    // Drawn along the circle: velocity of the surface is (0, 5*0.02, 0); a sphere from rest gets 2/7 of it at most.
    EXPECT_NEAR(dynamics.grains().velocity[0][0], 0, 1e-12);
    EXPECT_NEAR(dynamics.grains().velocity[0][1], std::min(0.5*gravity*deltaT, 0.1*rollingShare), 1e-12);
}

TEST(MovingWall, aLidComesDownAndPressesNothingThrough)
{
    // Down at 0.5 m/s until it is 5 mm above a grain's top, then it lies there; the grain is thrown at by nobody.
    Scene scene = onFloor(0.3);
    const int lid = scene.walls.addPatch("lid", 1);
    scene.walls.addPlane(lid, Vec3(0, 0, 0.4), -Vec3::UnitZ());
    scene.walls.setMotion(lid, nscd::translationBy([](double t) { return Vec3(0, 0, -std::min(0.5*t, 0.2)); }));
    auto dynamics = scene.build();
    for (int k = 0; k < 600; ++k) step(dynamics, scene.g, deltaT);
    const double weight = dynamics.grains().mass[0]*gravity;
    EXPECT_NEAR(dynamics.walls().patches[lid].pose.translation()[2], -0.2, 1e-15);
    EXPECT_NEAR(dynamics.grains().position[0][2], radius, 1e-4*radius);
    EXPECT_NEAR((dynamics.wallForce()[0] + dynamics.wallForce()[lid])[2], -weight, 1e-6*weight);
}

/// A piston lifts a grain at constant speed, and its force is the weight; then it lifts with acceleration a, and the force is m (g + a).
TEST(MovingWall, aPistonLifts)
{
    const double a = 2.0;
    Scene scene(3, 0.3, 0.0);
    const int piston = scene.walls.addPatch("piston", 1);
    scene.walls.addPolygon(piston, {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)});
    scene.walls.patches[piston].torquePoint = Vec3(0.5, 0, 0);
    scene.walls.setMotion(piston, nscd::translationBy([a](double t) { return Vec3(0, 0, 0.5*a*t*t); }));
    scene.addGrain(Vec3(0.2, 0.1, radius), radius);
    auto dynamics = scene.build();
    const double mass = dynamics.grains().mass[0];
    step(dynamics, scene.g, deltaT);
    for (int k = 1; k < 500; ++k)
    {
        step(dynamics, scene.g, deltaT);
        ASSERT_NEAR(dynamics.wallForce()[piston][2], -mass*(gravity + a), 1e-6*mass*gravity) << k;
        const double t = dynamics.time();
        ASSERT_NEAR(dynamics.grains().position[0][2] - radius - 0.5*a*t*t, 0, 1e-9) << k;
        const Vec3 arm = Vec3(0.2, 0.1, 0) - Vec3(0.5, 0, 0);
        const Vec3 torque = Vec3(arm[0], arm[1], 0).cross(dynamics.wallForce()[piston]);
        ASSERT_NEAR((dynamics.wallTorque()[piston] - torque).norm(), 0, 1e-6*mass*gravity) << k;
    }
}

/// z = A sin(w t): the grain leaves where the floor's acceleration passes -g, at sin(w t) = g/(A w^2), flies, and lands.
TEST(MovingWall, aShakenGrainLeavesAndLandsWhenItMust)
{
    const double amplitude = 0.004, frequency = 10, w = 2*M_PI*frequency;   // A w^2 = 1.6 g
    const double dt = 2e-5;
    Scene scene = onFloor(0.0);
    scene.walls.setMotion(0, nscd::oscillation(Vec3(0, 0, amplitude), frequency));
    nscd::ContactSettings settings = tight();
    settings.deadBand = 1e-9;
    auto dynamics = scene.build(settings);
    const auto floor = [&](double t) { return amplitude*std::sin(w*t); };
    double left = -1, landed = -1;
    for (int k = 0; k < 6000 && landed < 0; ++k)
    {
        step(dynamics, scene.g, dt);
        const bool touches = !dynamics.contacts().empty();
        if (left < 0 && k > 10 && !touches) left = dynamics.time();
        if (left > 0 && touches) landed = dynamics.time();
    }
    const double expectedLeft = std::asin(gravity/(amplitude*w*w))/w;
    EXPECT_NEAR(left, expectedLeft, 2*dt);
    // The flight, by bisection.
    const double z0 = floor(expectedLeft), v0 = amplitude*w*std::cos(w*expectedLeft);
    const auto above = [&](double t) { return z0 + v0*(t - expectedLeft) - 0.5*gravity*(t - expectedLeft)*(t - expectedLeft) - floor(t); };
    double low = expectedLeft + 0.01, high = expectedLeft + 0.2;
    while (above(high) > 0) high += 0.05;
    for (double t = low; t < high; t += 1e-4)
    {
        if (above(t) < 0) { high = t; break; }
        low = t;
    }
    for (int k = 0; k < 60; ++k) (above(0.5*(low + high)) > 0 ? low : high) = 0.5*(low + high);
    EXPECT_NEAR(landed, low, 10*dt);
}

TEST(MovingWall, aGentlyShakenGrainFollows)
{
    const double amplitude = 0.002, frequency = 10;   // A w^2 = 0.8 g
    Scene scene = onFloor(0.0);
    scene.walls.setMotion(0, nscd::oscillation(Vec3(0, 0, amplitude), frequency));
    auto dynamics = scene.build();
    step(dynamics, scene.g, deltaT);
    for (int k = 1; k < 300; ++k)
    {
        step(dynamics, scene.g, deltaT);
        ASSERT_EQ(dynamics.contacts().size(), 1u) << k;
        ASSERT_NEAR(dynamics.grains().position[0][2] - radius, amplitude*std::sin(2*M_PI*frequency*dynamics.time()), 2e-5) << k;
    }
}

/// A fast blade, many grain sizes a step, takes a grain along and is not passed; both blade sides do.
TEST(MovingWall, aBladeSweepsGrainsAlong)
{
    for (double sign : {1.0, -1.0})
    {
        Scene scene(3, 0.0, 0.0);
        scene.g = Vec3::Zero();
        const int blade = scene.walls.addPatch("blade", 1);
        scene.walls.addTriangles(blade, {{Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 1, 1)}, {Vec3(0, -1, -1), Vec3(0, 1, 1), Vec3(0, -1, 1)}});
        const double speed = 5*radius/deltaT;
        scene.walls.setMotion(blade, nscd::translation(sign*Vec3(speed, 0, 0)));
        scene.addGrain(sign*Vec3(30*radius, 0.1, 0.2), radius);
        scene.addGrain(sign*Vec3(-30*radius, 0.1, 0.2), radius);
        auto dynamics = scene.build();
        for (int k = 0; k < 40; ++k)
        {
            step(dynamics, scene.g, deltaT);
            const double at = speed*dynamics.time();
            ASSERT_GT(sign*dynamics.grains().position[0][0], at + radius*(1 - 1e-6)) << k;
        }
        EXPECT_NEAR(dynamics.grains().velocity[0][0], sign*speed, 1e-6*speed);
        EXPECT_EQ(dynamics.grains().velocity[1], Vec3::Zero());
    }
}

/// A paddle that turns by a tenth of a radian a step throws a grain on: overlap stays that of the path's curvature.
TEST(MovingWall, aPaddleTurnsFast)
{
    Scene scene(3, 0.0, 0.0);
    scene.g = Vec3::Zero();
    const int paddle = scene.walls.addPatch("paddle", 1);
    scene.walls.addTriangles(paddle, {{Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(1, 0, 1)}, {Vec3(0, 0, -1), Vec3(1, 0, 1), Vec3(0, 0, 1)}});
    const double omega = 0.1/deltaT;
    scene.walls.setMotion(paddle, nscd::rotation(Vec3::Zero(), Vec3::UnitZ(), omega));
    scene.addGrain(Vec3(0.3, 0.4, 0), radius);
    auto dynamics = scene.build();
    double worst = 0;
    bool wasHit = false;
    for (int k = 0; k < 25; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        const nscd::WallProximity a = nscd::nearestPoint(dynamics.walls(), 0, dynamics.grains().position[0]);
        const nscd::WallProximity b = nscd::nearestPoint(dynamics.walls(), 1, dynamics.grains().position[0]);
        worst = std::max(worst, radius - std::min(a.distance, b.distance));
        wasHit = wasHit || report.solve.contacts > 0;
        // It stays in front of the paddle: on its left.
        const Vec3 front = dynamics.walls().patches[paddle].pose.linear()*Vec3::UnitY();
        if (dynamics.grains().position[0].norm() < 1) { ASSERT_GT(front.dot(dynamics.grains().position[0]), 0); }
    }
    EXPECT_TRUE(wasHit);
    EXPECT_LT(worst, 5e-4*2*radius);
}

/// One list serves many steps of a slow wall, and gives what lists made every step give.
TEST(MovingWall, listsAreReusedAndMissNothing)
{
    const auto scene = [](double skin, nscd::ContactSettings& settings)
    {
        Scene s = heap(3, 4, 3, 0.01, 0.7, 0.4);
        const int lid = s.walls.addPatch("lid", 1);
        s.walls.addPlane(lid, Vec3(0, 0, 0.075), -Vec3::UnitZ());
        s.walls.setMotion(lid, nscd::translation(Vec3(0, 0, -0.08)));
        settings.skin = skin;
        settings.tolerance = settings.displacementTolerance = 1e-8;
        settings.maxSweeps = 20000;
        return s;
    };
    nscd::ContactSettings withSkin, without;
    const Scene a = scene(0.2, withSkin), b = scene(0.0, without);
    auto reused = a.build(withSkin), renewed = b.build(without);
    int lists = 0;
    double worst = 0, force = 0;
    for (int k = 0; k < 400; ++k)
    {
        lists += step(reused, a.g, deltaT).listRebuilt;
        worst = std::max(worst, step(renewed, b.g, deltaT).overlapMax);
        force = std::max(force, reused.wallForce().back().norm());
    }
    EXPECT_GT(force, 0);
    EXPECT_LT(lists, 300);
    EXPECT_LT(worst, 5e-4);
    EXPECT_NEAR((nscd::massCenter(reused.grains()) - nscd::massCenter(renewed.grains())).norm(), 0, 5e-4);
}

TEST(MovingWall, restartsToTheBitFromTimeAlone)
{
    Scene scene = heap(3, 4, 4, 0.01, 0.7, 0.4);
    const int paddle = scene.walls.addPatch("paddle", 1);
    scene.walls.addTriangles(paddle, {{Vec3(0.02, 0.02, 0.03), Vec3(0.06, 0.02, 0.03), Vec3(0.06, 0.06, 0.03)}});
    scene.walls.setMotion(paddle, nscd::rotation(Vec3(0.04, 0.04, 0), Vec3::UnitZ(), 5.0));
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 60; ++k) step(dynamics, scene.g, deltaT);
    expectSameAfterRestart(dynamics, scene, deltaT, 40);
    EXPECT_GT(dynamics.wallForce()[paddle].norm(), 0);
}

TEST(MovingWall, refusesWhatIsNoMotion)
{
    Scene scene = onFloor(0.3);
    scene.walls.setMotion(0, [](double) { nscd::WallPose p = nscd::WallPose::Identity(); p.linear() *= 1.1; return p; });
    EXPECT_THROW(scene.build(), std::invalid_argument);
    scene.walls.setMotion(0, [](double t) { nscd::WallPose p = nscd::WallPose::Identity(); p.translation()[2] = 1/(0.002 - t) > 600 ? NAN : 0; return p; });
    auto dynamics = scene.build();
    EXPECT_THROW(for (int k = 0; k < 3; ++k) step(dynamics, scene.g, deltaT), std::invalid_argument);
    EXPECT_THROW(dynamics.setTime(NAN), std::invalid_argument);
}
