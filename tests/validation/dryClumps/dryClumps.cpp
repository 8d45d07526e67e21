// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A heap of 1000 clumps and some spheres between them in a box: it lands and comes to rest; laws and balances by code of its own.
// dryClumps [clumps=1000] [side=6] [steps=4000]
#include "unit/nscd/scenes/clumpMap.hpp"
#include "../resources/bars.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3, friction = 0.5;

/// What sleep lets a clump be off by, in its m g dt: 1e-3 by its speed before its last step awake, as much by that after it, and 1e-3 by
/// what its load has changed by since. In spins, over the radius, 2 x 1.4e-3 and 1.8e-3 for the tetrapod, J = 1.4 M R^2 (GrainSleep, isSmall).
constexpr double sleepOff = 5e-3;

double speed(const nscd::Grains& grains)
{
    double sum = 0.0;
    for (const Vec3& v : grains.velocity) sum += v.squaredNorm();
    return std::sqrt(sum/grains.size());
}

/// Which a share of them does not exceed.
double speedOfMost(const nscd::Grains& grains, double share)
{
    std::vector<double> speeds;
    for (const Vec3& v : grains.velocity) speeds.push_back(v.norm());
    const auto bound = speeds.begin() + static_cast<std::ptrdiff_t>(share*(speeds.size() - 1.0));
    std::nth_element(speeds.begin(), bound, speeds.end());
    return *bound;
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
    double sweeps = 0.0, overlap = 0.0, worstMap = 0.0, worstImbalance = 0.0, worstAsleep = 0.0, momentumScale = 0.0;
    for (int k = 1; k <= steps; ++k)
    {
        const nscd::Grains before = dynamics.grains();
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        capped += !report.solve.converged;
        sweeps += report.solve.sweeps;
        overlap = std::max(overlap, report.overlapMax);
        const ClumpMap map = judge(before, dynamics);
        if (report.solve.converged) worstMap = std::max(worstMap, map.rms/report.solve.speedScale);
        worstImbalance = std::max(worstImbalance, map.imbalance);
        worstAsleep = std::max(worstAsleep, map.asleep);
        momentumScale = before.clumps.shapeOf(0).mass*gravity*deltaT;
        if (k % 100 != 0) continue;
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
    require("imbalance of any clump awake, weight dt", worstImbalance/momentumScale, 1e-9);
    require("imbalance of any clump asleep, its weight dt", worstAsleep, sleepOff);
    require("overlap, d", overlap, 3e-3);
    require("steps at the cap, share", double(capped)/steps, 0.01);
    // Spheres on the floor roll on, which nothing stops: in four runs from disturbed starts 5 to 9 of 3223 grains were faster than
    // 1e-3 g dt at the end, and the rms speed, 0.0065 to 0.023 g dt, was theirs.
    require("rms speed at the end, g dt", speed(dynamics.grains())/(gravity*deltaT), 5e-2);
    require("speed at the end of 99 % of the grains, g dt", speedOfMost(dynamics.grains(), 0.99)/(gravity*deltaT), 1e-3);
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
