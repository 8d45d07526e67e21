// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cohesion: what hangs, what comes off at which force, what slides, and that nothing is gained by it.
#include "heaps.hpp"
#include "naturalMap.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 0.01, deltaT = 1e-3;

void setAll(Scene& scene, double friction, double restitution, double cohesion, double range = 0.0)
{
    nscd::ContactPair pair{friction, restitution};
    pair.cohesion = cohesion;
    pair.cohesionRange = range;
    for (int a = 0; a < 2; ++a)
    {
        for (int b = a; b < 2; ++b) scene.materials.setPair(a, b, pair);
    }
}

/// Grains one below the other, the uppermost held.
Scene chain(int links, double cohesion)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, 0.3, 0.0, cohesion);
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

double angularMomentumZ(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        sum += grains.mass[i]*(grains.position[i].cross(grains.velocity[i])[2] + 0.4*grains.radius[i]*grains.radius[i]*grains.omega[i][2]);
    }
    return sum;
}

/// Two touching grains that turn about each other as one body with angular velocity omega.
Scene turningPair(double omega, double cohesion)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, 0.5, 0.0, cohesion);
    for (int side : {-1, 1})
    {
        scene.addGrain(Vec3(side*radius, 0, 0), radius);
        scene.grains.velocity.back() = Vec3(0, side*radius*omega, 0);
        scene.grains.omega.back() = Vec3(0, 0, omega);
    }
    return scene;
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
    // Pushed sideways a grain that cannot turn (here: two side by side would) slides at mu (m g + c): a grain without spin moves
    // as v = (F/m - mu (g + c/m)) t, and what it does not reach it resists.
    const double weight = weightOfOne(), mu = 0.4, cohesion = 2.5*weight;
    Scene scene(3, 0.0, 0.0);
    setAll(scene, mu, 0.0, cohesion);
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
        setAll(scene, 0.0, 0.0, share*scene.grains.mass[0]*gravity);
        scene.addPlane(Vec3::Zero(), -Vec3::UnitZ());
        auto dynamics = scene.build();
        for (int k = 0; k < 300; ++k) step(dynamics, scene.g, deltaT);
        const double height = dynamics.grains().position[0][2];
        EXPECT_TRUE(share > 1.0 ? std::abs(height + radius) < 1e-12 : height < -1.005*radius) << share << ": " << height;
    }
}

TEST(Cohesion, aPairTurnsTogetherUpToItsCentrifugalForce)
{
    // Without friction, and driven round ever faster by a couple: it parts at m omega^2 R = c, in steps of 0.04 rad, in which straight
    // motion opens the gap by four times the dead band.
    const double mass = chain(0, 0.0).grains.mass[0], limit = 40.0, push = mass*radius*20.0;
    Scene scene = turningPair(0.0, mass*limit*limit*radius);
    setAll(scene, 0.0, 0.0, mass*limit*limit*radius);
    auto dynamics = scene.build();
    double omega = 0.0;
    for (int k = 0; k < 4000 && distance(dynamics.grains(), 0, 1) < 2.01*radius; ++k)
    {
        const Vec3 arm = (dynamics.grains().position[1] - dynamics.grains().position[0])/(2.0*radius);
        omega = arm.cross(dynamics.grains().velocity[1] - dynamics.grains().velocity[0])[2]/(2.0*radius);
        nscd::ExternalForces forces;
        forces.force = {-push*Vec3::UnitZ().cross(arm), push*Vec3::UnitZ().cross(arm)};
        forces.speedScale = push/mass*deltaT;
        dynamics.beginStep(deltaT);
        ASSERT_TRUE(dynamics.advance(forces).solve.converged);
    }
    EXPECT_GT(distance(dynamics.grains(), 0, 1), 2.01*radius);
    EXPECT_NEAR(omega, limit, 0.01*limit);
}

TEST(Cohesion, aTurningPairKeepsItsAngularMomentum)
{
    const Scene scene = turningPair(10.0, 1.0);
    auto dynamics = scene.build();
    const double before = angularMomentumZ(scene.grains), energy = nscd::kineticEnergy(scene.grains);
    for (int k = 0; k < 2000; ++k) step(dynamics, Vec3::Zero(), deltaT);
    EXPECT_NEAR(angularMomentumZ(dynamics.grains()), before, 1e-3*before);
    EXPECT_NEAR(nscd::kineticEnergy(dynamics.grains()), energy, 2e-3*energy);
    EXPECT_NEAR(distance(dynamics.grains(), 0, 1), 2.0*radius, 2e-3*radius);
}

TEST(Cohesion, aPairThatFallsStaysOne)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, 0.3, 0.0, 1e-3*weightOfOne());
    scene.addGrain(Vec3(0, 0, 1), radius);
    scene.addGrain(Vec3(2.0*radius, 0, 1), radius);
    auto dynamics = scene.build();
    for (int k = 0; k < 200; ++k) step(dynamics, scene.g, deltaT);
    EXPECT_NEAR(distance(dynamics.grains(), 0, 1), 2.0*radius, 1e-12);
    EXPECT_NEAR(dynamics.grains().velocity[0][2], -gravity*0.2, 1e-12);
    EXPECT_LT(dynamics.contactForce()[0].norm(), 1e-9*weightOfOne());
}

TEST(Cohesion, actsWithinItsRange)
{
    // Two grains at rest one tenth of a radius apart fall together with c/m each; beyond the range they do not.
    const double gap = 0.1*radius, cohesion = 0.1;
    for (double range : {0.9*gap, 1.1*gap})
    {
        Scene scene(3, 0.0, 0.0);
        setAll(scene, 0.0, 0.0, cohesion, range);
        scene.addGrain(Vec3(0, 0, 0), radius);
        scene.addGrain(Vec3(2.0*radius + gap, 0, 0), radius);
        auto dynamics = scene.build();
        const double mass = scene.grains.mass[0];
        for (int k = 0; k < 3; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_NEAR(dynamics.grains().velocity[0][0], range > gap ? 3.0*deltaT*cohesion/mass : 0.0, 1e-12);
        for (int k = 0; k < 60; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_NEAR(distance(dynamics.grains(), 0, 1), range > gap ? 2.0*radius : 2.0*radius + gap, 1e-9*radius);
    }
}

TEST(Cohesion, neverCreatesEnergy)
{
    // A gas whose grains collide, stick, turn and come off again; a pair in range holds -c (range - gap). Grains that pass each other in
    // range move straight in a force that turns: c |dx_t|^2/(2 D) a step and pair, 1e-8 J here, which nothing can build up on.
    for (double range : {0.0, 0.2*radius})
    {
        Scene scene = heap(3, 5, 5, radius, 0.7, 0.0);
        const double cohesion = 5e-3;
        setAll(scene, 0.3, range > 0.0 ? 0.7 : 0.0, cohesion, range);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (Vec3& v : scene.grains.velocity) v = 0.3*Vec3(unit(random), unit(random), unit(random));
        scene.walls = nscd::Walls();
        scene.box.length = Vec3::Constant(5*2.3*radius);
        nscd::ContactSettings settings;
        settings.tolerance = 1e-6;
        auto dynamics = scene.build(settings);
        const double start = nscd::kineticEnergy(dynamics.grains());
        double before = start, rise = 0.0;
        std::size_t bonds = 0;
        for (int k = 0; k < 300; ++k)
        {
            step(dynamics, Vec3::Zero(), deltaT);
            double energy = nscd::kineticEnergy(dynamics.grains());
            for (const auto& x : dynamics.grains().position)
            {
                for (const auto& y : dynamics.grains().position)
                {
                    if (&x <= &y) continue;
                    const std::size_t i = &x - dynamics.grains().position.data(), j = &y - dynamics.grains().position.data();
                    const double gap = scene.box.nearestImage(x - y).norm() - dynamics.grains().radius[i] - dynamics.grains().radius[j];
                    energy -= cohesion*std::max(0.0, range - gap);
                }
            }
            bonds = dynamics.contacts().size();
            if (k > 0) rise = std::max(rise, energy - before);
            before = energy;
        }
        std::printf("   range %.1e m: energy %.2e J of %.2e left, largest rise in a step %.1e, %zu contacts\n", range, before, start, rise, bonds);
        EXPECT_GT(bonds, 20u);
        EXPECT_LT(rise, range > 0.0 ? 1e-5*start : 1e-12*start);
        EXPECT_LT(before, 0.2*start);
    }
}

TEST(Cohesion, aJudgeOfItsOwnAgrees)
{
    Scene scene = heap(3, 4, 5, radius, 0.5, 0.4);
    setAll(scene, 0.4, 0.0, 2.0*weightOfOne());
    nscd::ContactSettings settings;
    settings.polishSweeps = 0;
    auto dynamics = scene.build(settings);
    double diameter = 0.0;
    for (double r : scene.grains.radius) diameter += 2.0*r/scene.grains.size();
    for (int k = 0; k < 200; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        ASSERT_TRUE(report.solve.converged) << k;
        if (report.solve.contacts < 10) continue;
        const NaturalMap map = Judge(scene, 0.4, settings.deadBand*diameter, deltaT)(before, dynamics);
        // Contacts that attract and bear nothing count for the judge alone.
        const double norm = report.solve.residualRms*std::sqrt(static_cast<double>(report.solve.contacts));
        ASSERT_NEAR(map.norm, norm, 1e-6*norm) << k;
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

TEST(Cohesion, aTrialThatClosesAGapMakesNoBond)
{
    // Within one step two grains would meet; the prediction loads their contact, and yet it does not attract before it is closed.
    Scene scene(3, 0.0, 0.0);
    setAll(scene, 0.0, 0.0, 1.0);
    scene.addGrain(Vec3(0, 0, 0), radius);
    scene.addGrain(Vec3(2.05*radius, 0, 0), radius);
    scene.grains.velocity[0] = Vec3(1.0, 0, 0);
    auto plain = scene.build(), tried = scene.build();
    step(plain, Vec3::Zero(), deltaT);
    tried.beginStep(deltaT);
    EXPECT_GT(tried.predict({}).contactForce[0].norm(), 0.0);
    tried.advance({});
    EXPECT_EQ(tried.grains().velocity[0], plain.grains().velocity[0]);
    EXPECT_EQ(tried.contacts()[0].attraction, Vec3(Vec3::Zero()));
    step(tried, Vec3::Zero(), deltaT);
    EXPECT_GT(tried.contacts()[0].attraction.norm(), 0.0);
}

TEST(Cohesion, restartsToTheBit)
{
    Scene scene = heap(3, 4, 4, radius, 0.7, 0.4);
    setAll(scene, 0.4, 0.3, 2.0*weightOfOne());
    scene.g = gravity*Vec3(0.5, 0.1, -0.86);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 100; ++k) step(dynamics, scene.g, deltaT);
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = dynamics.checkpoint(lastDeltaT);
    Scene at = scene;
    at.grains = dynamics.grains();
    auto other = at.build(nscd::ContactSettings());
    other.restore(impulses, lastDeltaT);
    for (int k = 0; k < 40; ++k)
    {
        const int sweeps = step(dynamics, scene.g, deltaT).solve.sweeps;
        ASSERT_EQ(step(other, scene.g, deltaT).solve.sweeps, sweeps);
        for (std::size_t i = 0; i < at.grains.size(); ++i) ASSERT_EQ(other.grains().position[i], dynamics.grains().position[i]);
    }
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

TEST(Cohesion, refusesNegativeAndEndless)
{
    Scene scene(3, 0.0, 0.0);
    EXPECT_THROW(setAll(scene, 0.0, 0.0, -1.0), std::invalid_argument);
    EXPECT_THROW(setAll(scene, 0.0, 0.0, 1.0, -1e-3), std::invalid_argument);
    EXPECT_THROW(setAll(scene, 0.0, 0.0, INFINITY), std::invalid_argument);
}
