// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps in contact: shocks, rest, rocking, tilting, moving walls, against closed forms.
#include "unit/nscd/scenes/clumpScenes.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace scenes;

namespace
{

const double pi = std::acos(-1.0);

/// Angular momentum about the origin.
Vec3 angularMomentum(const nscd::Clumps& clumps)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        sum += clumps.angularMomentum[c] + clumps.shapeOf(c).mass*clumps.position[c].cross(clumps.velocity[c]);
    }
    return sum;
}

double energy(const nscd::Clumps& clumps)
{
    double sum = 0.0;
    for (std::size_t c = 0; c < clumps.size(); ++c) sum += nscd::kineticEnergy(clumps, c);
    return sum;
}

/// Clumps that fly towards the origin, turning.
Scene implosion(double friction, double restitution)
{
    Scene scene(3, friction, restitution);
    const int shapes[] = {addShape(scene, pebble()), addShape(scene, dumbbell(1.5)), addShape(scene, tetrapod())};
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> random(-1.0, 1.0);
    const auto vector = [&] { return Vec3(random(engine), random(engine), random(engine)); };
    for (int k = 0; k < 27; ++k)
    {
        const Vec3 x = 0.06*Vec3(k % 3 - 1, k/3 % 3 - 1, k/9 - 1) + 0.003*vector();
        addClump(scene, shapes[k % 3], x, Quaternion(1.0, random(engine), random(engine), random(engine)), -10.0*x, 20.0*vector());
    }
    scene.addGrain(Vec3::Zero(), memberRadius);
    return scene;
}

/// Force of a floor on what lies on it, over the weight [-].
double floorLoad(const nscd::GrainDynamics& dynamics)
{
    return -dynamics.wallForce()[0][2]/(totalMass(dynamics.grains())*gravity);
}

} // namespace

/// The lower ball of one dumbbell meets the upper ball of another, without friction: p = (1 + e) V/W, W = 2 (1/M + a^2/J).
TEST(ClumpContact, shockOfTwoDumbbells)
{
    for (double e : {0.0, 0.5, 1.0})
    {
        Scene scene(3, 0.0, e);
        const int shape = addShape(scene, {{Vec3(0, -memberRadius, 0), memberRadius}, {Vec3(0, memberRadius, 0), memberRadius}});
        const double a = memberRadius, speed = 2.0;
        addClump(scene, shape, Vec3(0, 0, 0));
        addClump(scene, shape, Vec3(-2*memberRadius, 2*a, 0), Quaternion::Identity(), Vec3(speed, 0, 0));
        auto dynamics = scene.build();
        step(dynamics, Vec3::Zero(), 1e-5);
        const nscd::Clumps& clumps = dynamics.grains().clumps;
        const double m = clumps.shapes[0].mass, j = clumps.shapes[0].inertia(2, 2);
        const double p = (1.0 + e)*speed/(2.0*(1.0/m + a*a/j));
        EXPECT_LT((clumps.velocity[0] - Vec3(p/m, 0, 0)).norm(), 1e-9) << e;
        EXPECT_LT((clumps.velocity[1] - Vec3(speed - p/m, 0, 0)).norm(), 1e-9) << e;
        for (int c = 0; c < 2; ++c) EXPECT_LT((clumps.angularMomentum[c] - Vec3(0, 0, -a*p)).norm(), 1e-9*a*p) << e;
        const double lost = 0.25*(1.0 - e*e)*speed*speed/(1.0/m + a*a/j);
        EXPECT_NEAR(energy(clumps), 0.5*m*speed*speed - lost, 1e-9*m) << e;
    }
}

TEST(ClumpContact, collisionsKeepMomentum)
{
    for (double friction : {0.0, 0.5})
    {
        // Rebounds and overlap correction shift what moves without a turn to match: x cross v then changes with dt.
        nscd::ContactSettings settings = tight();
        settings.overlapTolerance = friction > 0.0 ? 5e-4 : 1.0;
        auto dynamics = implosion(friction, friction > 0.0 ? 0.5 : 0.0).build(settings);
        const nscd::Grains start = dynamics.grains();
        double scale = 0.0, turning = 0.0;
        for (std::size_t c = 0; c < start.clumps.size(); ++c)
        {
            scale += start.clumps.shapeOf(c).mass*start.clumps.velocity[c].norm();
            turning += start.clumps.angularMomentum[c].norm();
        }
        std::size_t contacts = 0;
        for (int k = 0; k < 120; ++k) contacts += step(dynamics, Vec3::Zero(), 1e-3).solve.contacts;
        const nscd::Grains& end = dynamics.grains();
        EXPECT_GT(contacts, 50u);
        EXPECT_LT((momentum(end) - momentum(start)).norm(), 1e-13*scale);
        EXPECT_LT(energy(end.clumps), energy(start.clumps));
        // Normal impulses have one line of action; friction acts on two surfaces that may be a gap apart.
        if (friction > 0.0) continue;
        const Vec3 ofSphere = end.mass.back()*end.position.back().cross(end.velocity.back());
        EXPECT_LT((angularMomentum(end.clumps) + ofSphere - angularMomentum(start.clumps)).norm(), 1e-12*turning);
    }
}

TEST(ClumpContact, stackOfCubesStaysAtRest)
{
    Scene scene(3, 0.5, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const int shape = addShape(scene, cube());
    for (int k = 0; k < 5; ++k) addClump(scene, shape, Vec3(0, 0, (2 + 4*k)*memberRadius));
    nscd::ContactSettings settings = tight();
    settings.tolerance = 1e-8;
    settings.displacementTolerance = 1e-8;
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 200; ++k) ASSERT_TRUE(step(dynamics, scene.g, 1e-3).solve.converged) << k;
    const nscd::Clumps& clumps = dynamics.grains().clumps;
    EXPECT_NEAR(floorLoad(dynamics), 1.0, 1e-6);
    for (int k = 0; k < 5; ++k)
    {
        EXPECT_LT((clumps.position[k] - Vec3(0, 0, (2 + 4*k)*memberRadius)).norm(), 1e-6*memberRadius) << k;
        EXPECT_LT(clumps.orientation[k].angularDistance(Quaternion::Identity()), 1e-6) << k;
    }
    EXPECT_LT(energy(clumps), 1e-12*clumps.shapes[0].mass*gravity*memberRadius);
}

/// A ball whose mass center lies c below its middle rocks with the frequency sqrt(M g c/(J + M (R - c)^2)).
TEST(ClumpContact, tumblerRocksWithItsFrequency)
{
    Scene scene(3, 1.0, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const double r = memberRadius, c = 0.4*r, m = 0.01, j = 0.3*m*r*r;
    scene.grains.clumps.shapes.push_back
    (
        nscd::makeClumpShape({{Vec3::Zero(), r}}, m, Vec3(0, 0, -c), j*Eigen::Matrix3d::Identity(), scene.grains.shape)
    );
    const double tilt = 0.02;
    const Quaternion tilted(Eigen::AngleAxisd(tilt, Vec3::UnitY()));
    addClump(scene, 0, Vec3(0, 0, r) + tilted*Vec3(0, 0, -c), tilted);
    auto dynamics = scene.build();
    const double omega = std::sqrt(m*gravity*c/(j + m*(r - c)*(r - c))), period = 2.0*pi/omega;
    const int steps = 1000;
    double largest = 0.0;
    for (int k = 0; k < 2*steps; ++k)
    {
        step(dynamics, scene.g, period/steps);
        const Vec3 up = dynamics.grains().clumps.orientation[0]*Vec3::UnitZ();
        const double expected = tilt*std::cos(omega*period/steps*(k + 1));
        largest = std::max(largest, std::abs(std::asin(up[0]) - expected));
    }
    EXPECT_LT(largest, 0.02*tilt);
}

/// An upright dumbbell falls like exp(lambda t), lambda^2 = M g a/(J + M (R + a)^2), its lower ball rolling.
TEST(ClumpContact, uprightDumbbellFallsOver)
{
    Scene scene(3, 1.0, 0.0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const double r = memberRadius, a = r, tilt = 1e-4;
    const int shape = addShape(scene, {{Vec3(0, 0, -a), r}, {Vec3(0, 0, a), r}});
    const Quaternion tilted(Eigen::AngleAxisd(tilt, Vec3::UnitY()));
    addClump(scene, shape, Vec3(0, 0, r) + tilted*Vec3(0, 0, a), tilted);
    const nscd::ClumpShape& body = scene.grains.clumps.shapes[0];
    const double lambda = std::sqrt(body.mass*gravity*a/(body.inertia(0, 0) + body.mass*(r + a)*(r + a)));
    auto dynamics = scene.build();
    const int steps = 1500;
    for (int k = 0; k < steps; ++k) step(dynamics, scene.g, 3.0/lambda/steps);
    const double angle = std::asin((dynamics.grains().clumps.orientation[0]*Vec3::UnitZ())[0]);
    EXPECT_NEAR(angle, tilt*std::cosh(3.0), 0.01*tilt*std::cosh(3.0));
    // And comes to rest on its side, on both balls.
    for (int k = 0; k < 1000; ++k) step(dynamics, scene.g, 1e-3);
    EXPECT_NEAR(dynamics.grains().clumps.position[0][2], r, 2e-3*r);
    EXPECT_NEAR(floorLoad(dynamics), 1.0, 1e-6);
}

/// A tetrapod on a slope: stays, slides with g (sin - mu cos), or tips where its weight passes the edge of its three feet.
TEST(ClumpContact, tetrapodOnASlope)
{
    const double r = memberRadius, height = r + 2*r*std::sqrt(2.0/3.0)/4.0, tipping = std::atan(r/std::sqrt(3.0)/height);
    const auto run = [&](double slope, double friction)
    {
        Scene scene(3, friction, 0.0);
        scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
        addClump(scene, addShape(scene, tetrapod()), Vec3(0, 0, height));
        // Downhill across the edge of two feet.
        scene.g = gravity*Vec3(0, -std::sin(slope), -std::cos(slope));
        auto dynamics = scene.build();
        for (int k = 0; k < 200; ++k) step(dynamics, scene.g, 1e-3);
        return dynamics.grains().clumps;
    };
    const nscd::Clumps still = run(0.98*tipping, 2.0);
    EXPECT_LT((still.position[0] - Vec3(0, 0, height)).norm(), 1e-6*r);
    EXPECT_LT(still.orientation[0].angularDistance(Quaternion::Identity()), 1e-6);
    EXPECT_GT(run(1.02*tipping, 2.0).orientation[0].angularDistance(Quaternion::Identity()), 0.05);

    const double slope = 0.5*tipping, limit = std::tan(slope);
    EXPECT_LT((run(slope, 1.01*limit).position[0] - Vec3(0, 0, height)).norm(), 1e-6*r);
    const double mu = 0.8*limit, expected = -gravity*(std::sin(slope) - mu*std::cos(slope))*0.2;
    EXPECT_NEAR(run(slope, mu).velocity[0][1], expected, 1e-6*std::abs(expected));
}

/// Discs: a clump of four in a square, on a line, in the plane y = 0.
TEST(ClumpContact, squareOfDiscsLiesInItsPlane)
{
    Scene scene(2, 0.4, 0.0);
    scene.grains.shape.emptyAxis = 1;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    const double r = memberRadius;
    const int shape = addShape(scene, {{Vec3(-r, 0, -r), r}, {Vec3(r, 0, -r), r}, {Vec3(-r, 0, r), r}, {Vec3(r, 0, r), r}});
    addClump(scene, shape, Vec3(0, 0, 4*r), Quaternion(Eigen::AngleAxisd(0.4, Vec3::UnitY())), Vec3::Zero(), Vec3(0, 3, 0));
    addClump(scene, shape, Vec3(0.5*r, 0, 9*r));
    auto dynamics = scene.build();
    for (int k = 0; k < 1500; ++k) step(dynamics, scene.g, 1e-3);
    const nscd::Clumps& clumps = dynamics.grains().clumps;
    EXPECT_NEAR(floorLoad(dynamics), 1.0, 1e-4);
    for (int c = 0; c < 2; ++c)
    {
        EXPECT_EQ(clumps.position[c][1], 0.0);
        EXPECT_EQ(clumps.angularMomentum[c][0], 0.0);
        EXPECT_LT(clumps.velocity[c].norm(), 1e-4);
    }
    EXPECT_LT(dynamics.contacts().front().gap, 1e-4*r);
}

/// A floor that rises carries a clump along; a triangulated one holds it as a plane does.
TEST(ClumpContact, movingTriangulatedFloorCarriesIt)
{
    Scene scene(3, 0.5, 0.0);
    const double size = 20*memberRadius;
    const int floor = scene.walls.addPatch("floor", 1);
    const Vec3 a(-size, -size, 0), b(size, -size, 0), c(size, size, 0), d(-size, size, 0);
    scene.walls.addTriangles(floor, {nscd::Triangle{a, b, c}, nscd::Triangle{a, c, d}});
    scene.walls.setMotion(floor, nscd::translation(Vec3(0.05, 0, 0.1)));
    addClump(scene, addShape(scene, tetrapod()), Vec3(0, 0, memberRadius*(1.0 + 0.5*std::sqrt(2.0/3.0))), Quaternion::Identity(), Vec3(0.05, 0, 0.1));
    auto dynamics = scene.build();
    const Vec3 start = dynamics.grains().clumps.position[0];
    for (int k = 0; k < 300; ++k) step(dynamics, scene.g, 1e-3);
    EXPECT_LT((dynamics.grains().clumps.position[0] - start - 0.3*Vec3(0.05, 0, 0.1)).norm(), 1e-5);
    EXPECT_NEAR(floorLoad(dynamics), 1.0, 1e-6);
}
