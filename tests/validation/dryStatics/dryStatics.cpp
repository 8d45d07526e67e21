// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Statics at length: A09 (a box of discs for 2000 steps), A08 with 1000 spheres, a hexagonal stack to 1e-8 g dt, and a bed
// of spheres that lands, comes to rest and stays there at the default settings.
#include "unit/nscd/scenes/heaps.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"
#include "../resources/bars.hpp"

#include "nscd/base/formattedText.hpp"

#include <chrono>
#include <cstdio>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, radius = 0.01;

Vec3 wallForce(const nscd::GrainDynamics& dynamics)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& force : dynamics.wallForce()) sum += force;
    return sum;
}

double totalMass(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (double m : grains.mass) sum += m;
    return sum;
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What is asleep shows nothing of the solver.
nscd::ContactSettings awake()
{
    nscd::ContactSettings settings;
    settings.sleep = false;
    return settings;
}

nscd::ContactSettings settings(double tolerance)
{
    nscd::ContactSettings settings = awake();
    settings.tolerance = settings.displacementTolerance = tolerance;
    settings.maxSweeps = 100000;
    return settings;
}

/// A09: settles at the default settings, at last in a viscous medium, then holds for 2000 steps at 1e-8 g dt. One packing in three
/// or four holds a contact that takes some 30 sweeps a step, so that sweeps are told of several and not of a chosen one.
void boxOfDiscs(double smallest)
{
    bars::scene(nscd::formatted("A09 500 discs, the smallest %g of the largest, settled, then 2000 steps", smallest));
    Scene scene = heap(2, 20, 25, radius, smallest, 0.5);
    auto settling = scene.build(awake());
    for (int k = 0; k < 2000; ++k) step(settling, scene.g, deltaT);
    for (int k = 0; k < 1000; ++k) stepDamped(settling, scene.g, deltaT);
    scene.grains = settling.grains();
    double lastDeltaT = 0.0;
    const std::vector<nscd::StoredImpulse> impulses = settling.checkpoint(lastDeltaT);
    auto dynamics = scene.build(settings(1e-8));
    dynamics.restore(impulses, lastDeltaT);
    for (int k = 0; k < 1000; ++k) step(dynamics, scene.g, deltaT);

    const Vec3 before = nscd::massCenter(dynamics.grains());
    const double load = totalMass(scene.grains)*gravity;
    double balance = 0.0;
    int sweeps = 0;
    for (int k = 0; k < 2000; ++k)
    {
        sweeps += step(dynamics, scene.g, deltaT).solve.sweeps;
        balance = std::max(balance, (wallForce(dynamics) - totalMass(scene.grains)*scene.g).norm()/load);
    }
    const double unit = load*2*radius/scene.grains.size();
    require("floor and walls against weight, worst step", balance, 1e-6);
    require("kinetic energy, m g d", nscd::kineticEnergy(dynamics.grains())/unit, 1e-12);
    require("creep of the mass center per 1000 steps, d", 0.5*(nscd::massCenter(dynamics.grains()) - before).norm()/(2*radius), 1e-7);
    require("sweeps a step", sweeps/2000.0, 40.0);
}

/// A08 and S5: N spheres from cold; error of the impulses in N m g dt.
void tallStack(int grains, double bar)
{
    Scene scene(3, 0.5, 0.0);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(0, 0, radius*(2*i + 1)), radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    nscd::ContactSettings tightest = settings(1e-12);
    tightest.maxSweeps = 1000000;
    auto dynamics = scene.build(tightest);
    const auto start = std::chrono::steady_clock::now();
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    const double unit = dynamics.grains().mass[0]*gravity*deltaT;
    double worst = 0.0;
    for (const nscd::LoadedContact& c : dynamics.contacts())
    {
        const int lower = c.b < 0 ? 0 : std::max(c.a, c.b);
        worst = std::max(worst, std::abs(c.impulse.norm()/unit - (grains - lower))/grains);
    }
    bars::scene(nscd::formatted("A08 stack of %d from cold", grains));
    std::printf("  %d sweeps, %.2f s, %s\n", report.solve.sweeps, secondsSince(start), report.solve.converged ? "converged" : "at the cap");
    require("impulses, N m g dt", worst, bar);
}

/// Hexagonal stack of 20 x 100 discs from cold to an absolute natural map of 1e-8 g dt.
void hexagonalStack()
{
    Scene scene(2, 0.5, 0.0);
    for (int row = 0; row < 100; ++row)
    {
        for (int i = 0; i < 20 - row % 2; ++i)
        {
            scene.addGrain(Vec3(radius*(2*i + 1 + row % 2), 0, radius*(1 + std::sqrt(3.0)*row)), radius);
        }
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(40*radius, 0, 0), -Vec3::UnitX());
    const nscd::ContactSettings tightest = settings(1e-8);
    auto dynamics = scene.build(tightest);
    const auto start = std::chrono::steady_clock::now();
    const nscd::StepReport report = step(dynamics, scene.g, deltaT);
    bars::scene("Hexagonal stack 20 x 100 from cold");
    std::printf("  %d sweeps, %.2f s\n", report.solve.sweeps, secondsSince(start));
    Judge judge(scene, 0.5, tightest.deadBand*2*radius, deltaT);
    require("natural map by other code, rms, g dt", judge(scene.grains, dynamics).rms/(gravity*deltaT), 1e-8);
    const Vec3 load = totalMass(scene.grains)*scene.g;
    require("base force against weight", (wallForce(dynamics) - load).norm()/load.norm(), 1e-6);
}

/// A bed of spheres at the default settings: 2 s to land and rest, then figures of 1000 steps.
void bedOfSpheres()
{
    const Scene scene = heap(3, 12, 14, radius, 0.8, 0.4);
    auto dynamics = scene.build(awake());
    int capped = 0;
    double overlapMax = 0.0, overlapMean = 0.0;
    for (int k = 0; k < 2000; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        capped += !report.solve.converged;
        overlapMax = std::max(overlapMax, report.overlapMax);
        overlapMean = std::max(overlapMean, report.overlapMean);
    }
    bars::scene(nscd::formatted("Bed of %zu spheres at the default settings: landing", scene.grains.size()));
    require("steps at the cap, share", capped/2000.0, 0.01);
    require("overlap, largest, d", overlapMax, 1e-3);
    require("overlap, mean of the worst step, d", overlapMean, 1e-4);

    int rolling = 0;
    for (int k = 0; k < 500; ++k) rolling += step(dynamics, scene.g, deltaT).solve.sweeps;
    std::printf("  while the last grains roll: %.2f sweeps a step\n", rolling/500.0);
    for (int k = 0; k < 4000; ++k) stepDamped(dynamics, scene.g, deltaT);
    bars::scene("And, once a viscous medium has stopped those, 1000 steps at rest without it");
    const nscd::Grains before = dynamics.grains();
    int sweeps = 0, corrections = 0;
    for (int k = 0; k < 1000; ++k)
    {
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        sweeps += report.solve.sweeps;
        corrections += report.correctionSweeps > 0;
    }
    std::vector<double> moved;
    for (std::size_t i = 0; i < before.size(); ++i) moved.push_back((dynamics.grains().position[i] - before.position[i]).norm()/(2*radius));
    std::sort(moved.begin(), moved.end());
    const Vec3 load = totalMass(scene.grains)*scene.g;
    require("sweeps a step", sweeps/1000.0, 3.0);
    require("steps with overlap corrected", corrections, 0);
    require("base force against weight", (wallForce(dynamics) - load).norm()/load.norm(), 1e-4);
    require("creep, median grain, d per 1000 steps", moved[moved.size()/2], 1e-7);
    require("creep, worst grain, d per 1000 steps", moved.back(), 1e-5);
    require("kinetic energy, m g d a grain", nscd::kineticEnergy(dynamics.grains())/(load.norm()*2*radius), 1e-12);
}

} // namespace

int main()
{
    for (double smallest : {0.6, 0.65, 0.7}) boxOfDiscs(smallest);
    for (int grains : {100, 1000}) tallStack(grains, 1e-6);
    hexagonalStack();
    bedOfSpheres();
    return bars::status();
}
