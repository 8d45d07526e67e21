// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What each help of the contact solver is worth: steps of four scenes with all of them, and without each, from the same states. CSV.
// ablation bed.dat perSide layers [rounds=3] [steps=20]: bed.dat as `coldSolve settle` wrote it, of perSide*perSide*layers grains
#include "benchmark/peers/columnScene.hpp"
#include "benchmark/timedSteps.hpp"
#include "unit/nscd/scenes/heaps.hpp"

#include <cstdio>
#include <functional>

using namespace scenes;

namespace
{

struct Variant
{
    const char* name;
    std::function<void(nscd::ContactSettings&)> change;
};

const std::vector<Variant> variants =
{
    {"all", [](nscd::ContactSettings&) {}},
    {"looks", [](nscd::ContactSettings& s) { s.strategy.looks.isOn = false; }},
    {"packing", [](nscd::ContactSettings& s) { s.strategy.packing.isOn = false; }},
    {"momentum", [](nscd::ContactSettings& s) { s.strategy.momentum.isOn = false; }},
    {"mixing", [](nscd::ContactSettings& s) { s.strategy.mixing.isOn = false; }},
    {"queue", [](nscd::ContactSettings& s) { s.strategy.queue.isOn = false; }},
    {"loneDefects", [](nscd::ContactSettings& s) { s.strategy.loneDefects.isOn = false; }},
    {"direct", [](nscd::ContactSettings& s) { s.strategy.direct.isOn = false; }},
};

using Forces = std::function<nscd::ExternalForces(const nscd::Grains&, int step)>;

/// A scene at some of its moments.
struct Film
{
    const char* name;
    Scene scene;
    Forces forces;
    std::vector<nscd::SceneState> moments;
};

nscd::ExternalForces fall(const nscd::Grains& grains, int) { return weight(grains, Vec3(0, 0, -gravity), deltaT); }

/// Weight, and an upward force that pulses at 4 Hz in the middle quarter of the width and carries 0.7 of the weight beside it, in a medium of 2/s.
Forces jet(double width, double height)
{
    return [=](const nscd::Grains& grains, int step)
    {
        nscd::ExternalForces forces = fall(grains, step);
        const double pulse = 1 + 0.5*std::sin(2*3.14159*4*deltaT*step);
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            const Vec3& x = grains.position[i];
            const bool isInJet = std::abs(x[0] - 0.5*width) < width/8;
            forces.force[i][2] += grains.mass[i]*gravity*(isInJet ? 3.5*pulse*std::exp(-2.0*x[2]/height) : 0.7);
            forces.implicitDrag.push_back(2.0*grains.mass[i]);
        }
        return forces;
    };
}

nscd::ContactSettings awake()
{
    nscd::ContactSettings settings;
    settings.sleep = false;
    return settings;
}

/// Runs a scene and keeps its state after each of some numbers of steps.
void record(Film& film, const std::vector<int>& steps)
{
    auto dynamics = film.scene.build(awake());
    int k = 0;
    for (int last : steps)
    {
        for (; k < last; ++k)
        {
            dynamics.beginStep(deltaT);
            dynamics.advance(film.forces(dynamics.grains(), k));
        }
        film.moments.push_back(nscd::takeState(dynamics, deltaT*k, k));
    }
}

/// The bed itself, once it has come to rest in a medium.
Film rest(const TiledBed& bed)
{
    Film film{"rest", columnOfBed("bed", bed), fall, {}};
    auto dynamics = film.scene.build(awake());
    for (int k = 0; k < 1500; ++k) stepDamped(dynamics, Vec3(0, 0, -gravity), deltaT);
    for (int moment = 0; moment < 3; ++moment)
    {
        for (int k = 0; k < 20; ++k) step(dynamics, Vec3(0, 0, -gravity), deltaT);
        film.moments.push_back(nscd::takeState(dynamics, 0.0, 0));
    }
    return film;
}

std::vector<Film> makeFilms(const TiledBed& bed, int perSide, int layers)
{
    std::vector<Film> films;
    films.push_back({"collapse", columnOfBed("collapse", bed), fall, {}});
    record(films.back(), {20, 50, 100});
    films.push_back({"landing", latticeBed(perSide, layers), fall, {}});
    record(films.back(), {30, 60, 100});
    films.push_back(rest(bed));
    const double height = 2.0*radius*layers;
    films.push_back({"fluidized", columnOfBed("bed", bed), jet(bed.width, height), {}});
    record(films.back(), {150, 250, 350});
    return films;
}

struct Cost
{
    double seconds = 0.0, sweeps = 0.0, capped = 0.0, overlap = 0.0;
};

/// Some steps from a state, per step; the first two are not counted: they build what later ones keep.
Cost run(const Film& film, const nscd::SceneState& from, const Variant& variant, int steps)
{
    nscd::ContactSettings settings = awake();
    variant.change(settings);
    nscd::GrainDynamics dynamics(from.grains, film.scene.materials, film.scene.walls, film.scene.box, settings);
    dynamics.restore(from.impulses, from.lastDeltaT);
    Cost cost;
    double start = 0.0;
    for (int k = 0; k < steps + 2; ++k)
    {
        if (k == 2) start = processorTime();
        const nscd::ExternalForces forces = film.forces(dynamics.grains(), static_cast<int>(from.step) + k);
        dynamics.beginStep(deltaT);
        const nscd::StepReport report = dynamics.advance(forces);
        if (k < 2) continue;
        cost.sweeps += report.solve.sweeps/static_cast<double>(steps);
        cost.capped += !report.solve.converged;
        cost.overlap = std::max(cost.overlap, report.overlapMax);
    }
    cost.seconds = (processorTime() - start)/steps;
    return cost;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4)
    {
        std::printf("ablation BED PERSIDE LAYERS [rounds=3] [steps=20]\n");
        return 1;
    }
    const int rounds = argc > 4 ? std::stoi(argv[4]) : 3, steps = argc > 5 ? std::stoi(argv[5]) : 20;
    const std::vector<Film> films = makeFilms(TiledBed(argv[1], 1, 1), std::stoi(argv[2]), std::stoi(argv[3]));
    std::printf("scene,grains,moment,round,without,msPerStep,sweeps,capped,overlapMax\n");
    for (const Film& film : films)
    for (std::size_t moment = 0; moment < film.moments.size(); ++moment)
    for (int round = 0; round < rounds; ++round)
    for (const Variant& variant : variants)
    {
        const Cost cost = run(film, film.moments[moment], variant, steps);
        std::printf("%s,%zu,%zu,%d,%s,%.4f,%.2f,%.0f,%.2e\n", film.name, film.moments[moment].grains.size(), moment, round, variant.name,
                    1e3*cost.seconds, cost.sweeps, cost.capped, cost.overlap);
        std::fflush(stdout);
    }
}
