// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// S6: few large spheres settling among many small ones, size ratios 1:20 and 1:100, against small ones alone: overlap, and the time of
// the neighbor search a grain and build (printed, not judged). `drySizes many`: ten large ones, 1:100, among 100 000.
#include "unit/nscd/scenes/scenes.hpp"
#include "../resources/bars.hpp"

#include <cstdio>
#include <cstring>
#include <random>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 2e-4, small = 5e-4;

/// `few` spheres of radius `large` on the floor of a box, a shaken lattice of `many` of radius `small` around and above them, over the whole floor
/// or a corner of it that is `corner` wide.
Scene mixture(double large, int few, int many, double width, double corner = 0.0)
{
    Scene scene(3, 0.3, 0.0);
    std::vector<Vec3> centers;
    const int perSide = few > 1 ? 4 : 1;
    for (int k = 0; k < few; ++k)
    {
        const double pitch = width/perSide;
        centers.emplace_back(pitch*(k % perSide + 0.5), pitch*(k/perSide % perSide + 0.5), large*(1.0 + 1e-3));
        scene.addGrain(centers.back(), large);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = 2.3*small;
    const int perRow = static_cast<int>((corner > 0.0 ? corner : width)/spacing);
    for (int k = 0; static_cast<int>(scene.grains.size()) < few + many; ++k)
    {
        const Vec3 place(k % perRow + 0.5, k/perRow % perRow + 0.5, k/(perRow*perRow) + 0.5);
        const Vec3 x = spacing*place + 0.1*small*Vec3(unit(random), unit(random), unit(random));
        bool isFree = true;
        for (const Vec3& center : centers) isFree = isFree && (x - center).norm() > large + 1.05*small;
        if (isFree) scene.addGrain(x, small);
    }
    scene.addOpenBox(width);
    return scene;
}

void settle(const char* name, const Scene& scene, int steps)
{
    auto dynamics = scene.build(nscd::ContactSettings());
    const double diameter = [&] { double sum = 0.0; for (double r : scene.grains.radius) sum += 2*r; return sum/scene.grains.size(); }();
    double overlap = 0.0, candidates = 0.0, sweeps = 0.0;
    int builds = 0, capped = 0, hidden = 0;
    for (int k = 0; k < steps; ++k)
    {
        const double searchBefore = dynamics.times().seconds(nscd::GrainPart::findPairs);
        const nscd::StepReport report = step(dynamics, scene.g, deltaT);
        builds += dynamics.times().seconds(nscd::GrainPart::findPairs) > searchBefore;
        overlap = std::max(overlap, report.overlapMax*diameter/small);
        capped += !report.solve.converged;
        hidden += report.solve.hiddenMassRatio > 0.0;
        candidates = double(report.candidates)/scene.grains.size();
        sweeps += report.solve.sweeps;
    }
    const nscd::StepTimes& t = dynamics.times();
    const double perGrain = 1e9/scene.grains.size();
    std::printf("%s: %zu grains, %d steps, %d list builds; search %.0f ns a grain and build, all %.0f ns a grain and step, %.1f candidates a grain, "
                "%.1f sweeps a step, %d steps at the cap, %d with a warning of hidden forces\n", name, scene.grains.size(), steps, builds,
        t.seconds(nscd::GrainPart::findPairs)*perGrain/builds, t.total()*perGrain/steps, candidates, sweeps/steps, capped, hidden);
    require("overlap, radii of the small ones", overlap, 0.01);
}

} // namespace

int main(int argc, char** argv)
{
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    if (argc == 2 && std::strcmp(argv[1], "many") == 0)
    {
        settle("equal", mixture(small, 0, 100000, 0.41, 0.2), 300);
        settle("1:100, ten large", mixture(100*small, 10, 100000, 0.41, 0.2), 300);
        return bars::status();
    }
    settle("equal", mixture(small, 0, 20000, 0.035), 150);
    settle("1:20, one large", mixture(20*small, 1, 20000, 0.035), 150);
    settle("1:100, one large", mixture(100*small, 1, 20000, 0.12), 150);
    settle("1:20, ten large", mixture(20*small, 10, 20000, 0.088), 150);
    return bars::status();
}
