// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Whether a narrow settled bed with periodic sides stays at rest, for caps of sweeps, tolerances and time steps, as CSV.
// stabilityMap layers steps caps tolerances dts     lists with commas
// Each point starts from the same grains at rest and their impulses; for ten steps they weigh a tenth more. Figures are of the second half
// of the steps: kinetic energy per grain (m g d), worst base force and its mean (of the weight), change of the mass center's height
// (d; from before the first step), steps that ended at the cap, sweeps a step.
#include "benchmark/coldSolve/frozenBed.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

using namespace scenes;

namespace
{

constexpr int perSide = 5;
constexpr int heavySteps = 10;
constexpr double heavier = 1.1;

std::vector<double> numbers(const char* list)
{
    std::vector<double> values;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) values.push_back(std::atof(word.c_str()));
    return values;
}

struct Point
{
    int cap;
    double tolerance;
    double deltaT;
};

struct Rest
{
    double energy = 0.0;       ///< largest
    double baseError = 0.0;    ///< largest
    double baseMean = 0.0;
    double sunk = 0.0;
    int capped = 0;
    double sweeps = 0.0;
};

nscd::ContactSettings settingsOf(const Point& point)
{
    nscd::ContactSettings settings;
    settings.displacementTolerance *= point.tolerance/settings.tolerance;
    settings.tolerance = point.tolerance;
    settings.maxSweeps = point.cap;
    settings.sleep = false;
    return settings;
}

/// A bed at rest, and the impulses that hold it there.
struct RestingBed
{
    Scene scene;
    std::vector<nscd::StoredImpulse> impulses;
    double deltaT;
};

RestingBed comeToRest(Scene scene)
{
    constexpr int steps = 300;
    auto dynamics = scene.build(settingsOf({1000, 1e-3, deltaT}));
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, scene.g, deltaT);
    RestingBed bed{std::move(scene), {}, 0.0};
    bed.impulses = dynamics.checkpoint(bed.deltaT);
    bed.scene.grains = dynamics.grains();
    return bed;
}

Rest stayAtRest(const RestingBed& bed, const Point& point, int steps)
{
    const Scene& scene = bed.scene;
    nscd::ContactSettings settings = settingsOf(point);
    auto dynamics = scene.build(settings);
    dynamics.restore(bed.impulses, bed.deltaT);
    double weight = 0.0;
    for (double m : scene.grains.mass) weight += m*gravity;
    const double height = nscd::massCenter(dynamics.grains())[2];
    const int half = steps/2;
    Rest rest;
    for (int k = 0; k < 2*half; ++k)
    {
        const nscd::StepReport report = step(dynamics, (k < heavySteps ? heavier : 1.0)*scene.g, point.deltaT);
        if (k < half) continue;
        const double base = -dynamics.wallForce()[0][2]/weight;
        rest.energy = std::max(rest.energy, nscd::kineticEnergy(dynamics.grains())/(weight*2.0*radius));
        rest.baseError = std::max(rest.baseError, std::abs(base - 1.0));
        rest.baseMean += base/half;
        rest.capped += !report.solve.converged;
        rest.sweeps += static_cast<double>(report.solve.sweeps)/half;
    }
    rest.sunk = (height - nscd::massCenter(dynamics.grains())[2])/(2.0*radius);
    return rest;
}

Scene settledBed(const char* layers)
{
    const std::string path = "bed" + std::to_string(perSide) + "x" + layers + ".dat";
    if (!std::ifstream(path)) settleBed(path, perSide, std::atoi(layers), 2000);
    return TiledBed(path, 1, 1).whole();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 6)
    {
        std::printf("stabilityMap LAYERS STEPS CAPS TOLERANCES DTS\n");
        return 1;
    }
    const RestingBed bed = comeToRest(settledBed(argv[1]));
    std::printf("layers,cap,tolerance,deltaT,energy,baseError,baseMean,sunk,capped,sweeps\n");
    for (const double cap : numbers(argv[3]))
    for (const double tolerance : numbers(argv[4]))
    for (const double deltaT : numbers(argv[5]))
    {
        const Rest rest = stayAtRest(bed, {static_cast<int>(cap), tolerance, deltaT}, std::atoi(argv[2]));
        std::printf("%s,%g,%g,%g,%.3g,%.3g,%.5f,%.3g,%d,%.1f\n", argv[1], cap, tolerance, deltaT, rest.energy, rest.baseError, rest.baseMean,
            rest.sunk, rest.capped, rest.sweeps);
        std::fflush(stdout);
    }
    return 0;
}
