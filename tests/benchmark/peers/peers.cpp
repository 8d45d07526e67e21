// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Our side of the comparison with other solvers; each call prints CSV. Scenes (bed, box, collapse) are in columnScene.hpp.
// peers settle SCENE BED STATE [option=value ...]          a bed of `rankedBed settle` comes to rest in the scene: a state
// peers run SCENE BED STATE [option=value ...]             runs on from a state; a row, and with `out` a state, every `every` seconds
// peers window SCENE BED STATE [option=value ...]          processor time of some steps from a state
// peers table STATE FILE                                   grains of a state: x y z, velocity, spin
// peers figures SCENE BED FILE                             overlaps, mass center and run-out of grains in a table
// peers frozen BED FILE [option=value ...]                 cold solves of a frozen contact problem; FILE.bodies, FILE.contacts: the last one
#include "benchmark/partColumns.hpp"
#include "benchmark/peers/columnScene.hpp"
#include "benchmark/peers/frozenProblem.hpp"
#include "benchmark/timedSteps.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include <cstdio>
#include <map>

using namespace scenes;

namespace
{

using Options = std::map<std::string, std::string>;

Options read(int argc, char** argv, int first)
{
    const nscd::ContactSettings s;
    Options options{{"deltaT", "1e-3"}, {"tolerance", std::to_string(s.tolerance)}, {"displacementTolerance", std::to_string(s.displacementTolerance)}, {"forceTolerance", std::to_string(s.forceTolerance)},
                    {"overlapTolerance", std::to_string(s.overlapTolerance)}, {"maxSweeps", std::to_string(s.maxSweeps)}, {"skin", std::to_string(s.skin)},
                    {"sleep", "0"}, {"steps", "20"}, {"warmUp", "2"}, {"time", "0.4"}, {"every", "0.01"}, {"out", ""}, {"solver", s.solver},
                    {"vectorPath", s.vectorPath}, {"samples", "5"}, {"restitution", "0"}, {"polishSweeps", std::to_string(s.polishSweeps)}};
    for (int k = first; k < argc; ++k)
    {
        const std::string word = argv[k];
        const std::size_t at = word.find('=');
        if (at == std::string::npos || options.find(word.substr(0, at)) == options.end()) throw std::invalid_argument("unknown option " + word);
        options[word.substr(0, at)] = word.substr(at + 1);
    }
    return options;
}

double number(const Options& options, const char* name) { return std::stod(options.at(name)); }

nscd::ContactSettings settingsOf(const Options& o)
{
    nscd::ContactSettings settings;
    settings.tolerance = number(o, "tolerance");
    settings.displacementTolerance = number(o, "displacementTolerance");
    settings.forceTolerance = number(o, "forceTolerance");
    settings.overlapTolerance = number(o, "overlapTolerance");
    settings.maxSweeps = int(number(o, "maxSweeps"));
    settings.polishSweeps = int(number(o, "polishSweeps"));
    settings.skin = number(o, "skin");
    settings.sleep = number(o, "sleep") != 0;
    settings.solver = o.at("solver");
    settings.vectorPath = o.at("vectorPath");
    return settings;
}

/// A scene with the grains of a state, and its dynamics as they went on from there.
struct Run
{
    Scene scene;
    nscd::GrainDynamics dynamics;
    double time;

    Run(const std::string& kind, const TiledBed& bed, const nscd::SceneState& state, const Options& options)
    :
        scene(columnScene(kind, bed.width, bed.depth, number(options, "restitution"))),
        dynamics(state.grains, scene.materials, scene.walls, scene.box, settingsOf(options)),
        time(state.time)
    {
        if (state.lastDeltaT > 0.0) dynamics.restore(state.impulses, state.lastDeltaT);
    }
};

/// Some steps, and what is of the last of them.
struct Interval : TimedSteps
{
    std::size_t asleep = 0;
    int lists = 0, corrections = 0;
    nscd::StepTimes from, to;  ///< of the clock

    void step(Run& run, double deltaT)
    {
        const nscd::ExternalForces forces = weight(run.dynamics.grains(), run.scene.g, deltaT);
        if (steps == 0) from = run.dynamics.times();
        const double start = processorTime();
        run.dynamics.beginStep(deltaT);
        const nscd::StepReport report = run.dynamics.advance(forces);
        add(report, processorTime() - start);
        run.time += deltaT;
        asleep = report.asleep;
        lists += report.listRebuilt;
        corrections += report.correctionSweeps;
        to = run.dynamics.times();
    }
};

void printHead()
{
    std::printf("time,steps,secondsPerSecond,msPerStep,sweeps,contacts,capped,overlapMaxReported,overlapMeanReported,asleep,overlapMax,overlapMean,"
                "centerX,centerZ,runOut99,runOut90,kineticEnergy,%s,listsInStep,correctionSweeps\n", partHead().c_str());
}

void print(const Interval& interval, const Run& run, double deltaT)
{
    const ColumnFigures now = columnFigures(run.scene, run.dynamics.grains());
    const double n = interval.steps;
    std::printf("%.9g,%d,%.4f,%.4f,%.2f,%.0f,%d,%.3e,%.3e,%zu,%.3e,%.3e,%.8g,%.8g,%.8g,%.8g,%.4e,%s,%d,%.1f\n", run.time, interval.steps, interval.seconds/(n*deltaT),
                1e3*interval.seconds/n, interval.sweeps/n, interval.contacts/n, interval.capped, interval.overlapMax, interval.overlapMean,
                interval.asleep, now.overlapMax, now.overlapMean, now.massCenter[0], now.massCenter[2], now.runOut99, now.runOut90,
                nscd::kineticEnergy(run.dynamics.grains()), partColumns(interval.to.since(interval.from), n).c_str(), interval.lists, interval.corrections/n);
    std::fflush(stdout);
}

void settle(const std::string& kind, const TiledBed& bed, const std::string& path, const Options& o)
{
    const Scene scene = columnOfBed(kind, bed);
    auto dynamics = scene.build(settingsOf(o));
    const double deltaT = number(o, "deltaT");
    for (int k = 0; k < int(number(o, "steps")); ++k) stepDamped(dynamics, scene.g, deltaT);
    nscd::writeCheckpoint(path, nscd::takeState(dynamics, 0.0, 0));
    std::printf("kineticEnergy\n%.3e\n", nscd::kineticEnergy(dynamics.grains()));
}

void runOn(Run& run, const Options& o)
{
    const double deltaT = number(o, "deltaT");
    const int rows = int(std::lround(number(o, "time")/number(o, "every"))), stepsPerRow = int(std::lround(number(o, "every")/deltaT));
    printHead();
    for (int row = 1; row <= rows; ++row)
    {
        Interval interval;
        for (int k = 0; k < stepsPerRow; ++k) interval.step(run, deltaT);
        print(interval, run, deltaT);
        if (!o.at("out").empty()) nscd::writeCheckpoint(o.at("out") + std::to_string(row), nscd::takeState(run.dynamics, run.time, 0));
    }
}

void timeWindow(Run& run, const Options& o)
{
    const double deltaT = number(o, "deltaT");
    Interval start, interval;
    // What still rolls keeps those around it awake.
    const bool isDamped = number(o, "sleep") != 0;
    for (int k = 0; k < int(number(o, "warmUp")); ++k)
    {
        if (isDamped) stepDamped(run.dynamics, run.scene.g, deltaT);
        else start.step(run, deltaT);
    }
    for (int k = 0; k < int(number(o, "steps")); ++k) interval.step(run, deltaT);
    printHead();
    print(interval, run, deltaT);
}

void writeTable(const std::string& state, const char* path)
{
    const nscd::Grains grains = nscd::readCheckpoint(state).grains;
    std::ofstream file(path);
    file.precision(17);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        file << grains.position[i].transpose() << " " << grains.velocity[i].transpose() << " " << grains.omega[i].transpose() << "\n";
    }
}

void printFigures(const std::string& kind, const TiledBed& bed, const char* path)
{
    Scene scene = columnScene(kind, bed.width, bed.depth);
    std::ifstream file(path);
    std::string rest;
    for (Vec3 x; file >> x[0] >> x[1] >> x[2]; std::getline(file, rest)) scene.addGrain(x, radius, density);
    const ColumnFigures f = columnFigures(scene, scene.grains);
    std::printf("grains,overlapMax,overlapMean,centerX,centerZ,runOut99,runOut90\n%zu,%.3e,%.3e,%.8g,%.8g,%.8g,%.8g\n", scene.grains.size(),
                f.overlapMax, f.overlapMean, f.massCenter[0], f.massCenter[2], f.runOut99, f.runOut90);
}

void solveFrozen(const char* path, const std::string& out, const Options& o)
{
    FrozenBed bed(TiledBed(path, 1, 1).whole(), o.at("vectorPath").c_str());
    nscd::ContactSettings settings = settingsOf(o);
    settings.polishSweeps = 0;
    std::printf("sample,seconds,sweeps,converged,residualRms,residualMax,baseForce\n");
    for (int sample = 1; sample <= int(number(o, "samples")); ++sample)
    {
        nscd::ContactProblem problem = bed.start(sample);
        FrozenFiles files(out, problem, bed.list());
        const double start = processorTime();
        const nscd::SolveReport report = nscd::findContactSolver(settings.solver).solve(problem, settings);
        std::printf("%d,%.4f,%d,%d,%.3e,%.3e,%.4f\n", sample, processorTime() - start, report.sweeps, report.converged,
                    report.residualRms/report.speedScale, report.residualMax/report.speedScale, bed.baseForce());
        files.writeContacts(problem, bed.list());
    }
}

int call(const std::string& what, int argc, char** argv)
{
    if (what == "table" && argc == 4) writeTable(argv[2], argv[3]);
    else if (what == "figures" && argc == 5) printFigures(argv[2], TiledBed(argv[3], 1, 1), argv[4]);
    else if (what == "frozen" && argc >= 4) solveFrozen(argv[2], argv[3], read(argc, argv, 4));
    else if (what == "settle" && argc >= 5) settle(argv[2], TiledBed(argv[3], 1, 1), argv[4], read(argc, argv, 5));
    else if ((what == "run" || what == "window") && argc >= 5)
    {
        const Options o = read(argc, argv, 5);
        Run run(argv[2], TiledBed(argv[3], 1, 1), nscd::readCheckpoint(argv[4]), o);
        if (what == "run") runOn(run, o);
        else timeWindow(run, o);
    }
    else return 1;
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        if (argc > 1 && call(argv[1], argc, argv) == 0) return 0;
        std::printf("peers settle|run|window SCENE BED STATE [option=value ...] | table STATE FILE | figures SCENE BED FILE | frozen BED FILE [option=value ...]\n");
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "peers: %s\n", error.what());
    }
    return 1;
}
