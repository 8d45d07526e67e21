// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Stress scenes too long for the unit tests: S4 (heavy on light), S16 (gravity turned over), S22 (dense elastic gas), and what
// a cap on the sweeps does to them: reported, never silent.
#include "../../unit/nscd/heaps.hpp"
#include "../resources/bars.hpp"

#include <cstdio>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

/// S4: a sphere `ratio` times heavier on a stack of light ones; what it says of itself against what is true.
void heavyOnLight(int light, double ratio, int maxSweeps, int steps)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i <= light; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.grains.mass.back() *= ratio;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings settings;
    settings.maxSweeps = maxSweeps;
    auto dynamics = scene.build(settings);
    int capped = 0, silent = 0, mostSweeps = 0;
    double overlap = 0.0, worstForce = 0.0;
    const double load = dynamics.grains().mass[0]*gravity*(light + ratio);
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        capped += !report.solve.converged;
        const bool isWithin = report.solve.residualRms <= settings.tolerance*report.solve.speedScale;
        silent += report.solve.converged && !isWithin;
        mostSweeps = std::max(mostSweeps, report.solve.sweeps);
        overlap = std::max(overlap, 2*report.overlapMax);
        worstForce = std::max(worstForce, std::abs(dynamics.wallForce()[0][2] + load)/load);
    }
    std::printf("S4: 1:%g on a stack of %d, cap %d, %d steps: %d at the cap, most sweeps %d, base force off by %.2g at worst, overlap %.2g r, top at %.6f of its height\n",
        ratio, light, maxSweeps, steps, capped, mostSweeps, worstForce, overlap,
        dynamics.grains().position.back()[2]/scene.grains.position.back()[2]);
    require("steps that claim convergence without it", silent, 0);
}

/// S16: a settled heap whose gravity is turned over, then sideways.
void gravityTurned()
{
    std::printf("S16: gravity turned over, then sideways\n");
    Scene scene = heap(3, 7, 8, radius, 0.7, 0.4);
    const double width = scene.walls.regions[2].point[0];
    scene.addPlane(Vec3(0, 0, 25*radius), -Vec3::UnitZ());
    auto dynamics = scene.build(nscd::ContactSettings());
    int outside = 0, unconverged = 0, steps = 0;
    double overlap = 0.0;
    for (const Vec3& g : {Vec3(0, 0, -gravity), Vec3(0, 0, gravity), Vec3(gravity, 0, 0)})
    {
        for (int k = 0; k < 600; ++k, ++steps)
        {
            const nscd::StepReport report = step(dynamics, g, deltaT);
            unconverged += !report.solve.converged;
            overlap = std::max(overlap, report.overlapMax);
        }
        for (const Vec3& x : dynamics.grains().position)
        {
            outside += !(x.minCoeff() > 0 && x[0] < width && x[1] < width && x[2] < 25*radius);
        }
    }
    require("grains outside", outside, 0);
    require("overlap, d", overlap, 1e-3);
    require("steps at the cap, share", double(unconverged)/steps, 0.01);
}

/// S22: 1000 spheres at solid fraction 0.5 with random velocities, e = 1; energy against momentum's account of it.
void denseElasticGas(double friction)
{
    Scene scene(3, friction, 1.0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = 2.03*radius;
    for (int k = 0; k < 1000; ++k)
    {
        const Vec3 place(k % 10 + 0.5, (k/10) % 10 + 0.5, k/100 + 0.5);
        scene.addGrain(spacing*place + 0.01*radius*Vec3(unit(random), unit(random), unit(random)), radius);
        scene.grains.velocity.back() = Vec3(unit(random), unit(random), unit(random));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(Vec3::Constant(10*spacing), -Vec3::Unit(axis));
    }
    auto dynamics = scene.build(tight());
    const double start = nscd::kineticEnergy(dynamics.grains());
    double before = start, gain = 0.0;
    for (int k = 0; k < 300; ++k)
    {
        step(dynamics, Vec3::Zero(), 1e-4);
        const double now = nscd::kineticEnergy(dynamics.grains());
        gain = std::max(gain, (now - before)/before);
        before = now;
    }
    std::printf("S22: dense elastic gas, mu %g: energy after 300 steps %.9f of the start\n", friction, before/start);
    require("largest gain of energy in a step, share", gain, friction > 0.0 ? 1e-3 : 1e-8);
    if (friction == 0.0) require("change of energy, share", std::abs(before/start - 1), 1e-6);
}

} // namespace

int main()
{
    heavyOnLight(1, 1e4, 1000, 1000);
    heavyOnLight(19, 1e2, 1000, 300);
    heavyOnLight(19, 1e2, 100000, 100);
    heavyOnLight(19, 1e4, 1000, 300);
    heavyOnLight(19, 1e4, 100000, 20);
    gravityTurned();
    denseElasticGas(0.0);
    denseElasticGas(0.5);
    return bars::status();
}
