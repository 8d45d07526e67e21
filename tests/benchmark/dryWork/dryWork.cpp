// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Runs a dry scene that peers/plainScene.py wrote and leaves its grains at some times: our side of W1, W3, W4 and W12.
// dryWork SCENE OUT TIMES [option=value ...]     TIMES t1,t2,... [s]; OUT.1, OUT.2, ...: rows x y z, velocity, spin
// It prints one row of CSV; seconds are those of the steps, without reading and building.
#include "benchmark/dryWork/plainScene.hpp"
#include "benchmark/timedSteps.hpp"

#include <cmath>
#include <cstdio>

using namespace scenes;

namespace
{

void step(nscd::GrainDynamics& dynamics, const Vec3& g, double deltaT, TimedSteps& totals)
{
    const double start = processorTime();
    const nscd::StepReport report = scenes::step(dynamics, g, deltaT);
    totals.add(report, processorTime() - start);
}

void print(const TimedSteps& t)
{
    std::printf("steps,seconds,sweeps,contacts,capped,overlapMax,overlapMean\n%d,%.6f,%.3f,%.1f,%d,%.3e,%.3e\n", t.steps, t.seconds, t.sweeps/t.steps,
                t.contacts/t.steps, t.capped, t.overlapMax, t.overlapMean);
}

void writeGrains(const std::string& path, const nscd::Grains& grains)
{
    std::ofstream file(path);
    file.precision(12);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        file << grains.position[i].transpose() << " " << grains.velocity[i].transpose() << " " << grains.omega[i].transpose() << "\n";
    }
}

/// From time to time in equal steps, as near to deltaT as they can be.
void run(nscd::GrainDynamics& dynamics, const Vec3& g, const std::string& out, const std::vector<double>& times, const RunOptions& options)
{
    double time = 0.0;
    for (int k = 0; k < options.warmUp; ++k) scenes::step(dynamics, g, options.deltaT);
    TimedSteps totals;
    for (std::size_t k = 0; k < times.size(); ++k)
    {
        const int steps = std::max(1, static_cast<int>(std::lround((times[k] - time)/options.deltaT)));
        for (int n = 0; n < steps; ++n) step(dynamics, g, (times[k] - time)/steps, totals);
        time = times[k];
        writeGrains(out + "." + std::to_string(k + 1), dynamics.grains());
    }
    print(totals);
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        if (argc < 4) throw std::invalid_argument("dryWork SCENE OUT TIMES [option=value ...]");
        const Scene scene = readPlainScene(argv[1]);
        const RunOptions options = readOptions(argc, argv, 4);
        nscd::GrainDynamics dynamics = scene.build(options.contacts);
        run(dynamics, scene.g, argv[2], numbersOf(argv[3]), options);
        return 0;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "dryWork: %s\n", error.what());
        return 1;
    }
}
