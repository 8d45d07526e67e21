// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What leaving out saves, as CSV: each row a scene with a choice that the library makes by itself, or without. Milliseconds of the processor.
// skips still BED | planar [PERSIDE] | smooth [PERSIDE] | sizes [PERSIDE] | cloud [PERSIDE] | kernels [PERSIDE] | rest BED [STEPS]
#include "benchmark/partColumns.hpp"
#include "benchmark/rankedBed/tiledBed.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/step/contactStep.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

using namespace scenes;

namespace
{

/// The clock is that of the processor; the library's own times are of the wall, and show shares only.
double now() { return static_cast<double>(std::clock())/CLOCKS_PER_SEC; }

void printHead() { std::printf("scene,variant,grains,contacts,steps,sweepsPerStep,listsBuilt,msPerStep,%s,creep,kineticEnergy\n", partHead().c_str()); }

double largestMove(const nscd::Grains& a, const nscd::Grains& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a.position[i] - b.position[i]).norm());
    return largest/(2*radius);
}

/// Some steps under weight or nothing, and what they cost.
void measure(const char* scene, const char* variant, nscd::GrainDynamics& dynamics, const Vec3& g, int steps)
{
    const nscd::Grains before = dynamics.grains();
    const nscd::ExternalForces forces = weight(before, g, deltaT);
    const nscd::StepTimes from = dynamics.times();
    double sweeps = 0.0;
    int built = 0;
    nscd::StepReport report;
    const double start = now();
    for (int k = 0; k < steps; ++k)
    {
        dynamics.beginStep(deltaT);
        report = dynamics.advance(forces);
        sweeps += report.solve.sweeps;
        built += report.listRebuilt;
    }
    const double seconds = now() - start;
    std::printf("%s,%s,%zu,%zu,%d,%.2f,%d,%.4f,%s,%.2e,%.2e\n", scene, variant, before.size(), report.solve.contacts,
                steps, sweeps/steps, built, 1e3*seconds/steps, partColumns(dynamics.times().since(from), steps).c_str(),
                largestMove(before, dynamics.grains()), nscd::kineticEnergy(dynamics.grains()));
    std::fflush(stdout);
}

/// K4, and the same asleep.
void stillBed(const char* file)
{
    const TiledBed tiles(file, 1, 1);
    for (const bool sleep : {false, true})
    {
        nscd::ContactSettings settings;
        settings.sleep = sleep;
        auto dynamics = tiles.part(0, tiles.size()).build(settings);
        for (int k = 0; k < 500; ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
        measure("still", sleep ? "may sleep" : "awake", dynamics, Vec3(0, 0, -gravity), 200);
    }
}

/// K5: discs that land, with the plane told and not told.
void planar(int perSide)
{
    for (const int axis : {-1, 1})
    {
        Scene scene = heap(2, perSide, perSide, radius, 0.8, friction);
        scene.grains.shape.emptyAxis = axis;
        nscd::ContactSettings settings;
        settings.sleep = false;
        auto dynamics = scene.build(settings);
        measure("planar", axis < 0 ? "spheres' kernel" : "discs' kernel", dynamics, scene.g, 150);
    }
}

/// K6: a heap without friction, and with one that is too small to feel but asks for all three directions and spins.
void smooth(int perSide)
{
    for (const double mu : {1e-300, 0.0})
    {
        const Scene scene = heap(3, perSide, perSide, radius, 0.8, mu);
        nscd::ContactSettings settings;
        settings.sleep = false;
        auto dynamics = scene.build(settings);
        measure("smooth", mu > 0.0 ? "friction 1e-300" : "friction 0", dynamics, scene.g, 100);
    }
}

/// A heap of spheres of one size, and of sizes that differ in the ninth digit: nothing is chosen by that.
void sizes(int perSide)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double spread : {1e-9, 0.0})
    {
        Scene scene = heap(3, perSide, perSide, radius, 0.8, friction);
        for (double& r : scene.grains.radius) r *= 1 + spread*unit(random);
        nscd::ContactSettings settings;
        settings.sleep = false;
        auto dynamics = scene.build(settings);
        measure("sizes", spread > 0.0 ? "sizes 1 +- 1e-9" : "one size", dynamics, scene.g, 100);
    }
}

/// Grains of one size at random in a periodic box, none touching, with random velocities.
Scene gas(int perSide, double fraction, double speed)
{
    Scene scene(3, friction, 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = radius*std::cbrt(4.0/3.0*3.14159265358979/fraction), shake = 0.5*spacing - radius;
    scene.box.length = Vec3::Constant(perSide*spacing);
    for (int k = 0; k < perSide*perSide*perSide; ++k)
    {
        const Vec3 cell(k % perSide + 0.5, k/perSide % perSide + 0.5, k/perSide/perSide + 0.5);
        scene.addGrain(spacing*cell + 0.999*shake*Vec3(unit(random), unit(random), unit(random)), radius, density);
        scene.grains.velocity.back() = speed*Vec3(unit(random), unit(random), unit(random));
    }
    return scene;
}

/// S29.
void cloud(int perSide)
{
    const Scene scene = gas(perSide, 1e-3, 0.01);
    auto dynamics = scene.build(nscd::ContactSettings());
    for (const char* variant : {"first steps", "later"}) measure("cloud", variant, dynamics, Vec3::Zero(), 20);
}

/// Sweeps of each path over the listed contacts of a plane of discs, by each kernel.
void kernels(int perSide)
{
    const Scene scene = heap(2, perSide, perSide, radius, 0.8, friction);
    const nscd::Scene parts{scene.grains, scene.materials, scene.walls, scene.box};
    std::printf("path,kernel,discs,visits,nsPerVisit\n");
    for (const char* path : {"portable", "AVX2", "AVX512"})
    {
        const nscd::SweepKernels general = nscd::chooseKernels(path);
        const std::pair<const char*, nscd::SweepFunction> rows[] =
            {{"spheres", general.sweep}, {"discs", nscd::planar(general, 1).sweep}, {"normal only", nscd::normalOnly(general).sweep}};
        for (const auto& row : rows)
        {
            nscd::Exchange alone;
            const std::vector<double> reach(scene.grains.size(), 0.3*radius);
            nscd::ContactList list = nscd::buildContactList(parts, nscd::WallSearch(scene.walls, 4*radius), reach, {}, 2*radius, alone);
            nscd::updateGeometry(list, parts);
            nscd::setFreeVelocities(list, scene.grains, weight(scene.grains, scene.g, deltaT), deltaT, nscd::GrainSleep());
            nscd::prepareSlots(list, general, deltaT, radius, 1.0);
            double best = 1e30;
            for (int attempt = 0; attempt < 30; ++attempt)
            {
                const double start = now();
                for (int sweep = 0; sweep < 20; ++sweep) row.second(list.bodies.data(), list.blocks.data(), {nullptr, list.blocks.size()});
                best = std::min(best, (now() - start)/20);
            }
            std::printf("%s,%s,%zu,%zu,%.2f\n", path, row.first, scene.grains.size(), list.candidates, 1e9*best/static_cast<double>(list.candidates));
        }
    }
}

/// S30: a row for each tenth of the run.
void rest(const char* file, int steps)
{
    const TiledBed tiles(file, 1, 1);
    auto dynamics = tiles.part(0, tiles.size()).build(nscd::ContactSettings());
    for (int k = 0; k < 1000; ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
    measure("rest", "coming to rest", dynamics, Vec3(0, 0, -gravity), 100);
    const nscd::Grains start = dynamics.grains();
    for (int part = 1; part <= 10; ++part) measure("rest", ("part " + std::to_string(part)).c_str(), dynamics, Vec3(0, 0, -gravity), steps/10);
    std::fprintf(stderr, "moved in all: %.2e d\n", largestMove(start, dynamics.grains()));
}

} // namespace

int main(int argc, char** argv)
{
    const std::string what = argc > 1 ? argv[1] : "";
    const auto number = [=](int k, int otherwise) { return argc > k ? std::atoi(argv[k]) : otherwise; };
    if (what == "kernels")
    {
        kernels(number(2, 160));
        return 0;
    }
    if ((what == "still" || what == "rest") && argc < 3) return 1;
    printHead();
    if (what == "still") stillBed(argv[2]);
    else if (what == "planar") planar(number(2, 100));
    else if (what == "smooth") smooth(number(2, 22));
    else if (what == "sizes") sizes(number(2, 22));
    else if (what == "cloud") cloud(number(2, 100));
    else if (what == "rest") rest(argv[2], number(3, 100000));
    else return 1;
}
