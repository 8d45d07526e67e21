// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tall stacks from cold (A08, S5): base force of the first step and rest after it, at the default solver; with 1000 spheres, a zig-zag wall
// of 3 x 300 discs and a hexagonal stack of 20 x 200 discs.
#include "unit/nscd/scenes/naturalMap.hpp"
#include "../resources/bars.hpp"

#include "nscd/base/formattedText.hpp"

#include <cstdio>
#include <ctime>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

double cpuSeconds() { return static_cast<double>(std::clock())/CLOCKS_PER_SEC; }

double baseForceError(const Scene& scene, const nscd::GrainDynamics& dynamics)
{
    Vec3 load = Vec3::Zero(), base = Vec3::Zero();
    for (double m : scene.grains.mass) load += m*scene.g;
    for (const Vec3& force : dynamics.wallForce()) base += force;
    return (base - load).norm()/load.norm();
}

double top(const nscd::Grains& grains)
{
    double height = 0.0;
    for (const Vec3& x : grains.position) height = std::max(height, x[2]);
    return height;
}

/// One step from cold, then `steps` more.
void coldThenRest(const char* name, const Scene& scene, const nscd::ContactSettings& settings, int steps)
{
    auto dynamics = scene.build(settings);
    const double start = cpuSeconds();
    const nscd::StepReport first = step(dynamics, scene.g, deltaT);
    const double cold = cpuSeconds() - start;
    bars::scene(name);
    std::printf("  first step %d sweeps, %d Newton steps, %.2f s, %s\n", first.solve.sweeps, first.solve.newtonSteps, cold, first.solve.converged ? "converged" : "at the cap");
    require("base force against weight, first step", baseForceError(scene, dynamics), 1e-4);
    double worst = 0.0;
    int sweeps = 0, newtonSteps = 0, capped = 0;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        sweeps += report.solve.sweeps;
        newtonSteps += report.solve.newtonSteps;
        capped += !report.solve.converged;
        worst = std::max(worst, baseForceError(scene, dynamics));
    }
    std::printf("  %d steps more: %.2f sweeps and %.2f Newton steps a step, %.2f s in all\n", steps, double(sweeps)/steps, double(newtonSteps)/steps, cpuSeconds() - start);
    const double unit = scene.grains.mass[0]*gravity*2*radius;
    require("base force against weight, worst step", worst, 1e-4);
    require("steps at the cap", capped, 0);
    require("kinetic energy, m g d", nscd::kineticEnergy(dynamics.grains())/unit, 1e-10);
    require("change of the top's height, share", std::abs(top(dynamics.grains())/top(scene.grains) - 1.0), 1e-3);
}

Scene stack(int grains)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

/// Columns of discs whose rows are shifted by turns, held by side walls.
Scene zigZagWall(int columns, int rows)
{
    const double rise = 1.9*radius, shift = std::sqrt(4*radius*radius - rise*rise);
    Scene scene(2, 0.5, 0.0);
    for (int row = 0; row < rows; ++row)
    {
        for (int column = 0; column < columns; ++column)
        {
            scene.addGrain(Vec3(radius*(2*column + 1) + (row % 2)*shift, 0, radius + rise*row), radius);
        }
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(2*columns*radius + shift, 0, 0), -Vec3::UnitX());
    return scene;
}

Scene hexagonalStack(int perRow, int rows)
{
    Scene scene(2, 0.5, 0.0);
    for (int row = 0; row < rows; ++row)
    {
        for (int i = 0; i < perRow - row % 2; ++i)
        {
            scene.addGrain(Vec3(radius*(2*i + 1 + row % 2), 0, radius*(1 + std::sqrt(3.0)*row)), radius);
        }
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(2*perRow*radius, 0, 0), -Vec3::UnitX());
    return scene;
}

/// S4 within a stack: a sphere 1e4 times heavier on 19 light ones, at the default settings.
void heavyOnStack(double ratio, int steps)
{
    Scene scene = stack(20);
    scene.grains.mass.back() *= ratio;
    auto dynamics = scene.build(nscd::ContactSettings());
    double worst = 0.0;
    int newtonSteps = 0, unconverged = 0, hidden = 0;
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        worst = std::max(worst, baseForceError(scene, dynamics));
        newtonSteps += report.solve.newtonSteps;
        unconverged += !report.solve.converged;
        hidden += report.solve.hiddenMassRatio > 0.0;
    }
    bars::scene(nscd::formatted("S4 1:%g on a stack of 19, default settings", ratio));
    std::printf("  %d steps: %.2f Newton steps a step\n", steps, double(newtonSteps)/steps);
    require("base force against weight, worst step", worst, 1e-3);
    require("steps not converged, or that warn of hidden forces", unconverged + hidden, 0);
}

} // namespace

int main()
{
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-8;
    coldThenRest("A08 stack of 1000", stack(1000), settings, 20);
    coldThenRest("S5 zig-zag wall 3 x 300", zigZagWall(3, 300), settings, 300);
    settings.maxSweeps = 3000;  // the wedges of such a stack take more than the default cap of 1000 to this tolerance
    coldThenRest("S5 hexagonal stack 20 x 200", hexagonalStack(20, 200), settings, 100);
    settings.maxSweeps = nscd::ContactSettings().maxSweeps;
    settings.deadBand *= 0.1;
    coldThenRest("A08 stack of 1000 at a tenth of the dead band", stack(1000), settings, 20);
    for (double ratio : {1e2, 1e3, 1e4}) heavyOnStack(ratio, 300);
    return bars::status();
}
