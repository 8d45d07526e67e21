// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Where some grains sleep and others do not: forces balance, nobody sinks, and what moves does as it would among grains that are awake.
#include "unit/nscd/scenes/lawScenes.hpp"
#include "unit/nscd/scenes/restarts.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// Fine enough for forces of a step in which others move to be steady.
nscd::ContactSettings settings(bool sleep)
{
    nscd::ContactSettings s;
    s.tolerance = 1e-5;
    s.sleep = sleep;
    return s;
}

constexpr int side = 6;

/// A square pyramid of spheres between four walls; the last grain is the top.
struct Pile
{
    Scene scene{3, 0.4, 0.0};

    explicit Pile(const nscd::ContactPair& pair = {0.4, 0.0})
    {
        setAll(scene, pair);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0)})
        {
            scene.addPlane(Vec3::Zero(), axis);
            scene.addPlane(2*radius*side*axis, -axis);
        }
        for (int layer = 0; layer < side; ++layer)
        for (int j = layer; j < side; ++j)
        for (int i = layer; i < side; ++i)
        {
            scene.addGrain(radius*Vec3(2*i + 1 - layer, 2*j + 1 - layer, 1 + layer*std::sqrt(2.0)), radius);
        }
    }

    int top() const { return side*(side + 1)*(2*side + 1)/6 - 1; }
    double weight() const
    {
        double sum = 0.0;
        for (double m : scene.grains.mass) sum += m*gravity;
        return sum;
    }
};

/// A step in which a grain is pushed to and fro, too little to move it, but so that it never is at rest.
nscd::StepReport stepPushed(nscd::GrainDynamics& dynamics, const Vec3& g, int grain, int k)
{
    nscd::ExternalForces forces = weight(dynamics.grains(), g, deltaT);
    forces.force[grain][0] += 0.0015*std::sin(0.37*k)*g.norm()*dynamics.grains().mass[grain];
    dynamics.beginStep(deltaT);
    return dynamics.advance(forces);
}

double largestMove(const nscd::Grains& a, const nscd::Grains& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position[i] - b.position[i]).norm());
    return largest;
}

/// What grains and walls get of contacts adds up to nothing, and the walls carry the weight.
void expectBalance(const nscd::GrainDynamics& dynamics, double weight)
{
    Vec3 onGrains = Vec3::Zero(), onWalls = Vec3::Zero();
    for (const Vec3& force : dynamics.contactForce()) onGrains += force;
    for (const Vec3& force : dynamics.wallForce()) onWalls += force;
    EXPECT_LT((onGrains + onWalls).norm(), 1e-10*weight);
    EXPECT_NEAR(-onWalls[2], weight, 1e-3*weight);
}

void expectNeighborhoodAwake(const nscd::ContactPair& pair)
{
    const Pile bed(pair);
    auto sleeping = bed.scene.build(settings(true)), awake = bed.scene.build(settings(false));
    const std::size_t n = bed.scene.grains.size();
    std::size_t most = 0, least = n;
    for (int k = 0; k < 400; ++k)
    {
        const std::size_t asleep = stepPushed(sleeping, bed.scene.g, bed.top(), k).asleep;
        stepPushed(awake, bed.scene.g, bed.top(), k);
        if (k < 200) continue;
        most = std::max(most, asleep);
        least = std::min(least, asleep);
    }
    EXPECT_LT(most, n);
    EXPECT_GT(most, n*3/4);
    EXPECT_GT(least, 0u);
    expectBalance(sleeping, bed.weight());
    EXPECT_LT(largestMove(sleeping.grains(), awake.grains()), 1e-4*radius);
    EXPECT_LT(largestMove(sleeping.grains(), bed.scene.grains), 1e-2*radius);
}

} // namespace

TEST(PartialSleep, aRestlessGrainKeepsThoseAroundItAwake) { expectNeighborhoodAwake({0.4, 0.0}); }
TEST(PartialSleep, alsoWithRollingFriction) { expectNeighborhoodAwake(rollingPair(0.4, 0.05, 0.02)); }
TEST(PartialSleep, alsoWithCohesion) { expectNeighborhoodAwake(cohesivePair(0.4, 0.0, 1e-3)); }
TEST(PartialSleep, alsoWithRestitution) { expectNeighborhoodAwake({0.4, 0.5}); }

TEST(PartialSleep, aGrainThatFallsOnSleepersMovesThemAsIfTheyHadNotSlept)
{
    Pile bed;
    const std::size_t n = bed.scene.grains.size();
    const Vec3 top = bed.scene.grains.position[bed.top()];
    bed.scene.addGrain(top + Vec3(0.3*radius, 0.1*radius, 0.12), radius);
    auto sleeping = bed.scene.build(settings(true)), awake = bed.scene.build(settings(false));
    std::size_t most = 0, atBlow = n;
    int sinceBlow = 0;
    for (int k = 0; k < 400 && sinceBlow < 30; ++k)
    {
        const nscd::StepReport report = step(sleeping, bed.scene.g, deltaT);
        step(awake, bed.scene.g, deltaT);
        EXPECT_LT(report.overlapMax, 2*nscd::ContactSettings().overlapTolerance);
        if (sinceBlow == 0) most = std::max(most, report.asleep);
        if (sleeping.contactForce()[n] != Vec3::Zero() && sinceBlow == 0)
        {
            sinceBlow = 1;
            atBlow = report.asleep;
        }
        else if (sinceBlow > 0) ++sinceBlow;
        ASSERT_LT(largestMove(sleeping.grains(), awake.grains()), 2e-3*radius) << "step " << k << ", after the impact " << sinceBlow;
    }
    EXPECT_EQ(sinceBlow, 30);
    EXPECT_GT(most, n*9/10);
    EXPECT_LT(atBlow, n/2);
    EXPECT_GT(largestMove(sleeping.grains(), bed.scene.grains), 0.1);
}

/// Rolls over sleeping grains that lie in a row, held by nothing but their weight.
TEST(PartialSleep, aRollerOnASleepingBedKeepsItsWayAndSinksNowhere)
{
    Scene scene(3, 0.4, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int j = 0; j < 2; ++j)
    {
        for (int i = 0; i < 12; ++i) scene.addGrain(Vec3(2*radius*i, 2*radius*j, radius), radius);
    }
    // In the groove between two rows, moving along it: up and down from hollow to hollow.
    const int roller = static_cast<int>(scene.grains.size());
    scene.addGrain(Vec3(3*radius, radius, radius + std::sqrt(2.0)*radius), radius, 100.0);
    scene.addPlane(Vec3(0, -radius, 0), Vec3::UnitY());
    scene.addPlane(Vec3(0, 3*radius, 0), -Vec3::UnitY());
    scene.addPlane(Vec3(-radius, 0, 0), Vec3::UnitX());
    scene.addPlane(Vec3(23*radius, 0, 0), -Vec3::UnitX());
    auto sleeping = scene.build(settings(true)), awake = scene.build(settings(false));
    for (int k = 0; k < 150; ++k)
    {
        for (nscd::GrainDynamics* dynamics : {&sleeping, &awake}) step(*dynamics, scene.g, deltaT);
    }
    std::size_t least = scene.grains.size(), most = 0;
    for (int k = 0; k < 150; ++k)
    {
        for (nscd::GrainDynamics* dynamics : {&sleeping, &awake})
        {
            nscd::ExternalForces forces = weight(dynamics->grains(), scene.g, deltaT);
            forces.force[roller][0] += 1.5*gravity*scene.grains.mass[roller];
            dynamics->beginStep(deltaT);
            const nscd::StepReport report = dynamics->advance(forces);
            if (dynamics != &sleeping) continue;
            least = std::min(least, report.asleep);
            most = std::max(most, report.asleep);
        }
        ASSERT_LT(largestMove(sleeping.grains(), awake.grains()), 1e-2*radius) << "step " << k;
    }
    EXPECT_GT(sleeping.grains().position[roller][0], 6*radius);
    EXPECT_GT(sleeping.grains().position[roller][2], 2*radius);
    EXPECT_GT(most, 0u);
}

/// A ball that bounces on a pile: its impacts reach the floor's force, whatever sleeps.
TEST(PartialSleep, impactsOnSleepingGrainsReachTheWalls)
{
    Pile bed({0.4, 0.6});
    bed.scene.addGrain(bed.scene.grains.position[bed.top()] + Vec3(0, 0, 0.08), radius);
    auto dynamics = bed.scene.build(settings(true));
    double impulse = 0.0;
    std::size_t most = 0;
    const int steps = 400;
    for (int k = 0; k < steps; ++k)
    {
        most = std::max(most, step(dynamics, bed.scene.g, deltaT).asleep);
        for (const Vec3& force : dynamics.wallForce()) impulse -= deltaT*force[2];
    }
    double momentum = 0.0;
    for (std::size_t i = 0; i < bed.scene.grains.size(); ++i) momentum += dynamics.grains().mass[i]*dynamics.grains().velocity[i][2];
    EXPECT_NEAR(impulse, steps*deltaT*bed.weight() + momentum, 1e-3*steps*deltaT*bed.weight());
    EXPECT_GT(most, bed.scene.grains.size()/2);
}

TEST(PartialSleep, aRestartGoesOnToTheBit)
{
    const Pile bed;
    auto dynamics = bed.scene.build(settings(true));
    std::size_t asleep = 0;
    for (int k = 0; k < 66; ++k) asleep = stepPushed(dynamics, bed.scene.g, bed.top(), k).asleep;
    EXPECT_GT(asleep, bed.scene.grains.size()/2);
    EXPECT_LT(asleep, bed.scene.grains.size());
    const Stored stored(dynamics);
    auto later = at(stored, bed.scene).build(settings(true));
    later.setTime(stored.time);
    later.restore(stored.impulses, stored.deltaT);
    for (int k = 66; k < 200; ++k)
    {
        asleep = stepPushed(dynamics, bed.scene.g, bed.top(), k).asleep;
        ASSERT_EQ(stepPushed(later, bed.scene.g, bed.top(), k).asleep, asleep) << k;
        ASSERT_EQ(hash(later.grains()), hash(dynamics.grains())) << k;
        ASSERT_EQ(later.wallForce(), dynamics.wallForce()) << k;
        ASSERT_EQ(later.contactForce(), dynamics.contactForce()) << k;
    }
    EXPECT_GT(asleep, 0u);
}

TEST(PartialSleep, twoRunsAreTheSameToTheBit)
{
    const Pile bed;
    auto one = bed.scene.build(settings(true)), other = bed.scene.build(settings(true));
    for (int k = 0; k < 250; ++k)
    {
        const std::size_t asleep = stepPushed(one, bed.scene.g, bed.top(), k).asleep;
        ASSERT_EQ(asleep, stepPushed(other, bed.scene.g, bed.top(), k).asleep);
        ASSERT_EQ(hash(one.grains()), hash(other.grains()));
    }
}
