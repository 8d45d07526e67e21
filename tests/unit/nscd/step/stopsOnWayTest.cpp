// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fast grains at surfaces of triangles, at edges, at walls that move, and behind others: none comes through.
#include "unit/nscd/scenes/drums.hpp"
#include "unit/nscd/scenes/shots.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

/// A floor of triangles that are as wide as `width`.
std::vector<nscd::Triangle> tiles(double width, int n)
{
    std::vector<nscd::Triangle> triangles;
    const auto at = [=](int i, int j) { return Vec3(width*(i - 0.5*n), width*(j - 0.5*n), 0.0); };
    for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    return triangles;
}

/// A scene with a floor of 800 triangles, 0.4 m wide.
Scene withTiles(double friction, double restitution)
{
    Scene scene(3, friction, restitution);
    scene.walls.addTriangles(scene.walls.addPatch("floor", 1), tiles(0.02, 20));
    return scene;
}

void addShot(Scene& scene, const Vec3& x, double radius, const Vec3& v)
{
    scene.addGrain(x, radius);
    scene.grains.velocity.back() = v;
}

double nearestPair(const nscd::Grains& grains)
{
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (grains.position[i] - grains.position[j]).norm());
    return nearest;
}

} // namespace

TEST(StopsOnWay, holdAVolleyAtAWavySheet)
{
    const Scene scene = volleyAtSheet();
    auto dynamics = scene.build(nscd::ContactSettings());
    std::size_t stopped = 0;
    for (int k = 0; k < 5; ++k)
    {
        stopped += step(dynamics, scene.g, deltaT).stoppedOnWay;
        for (const Vec3& x : dynamics.grains().position) EXPECT_GT(x[2], waveHeight(x)) << k;
    }
    EXPECT_GE(stopped, 144u);
}

TEST(StopsOnWay, areWhereTheGrainTouchesAndLeaveItsVelocityToTheNextStep)
{
    for (double e : {0.0, 0.5, 1.0})
    {
        Scene scene = withTiles(0.0, e);
        const Vec3 v(30, 10, -60);
        addShot(scene, Vec3(0.001, 0.002, 0.04), 0.005, v);
        auto dynamics = scene.build();
        EXPECT_EQ(step(dynamics, Vec3::Zero(), deltaT).stoppedOnWay, 1u);
        EXPECT_LT((dynamics.grains().velocity[0] - v).norm(), 1e-12);
        const Vec3 touching = Vec3(0.001, 0.002, 0.04) + 0.035/60*v;
        EXPECT_LT((dynamics.grains().position[0] - touching).norm(), 1e-12);
        EXPECT_EQ(step(dynamics, Vec3::Zero(), deltaT).stoppedOnWay, 0u);
        EXPECT_LT((dynamics.grains().velocity[0] - Vec3(30, 10, 60*e)).norm(), 1e-8);
    }
}

TEST(StopsOnWay, leaveOtherImpactsOfTheirStepTheirNormals)
{
    // Side by side at 60 m/s, the second closing in at 1 m/s: it goes on beside the floor's edge, far below the first one, which the floor stops.
    Scene scene = withTiles(0.0, 1.0);
    addShot(scene, Vec3(0.197, 0.002, 0.04), 0.005, Vec3(0, 0, -60));
    addShot(scene, Vec3(0.2072, 0.002, 0.04), 0.005, Vec3(-1, 0, -60));
    auto dynamics = scene.build();
    EXPECT_EQ(step(dynamics, Vec3::Zero(), deltaT).stoppedOnWay, 1u);
    const nscd::Grains& grains = dynamics.grains();
    EXPECT_LT(grains.position[1][2], grains.position[0][2] - 0.02);
    EXPECT_LT((grains.velocity[0] - Vec3(-1, 0, -60)).norm(), 1e-8);
    EXPECT_LT((grains.velocity[1] - Vec3(0, 0, -60)).norm(), 1e-8);
}

TEST(StopsOnWay, giveTheWallTheWholeImpulse)
{
    Scene scene = withTiles(0.3, 1.0);
    addShot(scene, Vec3(0.001, 0.002, 0.04), 0.005, Vec3(0, 0, -60));
    auto dynamics = scene.build();
    Vec3 impulse = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
        step(dynamics, Vec3::Zero(), deltaT);
        impulse += deltaT*dynamics.wallForce()[0];
    }
    EXPECT_NEAR(impulse[2], -120*scene.grains.mass[0], 1e-8*scene.grains.mass[0]);
}

TEST(StopsOnWay, doNotHinderWhatGlidesAlongTriangles)
{
    Scene scene = withTiles(0.0, 0.0);
    addShot(scene, Vec3(-0.19, 0.003, 0.005), 0.005, Vec3(9, 1, 0));
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 40; ++k) EXPECT_EQ(step(dynamics, scene.g, deltaT).stoppedOnWay, 0u) << k;
    EXPECT_NEAR(dynamics.grains().position[0][0], -0.19 + 40*deltaT*9, 1e-9);
    EXPECT_NEAR(dynamics.grains().position[0][2], 0.005, 1e-5);
}

TEST(StopsOnWay, doNotHinderWhatRunsAroundAFineDrum)
{
    // A diameter a step along a wall of radius 0.1 m, each step of which leads by R/10 into it: as with few triangles it is pushed out.
    Scene scene(3, 0.0, 0.0);
    scene.walls.addTriangles(scene.walls.addPatch("ball", 1), ball(5));
    constexpr double radius = 0.002;
    addShot(scene, Vec3(0.098, 0, 0), radius, Vec3(0, 4, 0));
    auto dynamics = scene.build(nscd::ContactSettings());
    std::size_t stopped = 0;
    double angle = 0.0;
    Vec3 before = dynamics.grains().position[0];
    for (int k = 0; k < 50; ++k)
    {
        stopped += step(dynamics, Vec3::Zero(), deltaT).stoppedOnWay;
        const Vec3 x = dynamics.grains().position[0];
        angle += std::acos(std::min(1.0, x.normalized().dot(before.normalized())));
        before = x;
    }
    EXPECT_EQ(stopped, 0u);
    EXPECT_NEAR(angle, 50*0.004/0.098, 0.1*50*0.004/0.098);
}

TEST(StopsOnWay, leaveNoGrainInWallsThatItCameToWithinTheStep)
{
    // Two diameters a step along facets of 10 mm: around a corner it gets by up to 0.4 R into the next one, which is too far away to be listed.
    Scene scene(3, 0.0, 0.0);
    scene.walls.addTriangles(scene.walls.addPatch("drum", 1), mantle(0.1, 0.04, 60));
    constexpr double radius = 0.002;
    addShot(scene, Vec3(0.0975, 0, 0), radius, Vec3(0, 0, 8));
    auto dynamics = scene.build(nscd::ContactSettings());
    double uncorrected = 0.0;
    for (int k = 0; k < 50; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        double distance = 1.0;
        for (const nscd::WallRegion& region : scene.walls.regions)
        {
            distance = std::min(distance, std::abs(nscd::nearestPoint(region, dynamics.grains().position[0]).distance));
        }
        EXPECT_LE(radius - distance, report.overlapMax*2*radius + 1e-12) << k;
        EXPECT_LT(radius - distance, 1e-3*2*radius) << k;
        uncorrected = std::max(uncorrected, report.overlapUncorrected);
    }
    EXPECT_GT(uncorrected, 0.05);
}

TEST(StopsOnWay, doNotLetGrainsThroughHolesThatAreTooSmall)
{
    // A plate of four rectangles around a square hole.
    for (double share : {0.9, 0.99, 1.02})
    {
        Scene scene(3, 0.0, 0.0);
        constexpr double radius = 0.005, far = 0.1;
        const double half = share*radius;
        std::vector<nscd::Triangle> plate;
        const auto add = [&](double x0, double y0, double x1, double y1)
        {
            for (int i = 0; i < 4; ++i)
            {
                const Vec3 a(x0 + i*(x1 - x0)/4, y0, 0), b(x0 + (i + 1)*(x1 - x0)/4, y0, 0), c(b[0], y1, 0), d(a[0], y1, 0);
                plate.push_back({a, b, c});
                plate.push_back({a, c, d});
            }
        };
        add(-far, -far, far, -half);
        add(-far, half, far, far);
        add(-far, -half, -half, half);
        add(half, -half, far, half);
        scene.walls.addTriangles(scene.walls.addPatch("plate", 1), plate);
        addShot(scene, Vec3(0, 0, 0.05), radius, Vec3(0, 0, -100));
        auto dynamics = scene.build(nscd::ContactSettings());
        for (int k = 0; k < 4; ++k) step(dynamics, Vec3::Zero(), deltaT);
        EXPECT_EQ(dynamics.grains().position[0][2] < -0.01, share > 1.0) << share;
    }
}

TEST(StopsOnWay, holdThoseBehind)
{
    for (double speed : {40.0, 90.0, 300.0})
    {
        Scene scene = withTiles(0.3, 0.5);
        constexpr double radius = 0.004;
        for (int k = 0; k < 6; ++k) addShot(scene, Vec3(0.001, 0.001, 0.03 + 2.2*k*radius), radius, Vec3(0, 0, -speed));
        for (int k = 0; k < 4; ++k) addShot(scene, Vec3(0.06 + 0.02*k, 0.001, 0.03), radius, Vec3(-20.0*k, 0, -speed));
        auto dynamics = scene.build(nscd::ContactSettings());
        const double start = nscd::kineticEnergy(dynamics.grains());
        for (int k = 0; k < 20; ++k)
        {
            const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
            EXPECT_LT(report.overlapUncorrected, 1e-2) << speed << ' ' << k;
            for (const Vec3& x : dynamics.grains().position) EXPECT_GT(x[2], 0.99*radius) << speed << ' ' << k;
            EXPECT_LE(nscd::kineticEnergy(dynamics.grains()), (1.0 + 1e-9)*start);
        }
    }
}

TEST(StopsOnWay, holdThoseBehindAtWallsThatMove)
{
    // A floor that goes by six radii a step, away from the grains, towards them, and turning.
    constexpr double radius = 0.5e-3;
    const nscd::WallMotion motions[] =
    {
        nscd::translation(Vec3(2, -1, -3)), nscd::translation(Vec3(2, -1, 3)), nscd::rotation(Vec3(0.1, 0, 0), Vec3(1, 2, 3), 30)
    };
    for (const nscd::WallMotion& motion : motions)
    {
        Scene scene = withTiles(0.0, 0.0);
        scene.walls.setMotion(0, motion);
        for (int k = 0; k < 6; ++k) addShot(scene, Vec3(0.001, 0.001, 0.03 + 2.2*k*radius), radius, Vec3(20, -30, -60));
        auto dynamics = scene.build(nscd::ContactSettings());
        std::size_t stopped = 0;
        for (int k = 0; k < 4; ++k)
        {
            const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
            stopped += report.stoppedOnWay;
            // Into walls it may be a quarter of a diameter.
            EXPECT_LT(report.overlapUncorrected, 0.251) << k;
            if (k == 0)
            {
                EXPECT_GT(nearestPair(dynamics.grains()), 1.998*radius);
            }
            const nscd::WallPose& pose = dynamics.walls().patches[0].pose;
            for (const Vec3& x : dynamics.grains().position) EXPECT_GT((pose.inverse()*x)[2], 0.4*radius) << k;
        }
        EXPECT_GE(stopped, 6u);
    }
}

TEST(StopsOnWay, areAtWallsThatComeToGrains)
{
    // A sheet of 800 triangles that goes 20 d a step over grains at rest, and takes along those that it meets.
    Scene scene(3, 0.0, 0.0);
    const int sheet = scene.walls.addPatch("sheet", 1);
    scene.walls.addTriangles(sheet, tiles(0.02, 20));
    scene.walls.setMotion(sheet, nscd::translation(Vec3(0, 0, 200)));
    for (int k = 0; k < 8; ++k) scene.addGrain(Vec3(0.02*k - 0.07, 0.003, 0.05 + 0.2*k), 0.005);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 6; ++k)
    {
        step(dynamics, Vec3::Zero(), deltaT);
        for (const Vec3& x : dynamics.grains().position) EXPECT_GT(x[2], 0.2*(k + 1) + 0.5*0.005) << k;
    }
}

TEST(StopsOnWay, keepAGasInItsBox)
{
    // 200 diameters a step, elastic, in a closed surface of 2048 triangles.
    Scene scene(3, 0.0, 1.0);
    scene.walls.addTriangles(scene.walls.addPatch("ball", 1), ball(4));
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    constexpr double radius = 0.002;
    for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
    {
        const Vec3 v(normal(random), normal(random), normal(random));
        addShot(scene, Vec3(0.01*i, 0.01*j, 0.001*normal(random)), radius, 800*v);
    }
    auto dynamics = scene.build(nscd::ContactSettings());
    double before = nscd::kineticEnergy(dynamics.grains());
    for (int k = 0; k < 30; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
        const double now = nscd::kineticEnergy(dynamics.grains());
        EXPECT_LE(now, before + report.solve.shockResidualWork + 1e-9*before) << k;
        before = now;
        for (const Vec3& x : dynamics.grains().position) EXPECT_FALSE(isOutside(dynamics.walls(), x)) << k;
    }
}

TEST(StopsOnWay, goThroughPeriodicSides)
{
    // A post in the next period: the way leads out of the box, and there.
    Scene scene(3, 0.0, 0.0);
    scene.box.lower = Vec3(-0.2, -0.2, -0.2);
    scene.box.length = Vec3(0.4, 0.4, 0.4);
    std::vector<nscd::Triangle> post = tiles(0.02, 10);
    for (nscd::Triangle& t : post) for (Vec3& x : t) x = Vec3(-0.1, x[0], x[1]);
    scene.walls.addTriangles(scene.walls.addPatch("post", 1), post);
    addShot(scene, Vec3(0.1, 0.01, 0.01), 0.005, Vec3(300, 0, 0));
    auto dynamics = scene.build();
    EXPECT_EQ(step(dynamics, Vec3::Zero(), deltaT).stoppedOnWay, 1u);
    EXPECT_NEAR(dynamics.grains().position[0][0], -0.105, 1e-12);
}

TEST(StopsOnWay, ofDiscsStayInTheirPlane)
{
    Scene scene(2, 0.3, 0.5);
    scene.grains.shape.emptyAxis = 2;
    std::vector<nscd::Triangle> wall = tiles(0.02, 10);
    for (nscd::Triangle& t : wall) for (Vec3& x : t) x = Vec3(0.1 + 0.02*std::sin(60*x[0]), x[0], x[1]);
    scene.walls.addTriangles(scene.walls.addPatch("wall", 1), wall);
    for (int k = 0; k < 8; ++k) addShot(scene, Vec3(0, 0.02*k - 0.07, 0), 0.005, Vec3(200, 3.0*k, 0));
    auto dynamics = scene.build(nscd::ContactSettings());
    for (int k = 0; k < 6; ++k)
    {
        step(dynamics, Vec3::Zero(), deltaT);
        for (const Vec3& x : dynamics.grains().position)
        {
            EXPECT_LT(x[0], 0.12);
            EXPECT_EQ(x[2], 0.0);
        }
    }
}

TEST(StopsOnWay, letNoShotThrough)
{
    for (int grains : {1, 2})
    for (const Surface surface : allSurfaces())
    {
        Tally tally;
        shoot(surface, 600, grains, 7, tally);
        EXPECT_EQ(tally.passed, 0) << static_cast<int>(surface);
        EXPECT_LT(tally.energyGain, 1e-9);
    }
}
