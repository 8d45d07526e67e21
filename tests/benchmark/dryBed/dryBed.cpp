// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a step of a bed of spheres costs, as CSV: a lattice that lands and rests, or that a jet keeps in motion.
// dryBed [nx=17] [ny=17] [nz=17] [spacing=1.15] [deltaT=1e-3] [steps=500] [every=50] [jet=0] [maxSweeps=1000] [accelerate=1]
#include "benchmark/partColumns.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include <chrono>
#include <cstdio>
#include <map>
#include <random>

using namespace scenes;

namespace
{

using Options = std::map<std::string, double>;

constexpr double diameter = 2.5e-3, density = 2526.0, friction = 0.3;

/// Spheres of the Goldschmidt bed on a shaken lattice in an open box; spacing in diameters.
Scene lattice(const Options& o)
{
    Scene scene(3, friction, 0.0);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = o.at("spacing")*diameter, shake = 0.45*(spacing - diameter);
    const int n[3] = {int(o.at("nx")), int(o.at("ny")), int(o.at("nz"))};
    for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
    for (int i = 0; i < n[0]; ++i)
    {
        const Vec3 shift(unit(random), unit(random), unit(random));
        scene.addGrain(spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake*shift, 0.5*diameter, density);
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int axis : {0, 1})
    {
        scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
        scene.addPlane(spacing*n[axis]*Vec3::Unit(axis), -Vec3::Unit(axis));
    }
    return scene;
}

/// Weight, and with a jet an upward force that pulses at 4 Hz in the middle quarter and carries 0.7 of the weight beside it.
nscd::ExternalForces forces(const nscd::Grains& grains, double width, bool hasJet, double time, double deltaT)
{
    nscd::ExternalForces forces = weight(grains, Vec3(0, 0, -gravity), deltaT);
    if (!hasJet) return forces;
    const double pulse = 1 + 0.5*std::sin(2*3.14159*4*time);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3& x = grains.position[i];
        const bool isInJet = std::abs(x[0] - 0.5*width) < width/8;
        forces.force[i][2] += grains.mass[i]*gravity*(isInJet ? 3.5*pulse*std::exp(-x[2]/0.08) : 0.7);
        forces.implicitDrag.push_back(2.0*grains.mass[i]);
    }
    return forces;
}

/// Sums and extremes over the steps of a row.
struct Row
{
    int steps = 0, capped = 0, corrected = 0, rebuilt = 0;
    double sweeps = 0.0, overlapMax = 0.0, overlapMean = 0.0;

    void add(const nscd::StepReport& report)
    {
        ++steps;
        sweeps += report.solve.sweeps;
        capped += !report.solve.converged;
        corrected += report.correctionSweeps > 0;
        rebuilt += report.listRebuilt;
        overlapMax = std::max(overlapMax, report.overlapMax);
        overlapMean = std::max(overlapMean, report.overlapMean);
    }
};

void print(const Row& row, int step, const nscd::GrainDynamics& dynamics, const nscd::StepReport& last, const nscd::StepTimes& from)
{
    std::printf("%d,%zu,%zu,%zu,%.1f,%d,%d,%d,%.2e,%.2e,%.3e,%s\n", step, dynamics.grains().size(), last.solve.contacts,
        last.candidates, row.sweeps/row.steps, row.capped, row.corrected, row.rebuilt, row.overlapMax, row.overlapMean,
        nscd::kineticEnergy(dynamics.grains()), partColumns(dynamics.times().since(from), row.steps).c_str());
    std::fflush(stdout);
}

Options read(int argc, char** argv)
{
    Options o{{"nx", 17}, {"ny", 17}, {"nz", 17}, {"spacing", 1.15}, {"deltaT", 1e-3}, {"steps", 500}, {"every", 50}, {"jet", 0},
              {"maxSweeps", 1000}, {"accelerate", 1}};
    for (int k = 1; k < argc; ++k)
    {
        const std::string word = argv[k];
        const std::size_t at = word.find('=');
        if (at == std::string::npos || o.find(word.substr(0, at)) == o.end()) throw std::invalid_argument("unknown option " + word);
        o[word.substr(0, at)] = std::stod(word.substr(at + 1));
    }
    return o;
}

} // namespace

int main(int argc, char** argv)
{
    const Options o = read(argc, argv);
    nscd::ContactSettings settings;
    settings.maxSweeps = int(o.at("maxSweeps"));
    settings.accelerate = o.at("accelerate") != 0;
    auto dynamics = lattice(o).build(settings);
    const double deltaT = o.at("deltaT"), width = o.at("spacing")*diameter*o.at("nx");
    const int every = int(o.at("every"));

    std::printf("step,grains,contacts,candidates,sweeps,capped,corrected,rebuilt,overlapMax,overlapMean,kineticEnergy,%s\n",
                partHead().c_str());
    Row row;
    nscd::StepTimes from;
    for (int k = 1; k <= int(o.at("steps")); ++k)
    {
        dynamics.beginStep(deltaT);
        const nscd::StepReport report = dynamics.advance(forces(dynamics.grains(), width, o.at("jet") != 0, k*deltaT, deltaT));
        row.add(report);
        if (k % every != 0) continue;
        print(row, k, dynamics, report, from);
        row = Row();
        from = dynamics.times();
    }
}
