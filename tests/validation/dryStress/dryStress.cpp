// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Stress scenes too long for the unit tests: S4 (heavy on light), S16 (gravity turned over), S22 (dense elastic gas), and what
// a cap on the sweeps does to them: reported, never silent.
#include "unit/nscd/scenes/heaps.hpp"
#include "../resources/bars.hpp"

#include "nscd/scene/stepWarnings.hpp"

#include <algorithm>
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
    int capped = 0, mostSweeps = 0;
    double overlap = 0.0, worstForce = 0.0, worstConverged = 0.0;
    const double load = dynamics.grains().mass[0]*gravity*(light + ratio);
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        capped += !report.solve.converged;
        mostSweeps = std::max(mostSweeps, report.solve.sweeps);
        overlap = std::max(overlap, 2*report.overlapMax);
        const double forceOff = std::abs(dynamics.wallForce()[0][2] + load)/load;
        worstForce = std::max(worstForce, forceOff);
        if (report.solve.converged) worstConverged = std::max(worstConverged, forceOff);
    }
    std::printf("S4: 1:%g on a stack of %d, cap %d, %d steps: %d at the cap, most sweeps %d, base force off by %.2g at worst, overlap %.2g r, top at %.6f of its height\n",
        ratio, light, maxSweeps, steps, capped, mostSweeps, worstForce, overlap,
        dynamics.grains().position.back()[2]/scene.grains.position.back()[2]);
    require("base force of steps that say converged, off by", worstConverged, 0.02);
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

/// 1000 spheres at solid fraction 0.6 in a periodic box: 10 x 10 hexagonal rows in 10 layers, shaken, with random velocities.
Scene denseGas(double friction, double restitution)
{
    Scene scene(3, friction, restitution);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double a = 2*radius*std::cbrt(0.74048/0.6);  // to the nearest neighbors
    const Vec3 cell(a, 0.5*std::sqrt(3.0)*a, std::sqrt(2.0/3.0)*a);
    scene.box.length = 10*cell;
    for (int k = 0; k < 1000; ++k)
    {
        const int i = k % 10, row = (k/10) % 10, layer = k/100;
        const Vec3 place(i + 0.5*((row + layer) % 2), row + (layer % 2)/3.0, layer);
        const Vec3 shake(unit(random), unit(random), unit(random));
        scene.addGrain(scene.box.wrap(cell.cwiseProduct(place) + 0.25*(a - 2*radius)*shake), radius);
        scene.grains.velocity.back() = Vec3(unit(random), unit(random), unit(random));
    }
    return scene;
}

/// S22: a dense gas with restitution; its energy step by step, and what the reports say of it.
void denseElasticGas(double friction, double restitution, double gasDeltaT, const nscd::ContactSettings& settings)
{
    auto dynamics = denseGas(friction, restitution).build(settings);
    const double start = nscd::kineticEnergy(dynamics.grains());
    double before = start, unexplained = 0.0, workError = 0.0;
    int reported = 0, silent = 0;
    std::size_t contacts = 0;
    for (int k = 0; k < 300; ++k)
    {
        const nscd::SolveReport report = step(dynamics, Vec3::Zero(), gasDeltaT).solve;
        const double now = nscd::kineticEnergy(dynamics.grains()), change = now - before;
        const double excess = change - report.shockResidualWork - 1e-12*before;
        unexplained = std::max(unexplained, excess/before);
        workError = std::max(workError, std::abs(change - (report.hasGainedEnergy() ? 0.0 : report.shockWork))/before);
        reported += report.hasGainedEnergy();
        silent += report.hasGainedEnergy() && nscd::warning(report).empty();
        contacts = std::max(contacts, report.contacts);
        before = now;
    }
    std::printf("S22: 1000 spheres at 0.6, mu %g, e %g, dt %g, tolerance %g: energy after 300 steps %.9f of the start; at most %zu contacts; in %d steps Newton's law had to be limited\n",
        friction, restitution, gasDeltaT, settings.tolerance, before/start, contacts, reported);
    require("gain of energy beyond the residual's work, share of a step's", unexplained, 0);
    require("reported work against the change of energy, share", workError, 1e-9);
    require("steps limited without a word", silent, 0);
    if (friction == 0.0 && restitution == 1.0) require("change of energy, share", std::abs(before/start - 1), 1e-9);
    else require("energy at the end, share of the start", before/start, 1.0);
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
    for (double dt : {1e-4, 1e-3})
    {
        for (double friction : {0.0, 0.5}) denseElasticGas(friction, 1.0, dt, tight());
        denseElasticGas(0.0, 0.9, dt, tight());
        denseElasticGas(0.5, 1.0, dt, nscd::ContactSettings());
    }
    return bars::status();
}
