// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What ranks cost and save: a bed with periodic sides settles once into a file; tiles of it are then solved on any number of ranks.
// mpirun -np 2 rankedBed settle bed.dat perSide layers steps
// mpirun -np N rankedBed run bed.dat tilesX tilesY steps [coldSolves [maxSweeps]]
// MESSAGE_COUNT_FILE names a CSV file for the messages of cold solves, warm steps and sharing out, part by part.
#include "benchmark/messageCount/messageCount.hpp"
#include "benchmark/rankedBed/tiledBed.hpp"
#include "parallel/rankedScene.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace scenes;

namespace
{

struct RunSettings
{
    int steps;
    int coldSolves = 10;  ///< over which the sweeps of a start without impulses are averaged: they scatter by a third
    nscd::ContactSettings contacts;
};
void settle(const char* path, int perSide, int layers, int steps)
{
    const Scene scene = latticeBed(perSide, layers);
    RankedScene run(scene, nscd::ContactSettings(), [](const Vec3&, std::int64_t) { return 0; });
    for (int k = 0; k < steps; ++k)
    {
        if (k % 20 == 0) run.repartition();
        const nscd::StepReport report = stepDamped(run.dynamics(), scene.g, deltaT);
        if (k % 20 == 0 && run.exchange().rank() == 0) std::printf("%d: %zu contacts, %d sweeps\n", k, report.solve.contacts, report.solve.sweeps);
    }
    const nscd::Grains all = run.gatherGrains();
    if (run.exchange().rank() > 0) return;
    writeBed(path, scene.box, all.position);
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void run(const TiledBed& tiles, const RunSettings& settings)
{
    int size = 1, rank = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    // First by number; then by place; then by load, which the list tells.
    const std::size_t share = tiles.size()/size + 1;
    const Scene scene = tiles.part(rank*share, (rank + 1)*share);
    RankedScene bed(scene, settings.contacts, [=](const Vec3&, std::int64_t) { return rank; });
    bed.repartition();
    bed.dynamics().beginStep(deltaT);
    bed.repartition();

    messageCount::reset();
    nscd::StepReport cold;
    double coldSweeps = 0.0;
    for (int k = 0; k < settings.coldSolves; ++k)
    {
        const messageCount::Part counted("cold");
        bed.dynamics().restore({}, deltaT);
        cold = step(bed.dynamics(), scene.g, deltaT);
        coldSweeps += double(cold.solve.sweeps)/settings.coldSolves;
    }
    for (int k = 0; k < settings.steps; ++k) step(bed.dynamics(), scene.g, deltaT);
    const nscd::Traffic before = bed.exchange().traffic();
    int sweeps = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    const double start = now();
    for (int k = 0; k < settings.steps; ++k)
    {
        const messageCount::Part counted("warm");
        sweeps += step(bed.dynamics(), scene.g, deltaT).solve.sweeps;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    const double seconds = now() - start;
    const nscd::Traffic& after = bed.exchange().traffic();
    double counts[2] = {double(after.messages - before.messages), double(after.bytes - before.bytes)};
    bed.exchange().sum(counts, 2);
    const int interface = bed.interfaceContacts();
    {
        const messageCount::Part counted("balance");
        bed.repartition();
    }
    double least = -static_cast<double>(bed.dynamics().grains().size());
    bed.exchange().max(&least, 1);
    if (bed.exchange().rank() > 0) return;
    std::printf("ranks,grains,leastOnARank,contacts,betweenRanks,coldSweeps,sweepsPerStep,msPerStep,usPerSweep,messagesPerRankAndSweep,"
                "kBPerRankAndSweep\n%d,%zu,%.0f,%zu,%d,%.1f,%.1f,%.2f,%.1f,%.2f,%.3f\n",
                size, tiles.size(), -least, cold.solve.contacts, interface, coldSweeps, double(sweeps)/settings.steps, 1e3*seconds/settings.steps,
                1e6*seconds/std::max(1, sweeps), counts[0]/size/std::max(1, sweeps), 1e-3*counts[1]/size/std::max(1, sweeps));
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const std::string what = argc >= 6 ? argv[1] : "";
    const auto number = [argv](int i) { return std::atoi(argv[i]); };
    RunSettings settings;
    settings.steps = argc > 5 ? number(5) : 0;
    if (argc > 6) settings.coldSolves = number(6);
    if (argc > 7) settings.contacts.maxSweeps = number(7);
    if (what == "settle") settle(argv[2], number(3), number(4), number(5));
    else if (what == "run") run(TiledBed(argv[2], number(3), number(4)), settings);
    else std::printf("rankedBed settle FILE PERSIDE LAYERS STEPS, or rankedBed run FILE TILESX TILESY STEPS [COLDSOLVES [MAXSWEEPS]]\n");
    MPI_Finalize();
    return what.empty();
}
