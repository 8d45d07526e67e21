// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contact solves a second in active sweeps over a settled bed, for each vector path, beside what the core's memory allows.
// sweepSpeed bed.dat [tilesX tilesY [sweeps]]: bed.dat as `rankedBed settle` wrote it. CSV.
#include "benchmark/rankedBed/tiledBed.hpp"

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"
#include "nscd/step/contactStep.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace scenes;

namespace
{

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Shortest time of `tries` calls [s].
template<class Work>
double shortest(int tries, const Work& work)
{
    double best = 1e30;
    for (int k = 0; k < tries; ++k)
    {
        const double start = now();
        work();
        best = std::min(best, now() - start);
    }
    return best;
}

/// Bytes a second that this core moves, read and written together, in a pass that changes every number of a large array in place,
/// as a sweep does.
double memoryBandwidth()
{
    std::vector<double> x(std::size_t(1) << 26, 1.0);
    const double seconds = shortest(5, [&]() { for (double& value : x) value = 1.5*value - 0.5; });
    return 2.0*x.size()*sizeof(double)/seconds;
}

/// The frozen contact problem of a bed's next step, from cold.
struct FrozenProblem
{
    Scene scene;
    nscd::Exchange serial;
    nscd::ContactList list;

    explicit FrozenProblem(Scene made)
    :
        scene(std::move(made))
    {
        const nscd::Scene parts{scene.grains, scene.materials, scene.walls, scene.box};
        const nscd::ContactSettings settings;
        const std::vector<double> reach(scene.grains.size(), settings.skin*radius);
        list = nscd::buildContactList(parts, nscd::WallSearch(scene.walls, 2.0*radius), reach, {}, 2.0*radius, serial);
        nscd::updateGeometry(list, parts);
        nscd::setFreeVelocities(list, scene.grains, weight(scene.grains, scene.g, deltaT), deltaT, nscd::GrainSleep());
        nscd::prepareSlots(list, nscd::chooseKernels("auto"), deltaT, settings.deadBand*2.0*radius, 1.0);
    }

    nscd::BlockRange active() const { return {list.awake.data(), list.awake.size()}; }

    std::size_t usedLanes() const
    {
        std::size_t used = 0;
        for (std::uint32_t k : list.awake)
        {
            for (int lane = 0; lane < nscd::blockLanes; ++lane) used += list.isUsed(std::size_t(k)*nscd::blockLanes + lane);
        }
        return used;
    }
};

void measure(FrozenProblem& problem, const char* path, int sweeps, double bandwidth)
{
    const nscd::SweepKernels kernels = nscd::chooseKernels(path);
    nscd::DefectSums sums{};
    const auto sweep = [&]() { sums = kernels.sweep(problem.list.bodies.data(), problem.list.blocks.data(), problem.active()); };
    for (int k = 0; k < 20; ++k) sweep();
    const double seconds = shortest(40, [&]() { for (int k = 0; k < sweeps; ++k) sweep(); })/sweeps;

    const double visited = problem.usedLanes(), blocks = problem.list.awake.size();
    // What must pass between core and memory in a sweep that nothing survives in the caches: blocks are read and their impulses written, bodies both.
    const double bytes = blocks*(sizeof(nscd::ContactBlock) + sizeof(nscd::ContactBlock::r)) + 2.0*problem.list.bodies.size()*sizeof(nscd::Body);
    const double allowed = bandwidth*visited/bytes;
    std::printf("%s,%zu,%.0f,%.0f,%.3f,%.2f,%.1f,%.1f,%.1f,%.1f,%.2f\n", kernels.name, problem.scene.grains.size(), visited, sums.active,
                visited/(blocks*nscd::blockLanes), 1e9*seconds/visited, 1e-6*visited/seconds, 1e-6*sums.active/seconds, bytes/visited, 1e-6*allowed,
                visited/seconds/allowed);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
    {
        std::printf("sweepSpeed BED [TILESX TILESY [SWEEPS]]\n");
        return 1;
    }
    const auto number = [=](int k, int otherwise) { return argc > k ? std::atoi(argv[k]) : otherwise; };
    const TiledBed tiles(argv[1], number(2, 1), number(3, 1));
    FrozenProblem problem(tiles.whole());
    const double bandwidth = memoryBandwidth();
    std::fprintf(stderr, "memory bandwidth %.1f GB/s\n", 1e-9*bandwidth);
    std::printf("path,grains,visited,loaded,fill,nsPerVisit,visitsMperS,loadedMperS,bytesPerVisit,allowedMperS,ofAllowed\n");
    for (const char* path : {"portable", "AVX2", "AVX512"})
    {
        try { measure(problem, path, number(4, 50), bandwidth); }
        catch (const std::invalid_argument&) { std::fprintf(stderr, "%s: not on this processor\n", path); }
    }
}
