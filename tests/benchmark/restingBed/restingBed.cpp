// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step of a bed at rest costs: all grains awake, then free to sleep. CSV.
// restingBed bed.dat [tilesX=1] [tilesY=1] [tolerance=1e-3] [steps=100] [warmUp=1000] [vectorPath=auto] [sleep=yes]: bed.dat as
// `rankedBed settle` wrote it. One tile comes to rest in the warm-up; copies of it, impulses and all, lie side by side.
#include "benchmark/rankedBed/tiledBed.hpp"
#include "unit/nscd/heaps.hpp"

#include <chrono>
#include <cstdio>
#include <map>

using namespace scenes;

namespace
{

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

constexpr int stepsSideBySide = 20;  // damped too

using Options = std::map<std::string, std::string>;

Options read(int argc, char** argv)
{
    Options options{{"tilesX", "1"}, {"tilesY", "1"}, {"tolerance", "1e-3"}, {"steps", "100"}, {"warmUp", "1000"},
                    {"vectorPath", "auto"}, {"sleep", "yes"}};
    for (int k = 2; k < argc; ++k)
    {
        const std::string word = argv[k];
        const std::size_t at = word.find('=');
        if (at == std::string::npos || options.find(word.substr(0, at)) == options.end()) throw std::invalid_argument("unknown option " + word);
        options[word.substr(0, at)] = word.substr(at + 1);
    }
    return options;
}

/// A bed, its impulses, and the length of the step that they are of.
struct State
{
    Scene scene;
    std::vector<nscd::StoredImpulse> impulses;
    double lastDeltaT = 0.0;
};

void calm(nscd::GrainDynamics& dynamics, int steps)
{
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
}

State stateOf(nscd::GrainDynamics& dynamics, Scene scene)
{
    scene.grains = dynamics.grains();
    double lastDeltaT = 0.0;
    std::vector<nscd::StoredImpulse> impulses = dynamics.checkpoint(lastDeltaT);
    return {std::move(scene), std::move(impulses), lastDeltaT};
}

/// Which tile, from that of a, an impulse's other grain is in: its image next to a.
Vec3 stepsToOther(const State& tile, const nscd::StoredImpulse& impulse)
{
    const Vec3 apart = tile.scene.grains.position[impulse.idA] - tile.scene.grains.position[impulse.idB], period = tile.scene.box.length;
    return Vec3(std::round(apart[0]/period[0]), std::round(apart[1]/period[1]), 0);
}

/// Copies of a bed side by side. Its grains are numbered as they lie in memory.
State sideBySide(const State& tile, int tilesX, int tilesY)
{
    const nscd::Grains& grains = tile.scene.grains;
    const Vec3 period = tile.scene.box.length;
    const auto n = static_cast<std::int64_t>(grains.size());
    State all{emptyBed(tilesX*period[0], tilesY*period[1]), {}, tile.lastDeltaT};
    for (int j = 0; j < tilesY; ++j)
    for (int i = 0; i < tilesX; ++i)
    {
        const std::int64_t first = n*(i + tilesX*j);
        for (std::size_t k = 0; k < grains.size(); ++k)
        {
            const std::size_t at = all.scene.grains.size();
            all.scene.grains.add(grains.position[k] + Vec3(i*period[0], j*period[1], 0), radius, density, 0, static_cast<std::int64_t>(at));
            all.scene.grains.velocity[at] = grains.velocity[k];
            all.scene.grains.omega[at] = grains.omega[k];
        }
        for (nscd::StoredImpulse impulse : tile.impulses)
        {
            if (impulse.idB >= 0)
            {
                const Vec3 steps = stepsToOther(tile, impulse);
                const int column = (i + static_cast<int>(steps[0]) + tilesX) % tilesX, row = (j + static_cast<int>(steps[1]) + tilesY) % tilesY;
                impulse.idB += n*(column + tilesX*row);
            }
            impulse.idA += first;
            all.impulses.push_back(impulse);
        }
    }
    return all;
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

void measureWindows(bool sleep, nscd::GrainDynamics& dynamics, int steps)
{
    for (int k = 0; k < 3; ++k) measure(sleep ? "may sleep" : "awake", dynamics, steps);
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
    nscd::ContactSettings settings;
    settings.tolerance = std::stod(o.at("tolerance"));
    settings.vectorPath = o.at("vectorPath");
    std::printf("what,grains,contacts,candidates,sweeps,listsBuilt,converged,msPerStep,nsPerGrain,findPairsMs,buildContactsMs,solveContactsMs,"
                "moveGrainsMs,kineticEnergy,asleep\n");
    const int steps = std::stoi(o.at("steps")), tilesX = std::stoi(o.at("tilesX")), tilesY = std::stoi(o.at("tilesY"));
    const Scene tile = TiledBed(argv[1], 1, 1).whole();
    for (const bool sleep : {false, true})
    {
        if (sleep && o.at("sleep") != "yes") break;
        settings.sleep = sleep;
        auto dynamics = tile.build(settings);
        calm(dynamics, std::stoi(o.at("warmUp")));
        if (tilesX*tilesY == 1)
        {
            measureWindows(sleep, dynamics, steps);
            continue;
        }
        const State all = sideBySide(stateOf(dynamics, tile), tilesX, tilesY);
        auto many = all.scene.build(settings);
        many.restore(all.impulses, all.lastDeltaT);
        calm(many, stepsSideBySide);
        measureWindows(sleep, many, steps);
    }
}
