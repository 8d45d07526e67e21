// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step of a bed at rest costs: all grains awake, then free to sleep. CSV.
// restingBed bed.dat [tilesX=1] [tilesY=1] [tolerance=1e-3] [steps=100] [warmUp=1000] [vectorPath=auto]: bed.dat as `rankedBed settle` wrote it.
#include "benchmark/rankedBed/tiledBed.hpp"
#include "unit/nscd/heaps.hpp"

#include <chrono>
#include <cstdio>
#include <map>

using namespace scenes;

namespace
{

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

using Options = std::map<std::string, std::string>;

Options read(int argc, char** argv)
{
    Options options{{"tilesX", "1"}, {"tilesY", "1"}, {"tolerance", "1e-3"}, {"steps", "100"}, {"warmUp", "1000"}, {"vectorPath", "auto"}};
    for (int k = 2; k < argc; ++k)
    {
        const std::string word = argv[k];
        const std::size_t at = word.find('=');
        if (at == std::string::npos || options.find(word.substr(0, at)) == options.end()) throw std::invalid_argument("unknown option " + word);
        options[word.substr(0, at)] = word.substr(at + 1);
    }
    return options;
}

struct Means
{
    int steps = 0;
    double sweeps = 0.0, rebuilt = 0.0;
    nscd::StepReport last;

    void add(const nscd::StepReport& report)
    {
        ++steps;
        sweeps += report.solve.sweeps;
        rebuilt += report.listRebuilt;
        last = report;
    }
};

/// Steps under the same forces; prints what each cost in the mean.
void measure(const char* name, nscd::GrainDynamics& dynamics, int steps)
{
    const nscd::ExternalForces forces = weight(dynamics.grains(), Vec3(0, 0, -gravity), deltaT);
    const nscd::StepTimes from = dynamics.times();
    Means means;
    const double start = now();
    for (int k = 0; k < steps; ++k)
    {
        dynamics.beginStep(deltaT);
        means.add(dynamics.advance(forces));
    }
    const double milli = 1e3/steps, total = milli*(now() - start);
    const nscd::StepTimes& to = dynamics.times();
    const double grains = static_cast<double>(dynamics.grains().size());
    std::printf("%s,%.0f,%zu,%zu,%.2f,%.0f,%d,%.3f,%.1f,%.3f,%.3f,%.3f,%.3f,%.1e,%zu\n", name, grains, means.last.solve.contacts, means.last.candidates,
                means.sweeps/steps, means.rebuilt, means.last.solve.converged, total, 1e6*total/grains, milli*(to.findPairs - from.findPairs),
                milli*(to.buildContacts - from.buildContacts), milli*(to.solveContacts - from.solveContacts), milli*(to.moveGrains - from.moveGrains),
                nscd::kineticEnergy(dynamics.grains()), means.last.asleep);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::printf("restingBed BED [option=value ...]\n");
        return 1;
    }
    const Options o = read(argc, argv);
    const TiledBed tiles(argv[1], std::stoi(o.at("tilesX")), std::stoi(o.at("tilesY")));
    nscd::ContactSettings settings;
    settings.tolerance = std::stod(o.at("tolerance"));
    settings.vectorPath = o.at("vectorPath");
    std::printf("what,grains,contacts,candidates,sweeps,listsBuilt,converged,msPerStep,nsPerGrain,findPairsMs,buildContactsMs,solveContactsMs,"
                "moveGrainsMs,kineticEnergy,asleep\n");
    for (const bool sleep : {false, true})
    {
        settings.sleep = sleep;
        auto dynamics = tiles.whole().build(settings);
        for (int k = 0; k < std::stoi(o.at("warmUp")); ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
        for (int k = 0; k < 3; ++k) measure(sleep ? "may sleep" : "awake", dynamics, std::stoi(o.at("steps")));
    }
}
