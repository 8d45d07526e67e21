// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cohesion: what hangs, what comes off at which force, what slides, and that nothing is gained by it.
#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/lawScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

/// Grains one below the other, the uppermost held.
Scene chain(int links, double cohesion)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, cohesivePair(0.3, 0.0, cohesion));
    for (int i = 0; i <= links; ++i) scene.addGrain(Vec3(0, 0, -2.0*radius*i), radius);
    scene.grains.isFixed[0] = 1;
    return scene;
}

double weightOfOne() { return chain(0, 0.0).grains.mass[0]*gravity; }

/// The contact between two grains, with its impulse on the one of higher index; zeros if they do not touch.
nscd::LoadedContact contactOf(const nscd::GrainDynamics& dynamics, int i, int j)
{
    for (nscd::LoadedContact c : dynamics.contacts())
    {
        if (std::minmax(c.a, c.b) != std::minmax(i, j)) continue;
        if (c.a < c.b) c.impulse *= -1.0;
        return c;
    }
    nscd::LoadedContact none{};
    none.impulse.setZero();
    return none;
}

double distance(const nscd::Grains& grains, int i, int j) { return (grains.position[i] - grains.position[j]).norm(); }

} // namespace

TEST(Cohesion, aChainHangsIfEachLinkBearsWhatIsBelow)
{
    const double weight = weightOfOne();
    const Scene scene = chain(5, 5.001*weight);
    auto dynamics = scene.build();
    for (int k = 0; k < 100; ++k) ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
    for (int i = 1; i <= 5; ++i)
    {
        EXPECT_LT((dynamics.grains().position[i] - scene.grains.position[i]).norm(), 1e-10*radius);
        // The link above grain i pulls it up with the weight of all from i on; forces on grains cancel their weight.
        EXPECT_NEAR(contactOf(dynamics, i - 1, i).impulse[2], (6 - i)*weight*deltaT, 1e-9*weight*deltaT);
        EXPECT_NEAR(dynamics.contactForce()[i][2], weight, 1e-9*weight);
    }
    EXPECT_NEAR(dynamics.contactForce()[0][2], -5.0*weight, 1e-9*weight);
}

TEST(Cohesion, aChainBreaksAtTheLinkThatBearsTooMuch)
{
    // All alike: the uppermost, and the rest falls as one. One weak link, of glue for grains 3 and 4: there.
    const double weight = weightOfOne();
    Scene uniform = chain(5, 4.999*weight);
    auto whole = uniform.build();
    for (int k = 0; k < 60; ++k) step(whole, uniform.g, deltaT);
    EXPECT_GT(distance(whole.grains(), 0, 1), 2.0*radius + 1e-4*radius);
    for (int i = 1; i < 5; ++i) EXPECT_NEAR(distance(whole.grains(), i, i + 1), 2.0*radius, 1e-6*radius);

    Scene weak = chain(5, 10.0*weight);
    const int glue = weak.materials.add("glue");
    nscd::ContactPair pair{0.3, 0.0};
    pair.cohesion = 10.0*weight;
    weak.materials.setPair(glue, 0, pair);
    pair.cohesion = 1.999*weight;
    weak.materials.setPair(glue, glue, pair);
    weak.grains.material[3] = weak.grains.material[4] = glue;
    auto broken = weak.build();
    for (int k = 0; k < 60; ++k) step(broken, weak.g, deltaT);
    EXPECT_GT(distance(broken.grains(), 3, 4), 2.0*radius + 1e-4*radius);
    for (int i : {0, 1, 2, 4}) EXPECT_NEAR(distance(broken.grains(), i, i + 1), 2.0*radius, 1e-6*radius);
    EXPECT_NEAR(broken.contactForce()[0][2], -3.0*weight, 1e-9*weight);
}

TEST(Cohesion, aDrivenGrainPullsAnotherOffAtTheForceGiven)
{
    // The upper grain is driven up ever faster; the lower one follows until weight and inertia exceed the cohesion.
    const double weight = weightOfOne(), cohesion = 3.0*weight, jerk = 400.0;
    Scene scene = chain(1, cohesion);
    auto dynamics = scene.build();
    double largest = 0.0;
    int last = 0;
    for (int k = 1; k <= 100; ++k)
    {
        const double time = k*deltaT;
        dynamics.drive(0, Vec3(0, 0, 0.5*jerk*time*time), Vec3::Zero());
        step(dynamics, scene.g, deltaT);
        const double pull = -dynamics.contactForce()[0][2];
        largest = std::max(largest, pull);
        if (pull > 0.0) last = k;
        // (v_k - v_{k-1})/dt = jerk (k - 1/2) dt, as long as it holds.
        const double needed = weight*(1.0 + jerk*(k - 0.5)*deltaT/gravity);
        if (needed < cohesion)
        {
            EXPECT_NEAR(pull, needed, 1e-9*weight) << k;
        }
    }
    EXPECT_NEAR(largest, cohesion, 1e-9*cohesion);
    // The step whose need exceeds the cohesion, and those in which the gap is still within the dead band: none at this jerk.
    const int expected = static_cast<int>(std::ceil(2.0*gravity/(jerk*deltaT) + 0.5));
    EXPECT_GE(last, expected);
    EXPECT_LE(last, expected + 2);
}

TEST(Cohesion, frictionIsThatOfWeightAndCohesion)
{
    // A sphere that slides is slowed down by mu (m g + c), while the floor bears its weight alone.
    const double weight = weightOfOne(), mu = 0.4, cohesion = 2.5*weight;
    Scene scene(3, 0.0, 0.0);
    setAll(scene, cohesivePair(mu, 0.0, cohesion));
    scene.addGrain(Vec3(0, 0, radius), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.grains.velocity[0] = Vec3(2.0, 0, 0);
    auto dynamics = scene.build();
    for (int k = 0; k < 20; ++k)
    {
        step(dynamics, scene.g, deltaT);
        EXPECT_NEAR(dynamics.contactForce()[0][0], -mu*(weight + cohesion), 1e-9*weight);
        EXPECT_NEAR(dynamics.contactForce()[0][2], weight, 1e-9*weight);
        EXPECT_NEAR(dynamics.wallForce()[0][2], -weight, 1e-9*weight);
        EXPECT_NEAR(dynamics.contacts()[0].attraction[2], -cohesion*deltaT, 1e-12*weight);
    }
}

TEST(Cohesion, aGrainHangsFromACeilingUnderLoad)
{
    for (double share : {0.999, 1.001})
    {
        Scene scene(2, 0.0, 0.0);
        scene.addGrain(Vec3(0, 0, -radius), radius);
        setAll(scene, cohesivePair(0.0, 0.0, share*scene.grains.mass[0]*gravity));
        scene.addPlane(Vec3::Zero(), -Vec3::UnitZ());
        auto dynamics = scene.build();
        for (int k = 0; k < 300; ++k) step(dynamics, scene.g, deltaT);
        const double height = dynamics.grains().position[0][2];
        EXPECT_TRUE(share > 1.0 ? std::abs(height + radius) < 1e-12 : height < -1.005*radius) << share << ": " << height;
    }
}

TEST(Cohesion, predictionsFeelIt)
{
    const double weight = weightOfOne();
    const Scene scene = chain(3, 5.0*weight);
    auto dynamics = scene.build();
    for (int k = 0; k < 5; ++k) step(dynamics, scene.g, deltaT);
    dynamics.beginStep(deltaT);
    const nscd::ExternalForces external = scenes::weight(dynamics.grains(), scene.g, deltaT);
    const nscd::Prediction prediction = dynamics.predict(external);
    EXPECT_NEAR(prediction.contactForce[1][2], weight, 1e-9*weight);
    EXPECT_LT(prediction.velocity[3].norm(), 1e-12);
    nscd::ExternalForces more = external;
    for (Vec3& f : more.force) f *= 2.0;
    EXPECT_GT(dynamics.tryForces(more).velocity[3].norm(), 1e-3);
    dynamics.advance(external);
    EXPECT_NEAR(dynamics.contactForce()[0][2], -3.0*weight, 1e-9*weight);
}

TEST(Cohesion, theQueueSolvesItToo)
{
    const double weight = weightOfOne();
    nscd::ContactSettings settings = tight();
    settings.solver = "queue";
    const Scene scene = chain(4, 6.0*weight);
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 20; ++k) EXPECT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
    EXPECT_NEAR(dynamics.contactForce()[0][2], -4.0*weight, 1e-8*weight);
}

/// Below a grain that is held, a dumbbell that stands on end and one that lies, which is pulled at one of its ends.
TEST(Cohesion, clumpsHangFromOneMember)
{
    for (double share : {0.999, 1.001})
    {
        Scene scene(3, 0.0, 0.0);
        scene.addGrain(Vec3::Zero(), radius);
        scene.grains.isFixed[0] = 1;
        addClump(scene, addShape(scene, dumbbell()), Vec3(0, 0, -3.0*radius), Quaternion(std::sqrt(0.5), 0, std::sqrt(0.5), 0));
        const double weight = scene.grains.clumps.shapeOf(0).mass*gravity;
        setAll(scene, cohesivePair(0.3, 0.0, share*weight));
        auto dynamics = scene.build();
        for (int k = 0; k < 100; ++k) ASSERT_TRUE(step(dynamics, scene.g, deltaT).solve.converged);
        const double height = dynamics.grains().clumps.position[0][2] + 3.0*radius;
        EXPECT_TRUE(share > 1.0 ? std::abs(height) < 1e-10*radius : height < -1e-3*radius) << share << ": " << height;
        const double carried = share > 1.0 ? weight : 0.0;
        EXPECT_NEAR(dynamics.contactForce()[0][2], -carried, 1e-9*weight);
    }
}

TEST(Cohesion, anAttractionAcrossAGapTurnsAClump)
{
    Scene scene(3, 0.0, 0.0);
    scene.addGrain(Vec3(radius, 0, 2.1*radius), radius);
    scene.grains.isFixed[0] = 1;
    addClump(scene, addShape(scene, dumbbell()), Vec3::Zero());
    const double mass = scene.grains.clumps.shapeOf(0).mass, force = 0.5*mass*gravity;
    setAll(scene, cohesivePair(0.3, 0.0, force, 0.2*radius));
    auto dynamics = scene.build();
    step(dynamics, Vec3::Zero(), deltaT);
    const nscd::Clumps& clumps = dynamics.grains().clumps;
    EXPECT_LT((clumps.velocity[0] - Vec3(0, 0, deltaT*force/mass)).norm(), 1e-12*gravity*deltaT);
    EXPECT_LT((clumps.angularMomentum[0] - Vec3(0, -radius*deltaT*force, 0)).norm(), 1e-12*radius*deltaT*force);
    EXPECT_NEAR(dynamics.contactForce()[0][2], -force, 1e-12*force);
}

/// A clump of one ball slides, bounces and sticks as a sphere does.
TEST(Cohesion, isThatOfASphereForAClumpOfOneBall)
{
    Scene sphere(3, 0.0, 0.0), clump(3, 0.0, 0.0);
    const Vec3 start(0, 0, 1.2*radius), velocity(0.5, 0, 0);
    for (Scene* scene : {&sphere, &clump}) scene->addPlane(Vec3::Zero(), Vec3::UnitZ());
    sphere.addGrain(start, radius);
    sphere.grains.velocity[0] = velocity;
    addClump(clump, addShape(clump, {{Vec3::Zero(), radius}}), start, Quaternion::Identity(), velocity);
    for (Scene* scene : {&sphere, &clump}) setAll(*scene, cohesivePair(0.3, 0.4, 2.0*weightOfOne()));
    auto one = sphere.build(), other = clump.build();
    for (int k = 0; k < 100; ++k)
    {
        step(one, sphere.g, deltaT);
        step(other, clump.g, deltaT);
        ASSERT_LT((one.grains().velocity[0] - other.grains().velocity[0]).norm(), 1e-11) << k;
        ASSERT_LT((one.grains().omega[0] - other.grains().omega[0]).norm(), 1e-9) << k;
    }
    EXPECT_LT(other.grains().velocity[0][0], 0.4);
}

TEST(Cohesion, refusesNegativeAndEndless)
{
    Scene scene(3, 0.0, 0.0);
    EXPECT_THROW(setAll(scene, cohesivePair(0.0, 0.0, -1.0)), std::invalid_argument);
    EXPECT_THROW(setAll(scene, cohesivePair(0.0, 0.0, 1.0, -1e-3)), std::invalid_argument);
    EXPECT_THROW(setAll(scene, cohesivePair(0.0, 0.0, INFINITY)), std::invalid_argument);
}
