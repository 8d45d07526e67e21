// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Free clumps: Euler's equations, one ball against a sphere, periodic sides, restarts, and what is refused.
#include "unit/nscd/scenes/clumpScenes.hpp"

#include "nscd/scene/exchange.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"
#include "unit/nscd/scenes/sceneHash.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>

using namespace scenes;

namespace
{

/// An asymmetric clump that turns about the middle one of its principal axes, nearly: Dzhanibekov's body.
Scene spinningBody()
{
    Scene scene(3, 0.3, 0.0);
    const Eigen::Matrix3d inertia = 1e-6*Vec3(1.0, 2.0, 2.8).asDiagonal();
    scene.grains.clumps.shapes.push_back(nscd::makeClumpShape(tetrapod(), 0.05, Vec3::Zero(), inertia, scene.grains.shape));
    addClump(scene, 0, Vec3::Zero(), Quaternion(1, 0.2, 0.1, 0).normalized(), Vec3(1, 2, 3), 5.0*Vec3(0.01, 1.0, 0.3));
    return scene;
}

nscd::Clumps runFree(const Scene& scene, double deltaT, int steps)
{
    auto dynamics = scene.build();
    for (int k = 0; k < steps; ++k) step(dynamics, Vec3::Zero(), deltaT);
    return dynamics.grains().clumps;
}

/// Orientation after `time` by the classical Runge-Kutta method on dq/dt = omega q/2 with L held.
Quaternion integrated(const nscd::Clumps& start, double time, int steps)
{
    const Eigen::Matrix3d inverse = start.shapeOf(0).inertia.inverse();
    const auto rate = [&](const Eigen::Vector4d& x)
    {
        const Quaternion q(x);
        const Vec3 omega = q.normalized()*Vec3(inverse*(q.normalized().conjugate()*start.angularMomentum[0]));
        return Eigen::Vector4d((Quaternion(0, 0.5*omega[0], 0.5*omega[1], 0.5*omega[2])*q).coeffs());
    };
    Eigen::Vector4d x = start.orientation[0].coeffs();
    const double h = time/steps;
    for (int k = 0; k < steps; ++k)
    {
        const Eigen::Vector4d k1 = rate(x), k2 = rate(x + 0.5*h*k1), k3 = rate(x + 0.5*h*k2), k4 = rate(x + h*k3);
        x += h/6.0*(k1 + 2.0*k2 + 2.0*k3 + k4);
    }
    return Quaternion(x).normalized();
}

} // namespace

TEST(ClumpMotion, freeSpinKeepsMomentumAndEnergy)
{
    const Scene scene = spinningBody();
    const nscd::Clumps& start = scene.grains.clumps;
    for (double deltaT : {0.2, 0.02})  // 1 and 0.1 radians a step
    {
        const nscd::Clumps end = runFree(scene, deltaT, 500);
        EXPECT_LT((end.angularMomentum[0] - start.angularMomentum[0]).norm(), 1e-14*start.angularMomentum[0].norm());
        EXPECT_NEAR(nscd::kineticEnergy(end, 0), nscd::kineticEnergy(start, 0), 1e-12*nscd::kineticEnergy(start, 0)) << deltaT;
        EXPECT_LT((end.velocity[0] - Vec3(1, 2, 3)).norm(), 1e-15);
    }
}

TEST(ClumpMotion, orientationConvergesWithSecondOrderThroughTheFlip)
{
    const Scene scene = spinningBody();
    const nscd::Clumps& start = scene.grains.clumps;
    const double time = 8.0;
    const Quaternion exact = integrated(start, time, 40000);
    double errors[2];
    for (int k = 0; k < 2; ++k)
    {
        const int steps = 800 << k;
        errors[k] = runFree(scene, time/steps, steps).orientation[0].angularDistance(exact);
    }
    EXPECT_LT(errors[1], 0.02);
    EXPECT_NEAR(std::log2(errors[0]/errors[1]), 2.0, 0.1) << errors[0] << " " << errors[1];
    // It does flip: the middle axis has turned over against L.
    const Vec3 middleBefore = start.orientation[0]*Vec3::UnitY();
    const Vec3 l = start.angularMomentum[0].normalized();
    double lowest = 1.0;
    auto dynamics = scene.build();
    for (int k = 0; k < 800; ++k)
    {
        step(dynamics, Vec3::Zero(), time/800);
        lowest = std::min(lowest, l.dot(dynamics.grains().clumps.orientation[0]*Vec3::UnitY()));
    }
    EXPECT_GT(l.dot(middleBefore), 0.8);
    EXPECT_LT(lowest, -0.8);
}

/// A clump of one ball does what a sphere does: it lands, bounces, slides, rolls.
TEST(ClumpMotion, oneBallIsASphere)
{
    for (int dimensions : {3, 2})
    {
        Scene sphere(dimensions, 0.3, 0.4), clump(dimensions, 0.3, 0.4);
        for (Scene* scene : {&sphere, &clump}) scene->addPlane(Vec3::Zero(), Vec3::UnitZ());
        const Vec3 start(0, 0, 1.5*memberRadius), velocity(0.5, 0, 0), omega(0, -30, 0);
        sphere.addGrain(start, memberRadius);
        sphere.grains.velocity[0] = velocity;
        sphere.grains.omega[0] = omega;
        addClump(clump, addShape(clump, {{Vec3(0, 0, 0), memberRadius}}), start, Quaternion::Identity(), velocity, omega);
        auto one = sphere.build(), other = clump.build();
        for (int k = 0; k < 300; ++k)
        {
            step(one, sphere.g, 1e-3);
            step(other, clump.g, 1e-3);
        }
        EXPECT_LT((one.grains().position[0] - other.grains().position[0]).norm(), 1e-13);
        EXPECT_LT((one.grains().velocity[0] - other.grains().velocity[0]).norm(), 1e-11);
        EXPECT_LT((one.grains().omega[0] - other.grains().omega[0]).norm(), 1e-9);
        EXPECT_LT(one.grains().orientation[0].angularDistance(other.grains().orientation[0]), 1e-9);
        EXPECT_GT(one.grains().position[0][0], 0.05);
    }
}

/// A clump of one ball under forces and drag that are implicit in its velocity and spin moves as a sphere does, falling and lying.
TEST(ClumpMotion, dragOnOneBallIsThatOnASphere)
{
    Scene sphere(3, 0.3, 0.0), clump(3, 0.3, 0.0);
    for (Scene* scene : {&sphere, &clump}) scene->addPlane(Vec3::Zero(), Vec3::UnitZ());
    sphere.addGrain(Vec3(0, 0, 0.015), memberRadius);
    sphere.grains.velocity[0] = Vec3(0.4, 0, -1);
    sphere.grains.omega[0] = Vec3(0, 30, 5);
    addClump(clump, addShape(clump, {{Vec3(0, 0, 0), memberRadius}}), Vec3(0, 0, 0.015), Quaternion::Identity(), Vec3(0.4, 0, -1), Vec3(0, 30, 5));
    auto one = sphere.build(), other = clump.build();
    const double mass = one.grains().mass[0], inertia = 0.4*mass*memberRadius*memberRadius, deltaT = 1e-3;
    nscd::ExternalForces forces;
    forces.force = {mass*Vec3(0.2, 0, -9.81)};
    forces.torque = {inertia*Vec3(3, -2, 7)};
    forces.implicitDrag = {20*mass};
    forces.implicitSpinDrag = {70*inertia};
    for (int k = 0; k < 60; ++k)
    {
        for (auto* dynamics : {&one, &other})
        {
            dynamics->beginStep(deltaT);
            dynamics->advance(forces);
        }
        ASSERT_LT((one.grains().velocity[0] - other.grains().velocity[0]).norm(), 1e-9) << k;
        ASSERT_LT((one.grains().omega[0] - other.grains().omega[0]).norm(), 1e-7) << k;
    }
    EXPECT_GT(one.contactForce()[0][2], 0.0);
}

/// Drag and forces on any of the members are those on the clump: dv m = dt (f - gamma v'), and its spin decays as J' = -C omega says.
TEST(ClumpMotion, dragOnMembersAddsUp)
{
    Scene scene(3, 0.0, 0.0);
    addClump(scene, addShape(scene, dumbbell()), Vec3::Zero(), Quaternion::Identity(), Vec3(1, 2, 3), Vec3(0, 0, 10));
    const double mass = scene.grains.clumps.shapeOf(0).mass, inertia = scene.grains.clumps.shapeOf(0).inertia(2, 2), deltaT = 1e-3;
    auto dynamics = scene.build();
    nscd::ExternalForces forces;
    forces.force = {mass*Vec3(5, 0, 0), mass*Vec3(0, 7, 0)};
    forces.implicitDrag = {30*mass, 70*mass};
    forces.implicitSpinDrag = {0.0, 50*inertia};
    dynamics.beginStep(deltaT);
    const nscd::Prediction predicted = dynamics.predict(forces);
    dynamics.advance(forces);
    const Vec3 expected = (Vec3(1, 2, 3) + deltaT*Vec3(5, 7, 0))/(1 + 100*deltaT);
    EXPECT_LT((dynamics.grains().clumps.velocity[0] - expected).norm(), 1e-14);
    for (const Vec3& velocity : predicted.velocity) EXPECT_LT((velocity - expected).norm(), 1e-14);
    EXPECT_NEAR(dynamics.grains().clumps.angularMomentum[0][2], inertia*10/(1 + 50*deltaT), 1e-13*inertia);
    EXPECT_NEAR(dynamics.grains().omega[0][2], 10/(1 + 50*deltaT), 1e-12);
}

/// Two dumbbells that meet across a periodic side do what they do in the middle of the box.
TEST(ClumpMotion, periodicSidesChangeNothing)
{
    nscd::Grains ends[2];
    for (int k = 0; k < 2; ++k)
    {
        Scene scene(3, 0.3, 0.5);
        scene.box.length = Vec3(0.2, 0, 0);
        const double shift = k*0.1;
        const int shape = addShape(scene, dumbbell());
        addClump(scene, shape, Vec3(0.07 + shift, 0, 0), Quaternion::Identity(), Vec3(0.5, 0, 0));
        addClump(scene, shape, Vec3(0.12 + shift, 0.005, 0), Quaternion::Identity(), Vec3(-0.5, 0, 0));
        auto dynamics = scene.build();
        for (int s = 0; s < 100; ++s) step(dynamics, Vec3::Zero(), 1e-3);
        ends[k] = dynamics.grains();
        for (int i = 0; i < 4; ++i) EXPECT_LT(std::abs(ends[k].position[i][0] - 0.1), 0.1);
    }
    for (int c = 0; c < 2; ++c)
    {
        EXPECT_LT((ends[0].clumps.velocity[c] - ends[1].clumps.velocity[c]).norm(), 1e-9);
        EXPECT_LT(ends[0].clumps.orientation[c].angularDistance(ends[1].clumps.orientation[c]), 1e-7);
        EXPECT_GT(ends[0].clumps.angularMomentum[c].norm(), 1e-8);
    }
}

TEST(ClumpMotion, restartsToTheBit)
{
    Scene scene(3, 0.4, 0.2);
    scene.addPlane(Vec3::Zero(), Vec3(0.1, 0, 1).normalized());
    const int shape = addShape(scene, pebble());
    for (int k = 0; k < 4; ++k) addClump(scene, shape, Vec3(0.001*k, 0.002*k, 0.02 + 0.035*k), Quaternion(1, 0.3*k, 0.1, 0));
    scene.addGrain(Vec3(0.03, 0, 0.02), memberRadius);
    const std::string path = (std::filesystem::temp_directory_path() / ("nscdClumps.state" + std::to_string(::getpid()))).string();

    auto straight = scene.build();
    for (int k = 0; k < 60; ++k) step(straight, scene.g, 1e-3);
    nscd::writeCheckpoint(path, nscd::takeState(straight, 0.06, 60));
    for (int k = 0; k < 60; ++k) step(straight, scene.g, 1e-3);

    const nscd::SceneState state = nscd::readCheckpoint(path);
    std::filesystem::remove(path);
    ASSERT_EQ(state.grains.clumps.size(), 4u);
    nscd::GrainDynamics later(state.grains, scene.materials, scene.walls, scene.box, tight());
    later.restore(state.impulses, state.lastDeltaT);
    for (int k = 0; k < 60; ++k) step(later, scene.g, 1e-3);
    EXPECT_EQ(hash(straight.grains()), hash(later.grains()));
    EXPECT_EQ(hash(straight.contacts()), hash(later.contacts()));
    EXPECT_GE(straight.contacts().size(), 3u);
    for (int c = 0; c < 4; ++c) EXPECT_EQ(straight.grains().clumps.angularMomentum[c], later.grains().clumps.angularMomentum[c]);
}

TEST(ClumpMotion, whatDoesNotWorkIsRefused)
{
    const auto build = [](const auto& change, const nscd::ContactSettings& settings = tight())
    {
        Scene scene(3, 0.3, 0.0);
        addClump(scene, addShape(scene, dumbbell()), Vec3::Zero());
        change(scene);
        scene.build(settings);
    };
    const auto nothing = [](Scene&) {};
    EXPECT_NO_THROW(build(nothing));
    EXPECT_THROW(build([](Scene& s) { s.grains.position[1][0] += 1e-3; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.radius[0] *= 2; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.isFixed[0] = 1; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.clumps.firstMember[0] = 1; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.clumps.shape[0] = 7; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.clumps.velocity[0][0] = NAN; }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.grains.clumps.orientation[0] = Quaternion(2, 0, 0, 0); }), std::invalid_argument);
    EXPECT_THROW(build([](Scene& s) { s.box.length[0] = 0.07; }), std::invalid_argument);
    EXPECT_NO_THROW(build([](Scene& s) { s.materials.setPair(0, 0, {0.3, 0.0, 0.1}); }));
    EXPECT_THROW(build([](Scene& s) { s.materials.setPair(0, 0, {0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-5, 1e-3, 1e-3}); }), std::invalid_argument);
    for (const char* solver : {"NNCG", "APG", "queue", "direct"})
    {
        nscd::ContactSettings settings = tight();
        settings.solver = solver;
        EXPECT_THROW(build(nothing, settings), std::invalid_argument) << solver;
    }
    Scene scene(3, 0.3, 0.0);
    EXPECT_THROW(addClump(scene, 0, Vec3::Zero()), std::invalid_argument);
    const int shape = addShape(scene, dumbbell());
    EXPECT_THROW(addClump(scene, shape, Vec3(NAN, 0, 0)), std::invalid_argument);
    EXPECT_THROW(addClump(scene, shape, Vec3::Zero(), Quaternion(0, 0, 0, 0)), std::invalid_argument);
    addClump(scene, shape, Vec3::Zero());
    auto dynamics = scene.build();
    dynamics.beginStep(1e-3);
    nscd::ExternalForces forces;
    forces.implicitDrag = {-1.0, 0.0};
    EXPECT_THROW(dynamics.advance(forces), std::invalid_argument);
    EXPECT_THROW(dynamics.drive(0, Vec3::Zero(), Vec3::Zero()), std::invalid_argument);
}
