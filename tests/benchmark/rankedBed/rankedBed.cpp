// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What ranks cost and save: a bed with periodic sides settles once into a file; tiles of it are then solved on any number of ranks.
// mpirun -np 2 rankedBed settle bed.dat perSide layers steps
// mpirun -np N rankedBed run bed.dat tilesX tilesY steps
#include "parallel/rankedScene.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace scenes;

namespace
{

/// Over so many the sweeps of a start without impulses are averaged: they scatter by a third.
constexpr int coldSolves = 10;
constexpr double radius = 1.25e-3, deltaT = 1e-3, friction = 0.3;

Scene emptyBed(double width, double depth)
{
    Scene scene(3, friction, 0.0);
    scene.box.length = Vec3(width, depth, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

Scene lattice(int perSide, int layers)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = 2.2*radius;
    Scene scene = emptyBed(perSide*spacing, perSide*spacing);
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        const Vec3 shake = 0.09*radius*Vec3(unit(random), unit(random), unit(random));
        scene.addGrain(spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake, radius, 2526.0);
    }
    return scene;
}

void settle(const char* path, int perSide, int layers, int steps)
{
    const Scene scene = lattice(perSide, layers);
    RankedScene run(scene, nscd::ContactSettings(), [](const Vec3&, std::int64_t) { return 0; });
    for (int k = 0; k < steps; ++k)
    {
        if (k % 20 == 0) run.repartition();
        const nscd::StepReport report = stepDamped(run.dynamics(), scene.g, deltaT);
        if (k % 20 == 0 && run.exchange().rank() == 0) std::printf("%d: %zu contacts, %d sweeps\n", k, report.solve.contacts, report.solve.sweeps);
    }
    const nscd::Grains all = run.gatherGrains();
    if (run.exchange().rank() > 0) return;
    std::ofstream file(path);
    file.precision(17);
    file << scene.box.length[0] << " " << scene.box.length[1] << "\n";
    for (const Vec3& x : all.position) file << x.transpose() << "\n";
}

/// As many tiles of the bed side by side.
Scene tiled(const char* path, int tilesX, int tilesY)
{
    std::ifstream file(path);
    double width = 0.0, depth = 0.0;
    if (!(file >> width >> depth)) throw std::runtime_error(std::string("cannot read ") + path);
    std::vector<Vec3> tile;
    for (Vec3 x; file >> x[0] >> x[1] >> x[2];) tile.push_back(x);
    Scene scene = emptyBed(tilesX*width, tilesY*depth);
    for (int j = 0; j < tilesY; ++j)
    for (int i = 0; i < tilesX; ++i)
    {
        for (const Vec3& x : tile) scene.addGrain(x + Vec3(i*width, j*depth, 0), radius, 2526.0);
    }
    return scene;
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void run(const char* path, int tilesX, int tilesY, int steps)
{
    const Scene scene = tiled(path, tilesX, tilesY);
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    // First by number; then by place; then by load, which the list tells.
    const std::size_t share = scene.grains.size()/size + 1;
    RankedScene bed(scene, nscd::ContactSettings(), [=](const Vec3&, std::int64_t id) { return static_cast<int>(id/share); });
    bed.repartition();
    bed.dynamics().beginStep(deltaT);
    bed.repartition();

    nscd::StepReport cold;
    double coldSweeps = 0.0;
    for (int k = 0; k < coldSolves; ++k)
    {
        bed.dynamics().restore({}, deltaT);
        cold = step(bed.dynamics(), scene.g, deltaT);
        coldSweeps += double(cold.solve.sweeps)/coldSolves;
    }
    for (int k = 0; k < 5; ++k) step(bed.dynamics(), scene.g, deltaT);
    const nscd::Traffic before = bed.exchange().traffic();
    int sweeps = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    const double start = now();
    for (int k = 0; k < steps; ++k) sweeps += step(bed.dynamics(), scene.g, deltaT).solve.sweeps;
    MPI_Barrier(MPI_COMM_WORLD);
    const double seconds = now() - start;
    const nscd::Traffic& after = bed.exchange().traffic();
    double counts[2] = {double(after.messages - before.messages), double(after.bytes - before.bytes)};
    bed.exchange().sum(counts, 2);
    const int interface = bed.interfaceContacts();
    double least = -static_cast<double>(bed.dynamics().grains().size());
    bed.exchange().max(&least, 1);
    if (bed.exchange().rank() > 0) return;
    std::printf("ranks,grains,leastOnARank,contacts,betweenRanks,coldSweeps,sweepsPerStep,msPerStep,usPerSweep,messagesPerRankAndSweep,"
                "kBPerRankAndSweep\n%d,%zu,%.0f,%zu,%d,%.1f,%.1f,%.2f,%.1f,%.2f,%.3f\n",
                size, scene.grains.size(), -least, cold.solve.contacts, interface, coldSweeps, double(sweeps)/steps, 1e3*seconds/steps,
                1e6*seconds/std::max(1, sweeps), counts[0]/size/std::max(1, sweeps), 1e-3*counts[1]/size/std::max(1, sweeps));
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const std::string what = argc == 6 ? argv[1] : "";
    if (what == "settle") settle(argv[2], std::atoi(argv[3]), std::atoi(argv[4]), std::atoi(argv[5]));
    else if (what == "run") run(argv[2], std::atoi(argv[3]), std::atoi(argv[4]), std::atoi(argv[5]));
    else std::printf("rankedBed settle FILE PERSIDE LAYERS STEPS, or rankedBed run FILE TILESX TILESY STEPS\n");
    MPI_Finalize();
    return what.empty();
}
