// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A heap of 1000 clumps and some spheres between them in a box: it lands and comes to rest; laws and balances by code of its own.
// dryClumps [clumps=1000] [side=6] [steps=4000]
#include "unit/nscd/scenes/clumpMap.hpp"
#include "../resources/bars.hpp"

#include <cstdio>
#include <cstdlib>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, friction = 0.5;

double speed(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (const Vec3& v : grains.velocity) sum += v.squaredNorm();
    return std::sqrt(sum/grains.size());
}

void heapSettles(int clumps, int side, int steps)
{
    const Scene scene = clumpHeap(clumps, side, friction);
    const nscd::ContactSettings settings;
    auto dynamics = scene.build(settings);
    double diameter = 0.0;
    for (double r : dynamics.grains().radius) diameter += 2.0*r/dynamics.grains().size();
    ClumpJudge judge(scene, friction, settings.deadBand*diameter, deltaT);

    int capped = 0;
    double sweeps = 0.0, overlap = 0.0, worstMap = 0.0, worstImbalance = 0.0, momentumScale = 0.0;
    for (int k = 1; k <= steps; ++k)
    {
        const bool isJudged = k % 100 == 0;
        const nscd::Grains before = isJudged ? dynamics.grains() : nscd::Grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        capped += !report.solve.converged;
        sweeps += report.solve.sweeps;
        overlap = std::max(overlap, report.overlapMax);
        if (!isJudged) continue;
        const ClumpMap map = judge(before, dynamics);
        if (report.solve.converged) worstMap = std::max(worstMap, map.rms/report.solve.speedScale);
        worstImbalance = std::max(worstImbalance, map.imbalance);
        momentumScale = before.clumps.shapeOf(0).mass*gravity*deltaT;
        std::printf("step %5d: %6.1f sweeps a step, rms map %.2e g dt, %4d contacts, rms speed %.2e m/s, overlap max so far %.1e d\n",
            k, sweeps/100, map.rms/report.solve.speedScale, map.loaded, speed(dynamics.grains()), overlap);
        std::fflush(stdout);
        sweeps = 0.0;
    }
    const double weight = totalMass(dynamics.grains())*gravity;
    int outside = 0;
    for (const Vec3& x : dynamics.grains().position) outside += !(x.minCoeff() > 0.0 && x.head<2>().maxCoeff() < 5.0*side*memberRadius);
    Vec3 onWalls = Vec3::Zero();
    for (const Vec3& f : dynamics.wallForce()) onWalls += f;

    require("grains outside", outside, 0);
    require("rms natural map of converged steps, g dt", worstMap, 1.001*settings.tolerance);
    require("imbalance of any clump, weight dt", worstImbalance/momentumScale, 1e-9);
    require("overlap, d", overlap, 3e-3);
    require("steps at the cap, share", double(capped)/steps, 0.01);
    require("rms speed at the end, g dt", speed(dynamics.grains())/(gravity*deltaT), 1e-2);
    require("force on walls against weight, share", (onWalls + Vec3(0, 0, weight)).norm()/weight, 1e-3);
}

} // namespace

int main(int argc, char** argv)
{
    const int clumps = argc > 1 ? std::atoi(argv[1]) : 1000, side = argc > 2 ? std::atoi(argv[2]) : 6, steps = argc > 3 ? std::atoi(argv[3]) : 4000;
    std::printf("heap of %d clumps, %d steps of %g s\n", clumps, steps, deltaT);
    heapSettles(clumps, side, steps);
    return bars::status();
}
