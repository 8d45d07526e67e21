// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Memory of grains and their contacts on each rank, in bytes per grain: peaks of what is allocated in the parts of a run, the peak of the
// process, and what the containers of the contact list hold.
// mpirun -np N rankedMemory bed bed.dat tilesX tilesY steps [maxSweeps]: a settled bed, of rankedBed settle
// mpirun -np N rankedMemory lattice perSide layers steps [maxSweeps]:    a lattice that falls on a floor from the first step on
#include "benchmark/rankedBed/tiledBed.hpp"
#include "parallel/rankedScene.hpp"

#include "nscd/contacts/contactList.hpp"

#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <new>

namespace
{

/// Bytes that new gave and delete did not get back.
double allocated = 0.0;
double mostAllocated = 0.0;

void* give(void* memory)
{
    if (!memory) throw std::bad_alloc();
    allocated += static_cast<double>(malloc_usable_size(memory));
    mostAllocated = std::max(mostAllocated, allocated);
    return memory;
}

void take(void* memory)
{
    allocated -= static_cast<double>(malloc_usable_size(memory));
    std::free(memory);
}

} // namespace

void* operator new(std::size_t bytes) { return give(std::malloc(bytes)); }
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    const std::size_t unit = static_cast<std::size_t>(alignment);
    return give(std::aligned_alloc(unit, (bytes + unit - 1)/unit*unit));
}
void operator delete(void* memory) noexcept { take(memory); }
void operator delete(void* memory, std::size_t) noexcept { take(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { take(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { take(memory); }

using namespace scenes;

namespace
{

/// A figure of /proc/self/status [bytes].
double statusOf(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
    {
        if (line.compare(0, name.size() + 1, name + ":") == 0) return 1024*std::atof(line.c_str() + name.size() + 1);
    }
    return 0.0;
}

template<class T>
double bytesOf(const std::vector<T>& values) { return static_cast<double>(values.capacity()*sizeof(T)); }

double bytesOf(const nscd::Grains& g)
{
    return bytesOf(g.position) + bytesOf(g.velocity) + bytesOf(g.omega) + bytesOf(g.orientation) + bytesOf(g.radius) + bytesOf(g.mass)
        + bytesOf(g.material) + bytesOf(g.id) + bytesOf(g.isFixed);
}

/// Prints mean over all ranks' grains and the worst rank's, in bytes per grain.
class Table
{
public:
    Table(const nscd::MpiExchange& exchange, std::size_t grains) : exchange_(exchange), grains_(static_cast<double>(grains))
    {
        double total = grains_, most = grains_;
        exchange.sum(&total, 1);
        exchange.max(&most, 1);
        total_ = total;
        print("grains of a rank", total/exchange.tree().all().size(), most);
    }

    void row(const char* name, double bytes) const
    {
        double total = bytes, worst = bytes/std::max(1.0, grains_);
        exchange_.sum(&total, 1);
        exchange_.max(&worst, 1);
        print(name, total/total_, worst);
    }

private:
    void print(const char* name, double mean, double worst) const
    {
        if (exchange_.rank() == 0) std::printf("%d,%s,%.1f,%.1f\n", exchange_.tree().all().size(), name, mean, worst);
    }

    const nscd::MpiExchange& exchange_;
    double grains_, total_;
};

/// Of a list as the next step would build it.
void tellList(const Table& table, const Scene& scene, const nscd::Grains& grains, nscd::MpiExchange& exchange)
{
    double sums[2] = {0.0, static_cast<double>(grains.size())};
    for (const Vec3& v : grains.velocity) sums[0] += v.squaredNorm();
    exchange.sum(sums, 2);
    const double speed = std::sqrt(sums[0]/sums[1]);
    const double diameter = 2*radius;
    std::vector<double> reach;
    for (const Vec3& v : grains.velocity)
    {
        reach.push_back(0.5*nscd::ContactSettings().skin*diameter + 2.0*deltaT*std::max(v.norm(), speed));
    }
    const double before = allocated;
    const nscd::ContactList list = nscd::buildContactList
    (
        {grains, scene.materials, scene.walls, scene.box}, nscd::WallSearch(scene.walls, diameter), reach, {}, diameter, exchange
    );
    table.row("list: candidates (a number)", static_cast<double>(list.candidates));
    table.row("list: slots (a number)", static_cast<double>(list.slots()));
    table.row("list: blocks", bytesOf(list.blocks));
    table.row("list: gap, wall, image", bytesOf(list.gap) + bytesOf(list.wall) + bytesOf(list.image) + bytesOf(list.restitution));
    table.row("list: bodies", bytesOf(list.bodies));
    table.row
    (
        "list: positions, reach, radius, mass, id", bytesOf(list.grainOf) + bytesOf(list.positionAtBuild) + bytesOf(list.reach)
            + bytesOf(list.position) + bytesOf(list.radius) + bytesOf(list.inverseMass) + bytesOf(list.id)
    );
    table.row("list: ghosts", bytesOf(list.ghosts) + bytesOf(list.solvedElsewhere));
    table.row("list: all of it", allocated - before);
}

/// The most that `work` has allocated at a time, all that was there before included.
template<class Work>
void measurePeak(double& peak, const Work& work)
{
    mostAllocated = allocated;
    work();
    peak = std::max(peak, mostAllocated);
}

void measure(Scene scene, int steps, const nscd::ContactSettings& settings)
{
    RankedScene bed(emptyBed(scene.box.length[0], scene.box.length[1]), settings, [](const Vec3&, std::int64_t) { return 0; });
    nscd::MpiExchange exchange;
    const double before = allocated - bytesOf(scene.grains), residentBefore = statusOf("VmRSS");
    bed.dynamics().setGrains(std::move(scene.grains));
    scene.grains = nscd::Grains();
    double sharing = 0.0, building = 0.0, solving = 0.0;
    bed.repartition();
    for (int k = 0; k < steps; ++k)
    {
        if (k % 20 == 1) measurePeak(sharing, [&] { bed.repartition(); });
        measurePeak(building, [&] { bed.dynamics().beginStep(deltaT); });
        measurePeak(solving, [&] { bed.dynamics().advance(weight(bed.dynamics().grains(), scene.g, deltaT)); });
    }
    const double held = allocated, resident = statusOf("VmHWM");
    const Table table(exchange, bed.dynamics().grains().size());
    table.row("peak of the process over that without grains", resident - residentBefore);
    table.row("peak allocated: sharing out", sharing - before);
    table.row("peak allocated: building the list", building - before);
    table.row("peak allocated: solving", solving - before);
    table.row("allocated between two steps", held - before);
    table.row("grains", bytesOf(bed.dynamics().grains()));
    table.row("loaded contacts (a number)", static_cast<double>(bed.dynamics().contacts().size()));
    tellList(table, scene, bed.dynamics().grains(), exchange);
}

/// This rank's layers of the lattice.
Scene layersHere(int perSide, int layers)
{
    int size = 1, rank = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    Scene scene = latticeBed(perSide, layers);
    const nscd::Grains all = std::move(scene.grains);
    scene.grains = nscd::Grains();
    for (std::size_t i = all.size()*rank/size; i < all.size()*(rank + 1)/size; ++i)
    {
        scene.grains.add(all.position[i], radius, density, 0, all.id[i]);
    }
    return scene;
}

Scene tilesHere(const TiledBed& tiles)
{
    int size = 1, rank = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return tiles.part(tiles.size()*rank/size, tiles.size()*(rank + 1)/size);
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const std::string what = argc >= 5 ? argv[1] : "";
    const auto number = [argv](int i) { return std::atoi(argv[i]); };
    const int steps = what == "bed" ? 5 : 4;
    nscd::ContactSettings settings;
    if (argc > steps + 1) settings.maxSweeps = number(steps + 1);
    if (what == "bed" && argc > 5) measure(tilesHere(TiledBed(argv[2], number(3), number(4))), number(5), settings);
    else if (what == "lattice") measure(layersHere(number(2), number(3)), number(4), settings);
    else std::printf("rankedMemory bed FILE TILESX TILESY STEPS [MAXSWEEPS], or rankedMemory lattice PERSIDE LAYERS STEPS [MAXSWEEPS]\n");
    MPI_Finalize();
    return what.empty();
}
