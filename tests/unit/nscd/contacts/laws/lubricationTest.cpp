// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Films of fluid between grains, against what follows from their law in closed form, at steps short and long.
#include "nscd/contacts/laws/lubrication.hpp"

#include "unit/nscd/scenes/lawScenes.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double radius = 1e-3, roughness = 1e-6, range = 1e-4, viscosity = 0.05;
const double pi = 3.14159265358979323846;

nscd::ContactPair filmedPair(double friction, double restitution)
{
    nscd::ContactPair pair{friction, restitution};
    pair.roughness = roughness;
    pair.lubricationRange = range;
    pair.lubricationViscosity = viscosity;
    return pair;
}

Scene withoutWeight(double restitution)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, filmedPair(0.0, restitution));
    scene.g = Vec3::Zero();
    return scene;
}

double strength(double reducedRadius) { return 6.0*pi*viscosity*reducedRadius*reducedRadius; }

/// ln((range + g_r)/g_r)
double wholeFilm() { return std::log((range + roughness)/roughness); }

nscd::StepReport freeStep(nscd::GrainDynamics& dynamics, double deltaT, double speedScale)
{
    nscd::ExternalForces forces;
    forces.force.assign(dynamics.grains().size(), Vec3::Zero());
    forces.speedScale = speedScale;
    dynamics.beginStep(deltaT);
    return dynamics.advance(forces);
}

/// A sphere flung at a floor from outside its film, until it is outside again, or for a second: speed away from the floor.
double bounce(double speed, double restitution, double deltaT)
{
    Scene scene = withoutWeight(restitution);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addGrain(Vec3(0, 0, radius + 1.5*range), radius);
    scene.grains.velocity.back() = Vec3(0, 0, -speed);
    auto dynamics = scene.build(tight());
    const auto& grains = dynamics.grains();
    for (double t = 0.0; t < 1.0 && grains.position[0][2] < radius + 2.0*range; t += deltaT)
    {
        EXPECT_TRUE(freeStep(dynamics, deltaT, 1e-3*speed).solve.converged);
        EXPECT_GT(grains.position[0][2], radius - 1e-9*radius);
        if (std::abs(grains.velocity[0][2]) < 1e-9*speed) break;
    }
    return grains.velocity[0][2];
}

/// sediFoam's film between bodies that near each other: LAMMPS's pair_style lubricate/poly without logarithms [N s/m]; at a wall, its cloud's own, which
/// is the limit of a very large second body.
double resistanceOfSediFoam(double radius, double otherRadius, double gap)
{
    const double beta = otherRadius/radius;
    return 6.0*pi*viscosity*radius*(beta*beta/(1.0 + beta)/(1.0 + beta)/(gap/radius));
}

/// What of a relative speed is left after the way through that film and back, by small explicit steps; it acts from 1e-4 to 0.1 diameters.
double leftBySediFoam(double speed, double reducedMass, double radius, double otherRadius)
{
    const double least = 1e-4*2.0*radius, most = 0.1*2.0*radius, share = 1e-4;
    for (double gap = most; gap > least; gap *= 1.0 - share) speed -= share*gap*resistanceOfSediFoam(radius, otherRadius, gap)/reducedMass;
    for (double gap = least; gap < most; gap *= 1.0 + share) speed -= share*gap*resistanceOfSediFoam(radius, otherRadius, gap)/reducedMass;
    return speed;
}

double massOfOne(const Scene& scene) { return scene.grains.mass[0]; }

} // namespace

TEST(Lubrication, anImpactLosesWhatTheFilmTakesAtAnyTimeStep)
{
    Scene scene = withoutWeight(0.0);
    scene.addGrain(Vec3::Zero(), radius);
    const double e = 0.9, lost = strength(radius)/massOfOne(scene)*wholeFilm();
    for (double speed : {1.2*lost, 3.0*lost, 20.0*lost})
    for (double steps : {0.3, 3.0, 300.0})
    {
        const double expected = std::max(0.0, e*(speed - lost) - lost);
        EXPECT_NEAR(bounce(speed, e, range/speed/steps), expected, 1e-6*speed) << speed/lost << ' ' << steps;
    }
}

TEST(Lubrication, aSlowSphereEndsInTheFilm)
{
    Scene scene = withoutWeight(0.9);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addGrain(Vec3(0, 0, radius + 1.5*range), radius);
    const double k = strength(radius), m = massOfOne(scene), speed = 0.5*k/m*wholeFilm();
    scene.grains.velocity.back() = Vec3(0, 0, -speed);
    auto dynamics = scene.build(tight());
    for (int step = 0; step < 400; ++step) freeStep(dynamics, 0.1*range/speed, 1e-3*speed);
    EXPECT_NEAR(dynamics.grains().position[0][2] - radius + roughness, (range + roughness)*std::exp(-m*speed/k), 1e-4*roughness);
}

TEST(Lubrication, twoSpheresLoseRelativeSpeedAloneByTheirReducedRadiusAndMass)
{
    Scene scene = withoutWeight(1.0);
    scene.addGrain(Vec3(-radius - 0.6*range, 0, 0), radius);
    scene.addGrain(Vec3(2.0*radius + 0.6*range, 0, 0), 2.0*radius, 1000.0);
    const auto& m = scene.grains.mass;
    const double reducedMass = m[0]*m[1]/(m[0] + m[1]), lost = strength(2.0/3.0*radius)/reducedMass*wholeFilm(), speed = 5.0*lost;
    scene.grains.velocity[0] = Vec3(speed, 0, 0);
    const Vec3 momentum = m[0]*scene.grains.velocity[0];
    auto dynamics = scene.build(tight());
    for (int step = 0; step < 40; ++step) freeStep(dynamics, 0.1*range/speed, 1e-3*speed);
    const auto& v = dynamics.grains().velocity;
    EXPECT_NEAR(v[1][0] - v[0][0], speed - 2.0*lost, 1e-6*speed);
    EXPECT_LT((m[0]*v[0] + m[1]*v[1] - momentum).norm(), 1e-12*momentum.norm());
}

TEST(Lubrication, takesWhatTheFilmOfSediFoamTakes)
{
    nscd::ContactPair film = filmedPair(0.0, 1.0);
    film.roughness = 1e-4*2.0*radius;
    film.lubricationRange = 0.1*2.0*radius;
    for (double otherRadius : {radius, 3.0*radius, 1e6*radius})
    {
        const bool isWall = otherRadius > 100.0*radius;
        Scene scene(3, 0.0, 0.0);
        setAll(scene, film);
        scene.g = Vec3::Zero();
        scene.addGrain(Vec3(0, 0, 1.25*radius), radius);
        if (isWall) scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        else scene.addGrain(Vec3(0, 0, -otherRadius), otherRadius);
        const double mass = massOfOne(scene), reducedMass = isWall ? mass : mass*scene.grains.mass[1]/(mass + scene.grains.mass[1]);
        const double speed = 40.0*strength(radius)/reducedMass;
        scene.grains.velocity[0] = Vec3(0, 0, -speed);
        auto dynamics = scene.build(tight());
        for (int step = 0; step < 100; ++step) freeStep(dynamics, 0.02*radius/speed, 1e-3*speed);
        const double left = dynamics.grains().velocity[0][2] - (isWall ? 0.0 : dynamics.grains().velocity[1][2]);
        const double lost = speed - leftBySediFoam(speed, reducedMass, radius, otherRadius);
        EXPECT_NEAR(speed - left, lost, 1e-3*lost) << otherRadius;
    }
}

TEST(Lubrication, aForceSqueezesTheFilmExponentially)
{
    Scene scene = withoutWeight(0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addGrain(Vec3(0, 0, radius + 0.9*range), radius);
    // Inertia is forgotten in m (g + g_r)/k, a millisecond; the film takes seconds.
    const double k = strength(radius), time = 1.0, force = k/time, deltaT = 0.5*time;
    auto dynamics = scene.build(tight());
    nscd::ExternalForces forces;
    forces.force = {Vec3(0, 0, -force)};
    forces.speedScale = force*deltaT/massOfOne(scene);
    double thickness = 0.9*range + roughness;
    for (int step = 0; step < 12; ++step)
    {
        dynamics.beginStep(deltaT);
        ASSERT_TRUE(dynamics.advance(forces).solve.converged);
        thickness = std::max(roughness, thickness*std::exp(-deltaT/time));
        EXPECT_NEAR(dynamics.grains().position[0][2] - radius + roughness, thickness, 2e-3*thickness) << step;
    }
    EXPECT_NEAR(dynamics.wallForce()[0][2], -force, 1e-3*force);
}

TEST(Lubrication, aSuspensionLosesEnergyAndKeepsItsMomentum)
{
    for (double friction : {0.0, 0.4})
    {
        Scene scene = withoutWeight(0.8);
        setAll(scene, filmedPair(friction, 0.8));
        std::mt19937 random(7);
        std::normal_distribution<double> normal(0.0, 0.05);
        scene.scatter(std::vector<double>(150, radius), Vec3(0.0145, 0.0145, 0.0145), random);
        for (Vec3& v : scene.grains.velocity) v = Vec3(normal(random), normal(random), normal(random));
        auto dynamics = scene.build();
        const auto momentum = [&]
        {
            Vec3 sum = Vec3::Zero();
            for (std::size_t i = 0; i < dynamics.grains().size(); ++i) sum += dynamics.grains().mass[i]*dynamics.grains().velocity[i];
            return sum;
        };
        const Vec3 before = momentum();
        double energy = nscd::kineticEnergy(dynamics.grains());
        const double atStart = energy;
        for (int step = 0; step < 100; ++step)
        {
            EXPECT_TRUE(freeStep(dynamics, 2e-4, 1e-4).solve.converged) << step;
            const double now = nscd::kineticEnergy(dynamics.grains());
            ASSERT_LE(now, energy*(1.0 + 1e-9)) << step;
            energy = now;
        }
        EXPECT_LT(energy, 0.6*atStart);
        EXPECT_LT((momentum() - before).norm(), 1e-12*dynamics.grains().mass[0]*150*0.05);
    }
}

TEST(Lubrication, aHeapComesToRestOnItsContacts)
{
    Scene scene(3, 0.0, 0.0);
    setAll(scene, filmedPair(0.3, 0.5));
    scene.addOpenBox(0.009);
    std::mt19937 random(3);
    scene.scatter(std::vector<double>(80, radius), Vec3(0.009, 0.009, 0.05), random);
    auto dynamics = scene.build(nscd::ContactSettings());
    double weight = 0.0, onWalls = 0.0;
    for (double m : scene.grains.mass) weight += m*gravity;
    for (int k = 0; k < 400; ++k) EXPECT_FALSE(step(dynamics, scene.g, 1e-3).solve.atCap);
    for (const Vec3& force : dynamics.wallForce()) onWalls += force[2];
    EXPECT_NEAR(onWalls, -weight, 1e-2*weight);
    // Of one grain or another that yet leaves its place: in 12 starts by two orders of contacts 6 of 24 heaps have one that moves at 0.01 to 0.06 m/s at 0.2, 0.3 or 0.4 s.
    double squares = 0.0;
    for (const Vec3& v : dynamics.grains().velocity) squares += v.squaredNorm();
    EXPECT_LT(std::sqrt(squares/static_cast<double>(scene.grains.size())), 5e-3);
}

TEST(Lubrication, contactsOfFilmsAreReported)
{
    Scene scene = withoutWeight(0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addGrain(Vec3(0, 0, radius + 0.5*range), radius);
    scene.grains.velocity.back() = Vec3(0, 0, -1e-3);
    auto dynamics = scene.build(tight());
    freeStep(dynamics, 1e-4, 1e-6);
    const auto contacts = dynamics.contacts();
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].impulse[2], massOfOne(scene)*(dynamics.grains().velocity[0][2] + 1e-3), 1e-12);
    EXPECT_GT(contacts[0].impulse[2], 0.0);
}

TEST(Lubrication, isRefusedWhereItIsNotKnown)
{
    Scene discs(2, 0.0, 0.0);
    setAll(discs, filmedPair(0.0, 0.0));
    EXPECT_THROW(discs.build(), std::invalid_argument);
    Scene rolls(3, 0.0, 0.0);
    nscd::ContactPair pair = filmedPair(0.3, 0.0);
    pair.rollingFriction = 0.1;
    setAll(rolls, pair);
    EXPECT_THROW(rolls.build(), std::invalid_argument);
    pair = filmedPair(0.3, 0.0);
    pair.lubricationRange = 0.0;
    EXPECT_THROW(setAll(rolls, pair), std::invalid_argument);
}
