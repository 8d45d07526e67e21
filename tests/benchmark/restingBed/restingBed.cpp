// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step of a bed at rest costs: all grains awake, then free to sleep. CSV.
// restingBed bed.dat [tilesX=1] [tilesY=1] [tolerance=1e-3] [steps=100] [warmUp=1000] [calm=600] [vectorPath=auto] [sleep=yes]: bed.dat as
// `rankedBed settle` wrote it. One tile comes to rest in `warmUp` damped steps; tilesX*tilesY copies of it, impulses and all, then lie side by side for
// `calm` damped steps more: their contacts are found anew.
#include "benchmark/partColumns.hpp"
#include "benchmark/rankedBed/tiledBed.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include <array>
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
    Options options{{"tilesX", "1"}, {"tilesY", "1"}, {"tolerance", "1e-3"}, {"steps", "100"}, {"warmUp", "1000"},
                    {"calm", "600"}, {"vectorPath", "auto"}, {"sleep", "yes"}};
    for (int k = 2; k < argc; ++k)
    {
        const std::string word = argv[k];
        const std::size_t at = word.find('=');
        if (at == std::string::npos || options.find(word.substr(0, at)) == options.end()) throw std::invalid_argument("unknown option " + word);
        options[word.substr(0, at)] = word.substr(at + 1);
    }
    return options;
}

/// Impulses, and the length of the step that they are of.
struct Impulses
{
    std::vector<nscd::StoredImpulse> all;
    double deltaT = 0.0;
};

void calm(nscd::GrainDynamics& dynamics, int steps)
{
    for (int k = 0; k < steps; ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
}

/// Lets one tile come to rest, and the bed's tile lie as it does then. Returns its impulses.
Impulses settle(TiledBed& bed, const nscd::ContactSettings& settings, int steps)
{
    TiledBed one = bed;
    one.tilesX = one.tilesY = 1;
    auto dynamics = one.whole().build(settings);
    calm(dynamics, steps);
    bed.tile = dynamics.grains().position;
    Impulses impulses;
    impulses.all = dynamics.checkpoint(impulses.deltaT);
    return impulses;
}

/// How many tiles away, from that of a, an impulse's other grain is: its image next to a.
std::array<int, 2> tilesToOther(const TiledBed& bed, const nscd::StoredImpulse& impulse)
{
    const Vec3 apart = bed.tile[impulse.idA] - bed.tile[impulse.idB];
    return {static_cast<int>(std::round(apart[0]/bed.width)), static_cast<int>(std::round(apart[1]/bed.depth))};
}

/// A tile's impulses in all tiles, whose grains are numbered one tile after the other.
Impulses tiled(const Impulses& tile, const TiledBed& bed)
{
    const auto n = static_cast<std::int64_t>(bed.tile.size());
    Impulses impulses{{}, tile.deltaT};
    for (int j = 0; j < bed.tilesY; ++j)
    for (int i = 0; i < bed.tilesX; ++i)
    for (nscd::StoredImpulse impulse : tile.all)
    {
        if (impulse.idB >= 0)
        {
            const auto [right, up] = tilesToOther(bed, impulse);
            const int column = (i + right + bed.tilesX) % bed.tilesX, row = (j + up + bed.tilesY) % bed.tilesY;
            impulse.idB += n*(column + bed.tilesX*row);
        }
        impulse.idA += n*(i + bed.tilesX*j);
        impulses.all.push_back(impulse);
    }
    return impulses;
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
    const double grains = static_cast<double>(dynamics.grains().size());
    std::printf("%s,%.0f,%zu,%zu,%.2f,%.0f,%d,%.3f,%.1f,%s,%.1e,%zu\n", name, grains, means.last.solve.contacts, means.last.candidates,
                means.sweeps/steps, means.rebuilt, means.last.solve.converged, total, 1e6*total/grains, partColumns(dynamics.times().since(from), steps).c_str(),
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
    nscd::ContactSettings settings;
    settings.tolerance = std::stod(o.at("tolerance"));
    settings.vectorPath = o.at("vectorPath");
    std::printf("what,grains,contacts,candidates,sweeps,listsBuilt,converged,msPerStep,nsPerGrain,%s,kineticEnergy,asleep\n", partHead().c_str());
    TiledBed bed(argv[1], std::stoi(o.at("tilesX")), std::stoi(o.at("tilesY")));
    settings.sleep = false;
    const Impulses impulses = tiled(settle(bed, settings, std::stoi(o.at("warmUp"))), bed);
    for (const bool sleep : {false, true})
    {
        if (sleep && o.at("sleep") != "yes") break;
        settings.sleep = sleep;
        auto dynamics = bed.whole().build(settings);
        dynamics.restore(impulses.all, impulses.deltaT);
        calm(dynamics, std::stoi(o.at("calm")));
        for (int k = 0; k < 3; ++k) measure(sleep ? "may sleep" : "awake", dynamics, std::stoi(o.at("steps")));
    }
}
