// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Statics against closed forms: pyramid, vertical stacks, a zig-zag wall, a hexagonal stack.
#include "accuracy/expectNear.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"

#include <gtest/gtest.h>

using namespace scenes;

namespace
{

constexpr double deltaT = 1e-3;

/// Three discs of radius 0.01 in a pyramid on a floor.
Scene pyramid(double grainFriction, double floorFriction)
{
    const double radius = 0.01;
    Scene scene(2, 0.0, 0.0);
    scene.g = Vec3(0, -gravity, 0);
    scene.materials.setPair(0, 0, {grainFriction, 0.0});
    scene.materials.setPair(0, 1, {floorFriction, 0.0});
    scene.addGrain(Vec3(-radius, radius, 0), radius);
    scene.addGrain(Vec3(radius, radius, 0), radius);
    scene.addGrain(Vec3(0, radius*(1 + std::sqrt(3.0)), 0), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitY());
    return scene;
}

double topAfterHalfASecond(const Scene& scene, const nscd::ContactSettings& settings = tight())
{
    auto dynamics = scene.build(settings);
    for (int k = 0; k < 500; ++k) step(dynamics, scene.g, deltaT);
    return dynamics.grains().position[2][1];
}

} // namespace

TEST(Pyramid, standsAboveTheFrictionThresholdsWithKnownImpulses)
{
    const Scene scene = pyramid(0.270, 0.0895);
    auto dynamics = scene.build();
    for (int k = 0; k < 500; ++k) step(dynamics, scene.g, deltaT);
    figures::expectBelow("A07", "sink of the top in 0.5 s [m]", std::abs(dynamics.grains().position[2][1] - scene.grains.position[2][1]), 1e-10);

    const double unit = dynamics.grains().mass[0]*gravity*deltaT;
    for (const nscd::LoadedContact& c : dynamics.contacts())
    {
        const double rn = c.impulse.dot(c.normal), rt = (c.impulse - rn*c.normal).norm();
        const bool isBaseBase = c.b >= 0 && c.a < 2 && c.b < 2;
        const double expected = isBaseBase ? 0.0 : c.b < 0 ? 1.5 : 0.5;
        figures::expectNear("A07", "normal impulses over m g dt", rn/unit, expected, 1e-6);
        figures::expectNear("A07", "friction impulses over m g dt", rt/unit, isBaseBase ? 0.0 : 0.5*std::tan(std::acos(-1.0)/12), 1e-6);
    }
}

TEST(Pyramid, fallsBelowEitherThreshold)
{
    const double start = pyramid(1, 1).grains.position[2][1];
    EXPECT_LT(topAfterHalfASecond(pyramid(0.265, 0.0895)), start - 1e-3);
    EXPECT_LT(topAfterHalfASecond(pyramid(0.270, 0.0885)), start - 1e-3);
}

TEST(Pyramid, keepsItsThresholdsAtATenthOfTheDeadBand)
{
    nscd::ContactSettings settings = tight();
    settings.deadBand *= 0.1;
    const double start = pyramid(1, 1).grains.position[2][1];
    EXPECT_NEAR(topAfterHalfASecond(pyramid(0.270, 0.0895), settings), start, 1e-10);
    EXPECT_LT(topAfterHalfASecond(pyramid(0.265, 0.0895), settings), start - 1e-3);
    EXPECT_LT(topAfterHalfASecond(pyramid(0.270, 0.0885), settings), start - 1e-3);
}

namespace
{

/// Largest error of the impulses in a stack, in N m g dt, over steps 1 and 100.
double stackError(int grains)
{
    const double radius = 0.01;
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    // The residual of a chain is (pi/2N)^2 times the error of its impulses.
    nscd::ContactSettings settings = tight();
    settings.tolerance = settings.displacementTolerance = 1e-11;
    auto dynamics = scene.build(settings);

    double worst = 0.0;
    for (int k = 1; k <= 100; ++k)
    {
        step(dynamics, scene.g, deltaT);
        if (k != 1 && k != 100) continue;
        const double unit = dynamics.grains().mass[0]*gravity*deltaT;
        EXPECT_EQ(dynamics.contacts().size(), static_cast<std::size_t>(grains));
        for (const nscd::LoadedContact& c : dynamics.contacts())
        {
            const int lower = c.b < 0 ? 0 : std::max(c.a, c.b);
            worst = std::max(worst, std::abs(c.impulse.norm()/unit - (grains - lower))/grains);
            EXPECT_LT(-c.gap, 1e-6*radius);
        }
    }
    return worst;
}

} // namespace

TEST(Stack, carriesItsWeightFromColdAndAfterAHundredSteps)
{
    for (int grains : {5, 20, 100})
    {
        figures::expectBelow("A08 stack of " + std::to_string(grains) + ", steps 1 and 100", "impulses, N m g dt", stackError(grains), 1e-6);
    }
}

namespace
{

/// After one step from cold: base force against weight, and the residual by the independent judge.
void expectEquilibrium(const Scene& scene, double friction, const nscd::ContactSettings& settings)
{
    auto dynamics = scene.build(settings);
    const double deadBand = settings.deadBand*2*scene.grains.radius[0];
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    EXPECT_TRUE(report.solve.converged) << report.solve.sweeps << " sweeps, rms " << report.solve.residualRms;
    Vec3 base = Vec3::Zero();
    for (const Vec3& force : dynamics.wallForce()) base += force;
    double mass = 0.0;
    for (double m : scene.grains.mass) mass += m;
    const Vec3 weightForce = mass*scene.g;
    EXPECT_NEAR((base - weightForce).norm(), 0.0, 1e-6*weightForce.norm()) << report.solve.sweeps << " sweeps";
    Judge judge(scene, friction, deadBand, deltaT);
    EXPECT_LT(judge(scene.grains, dynamics).max, 1e-6*gravity*deltaT);
    for (const Vec3& v : dynamics.grains().velocity) ASSERT_LT(v.norm(), 1e-5*gravity*deltaT);
}

} // namespace

TEST(Stack, zigZagWallCarriesItsWeightFromCold)
{
    // Three columns whose rows are shifted by turns, held by side walls.
    const double radius = 0.01, rise = 1.9*radius;
    const double shift = std::sqrt(4*radius*radius - rise*rise);
    Scene scene(2, 0.5, 0.0);
    scene.g = Vec3(0, -gravity, 0);
    for (int row = 0; row < 100; ++row)
    {
        for (int column = 0; column < 3; ++column)
        {
            scene.addGrain(Vec3(radius*(2*column + 1) + (row % 2)*shift, radius + rise*row, 0), radius);
        }
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitY());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(6*radius + shift, 0, 0), -Vec3::UnitX());
    nscd::ContactSettings settings = tight();
    settings.tolerance = settings.displacementTolerance = 1e-9;
    expectEquilibrium(scene, 0.5, settings);
}

TEST(Stack, hexagonalStackCarriesItsWeightFromCold)
{
    const double radius = 0.01;
    Scene scene(2, 0.5, 0.0);
    scene.g = Vec3(0, -gravity, 0);
    for (int row = 0; row < 100; ++row)
    {
        for (int i = 0; i < 20 - row % 2; ++i)
        {
            scene.addGrain(Vec3(radius*(2*i + 1 + row % 2), radius*(1 + std::sqrt(3.0)*row), 0), radius);
        }
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitY());
    // A disc at the end of a long row stands on one disc only: without side walls the stack unravels.
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(40*radius, 0, 0), -Vec3::UnitX());
    nscd::ContactSettings settings = tight();
    settings.tolerance = settings.displacementTolerance = 1e-8;
    expectEquilibrium(scene, 0.5, settings);
}

namespace
{

/// Force on the floor over weight, step by step, of a cubic lattice from cold at default settings.
std::vector<double> floorShares(int side, int layers, int steps)
{
    const double radius = 0.5e-3;
    Scene scene(3, 0.3, 0.0);
    for (int z = 0; z < layers; ++z)
    for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) scene.addGrain(radius*Vec3(2*x + 1, 2*y + 1, 2*z + 1), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.sleep = false;
    auto dynamics = scene.build(settings);
    std::vector<double> shares;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::SolveReport report = step(dynamics, scene.g, deltaT).solve;
        EXPECT_TRUE(report.converged) << k;
        EXPECT_LE(report.forceError, settings.forceTolerance) << k;
        shares.push_back(std::abs(dynamics.wallForce()[0][2])/(side*side*layers*dynamics.grains().mass[0]*gravity));
    }
    return shares;
}

} // namespace

TEST(Stack, floorCarriesTheWeightAtDefaultSettingsFromCold)
{
    for (double share : floorShares(1, 1000, 3)) EXPECT_NEAR(share, 1.0, 0.02);
    for (double share : floorShares(6, 50, 5)) EXPECT_NEAR(share, 1.0, 0.02);
    for (double share : floorShares(6, 100, 5)) EXPECT_NEAR(share, 1.0, 0.02);
}
