// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Spheres of very unlike sizes that fall into a box and come to rest: steps that end at the cap of sweeps, with and without clusters.
#include "unit/nscd/scenes/scenes.hpp"
#include "../resources/bars.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>

using namespace scenes;
using bars::require;

namespace
{

constexpr double deltaT = 1e-3;
constexpr int steps = 150;

struct Mix
{
    const char* name;
    int count;
    double smallest, largest;   ///< diameters [m]
    bool areTwo;                ///< sizes, else all between
    int starts;                 ///< random ones: one jam that lasts makes a tenth of a run
    double mostAtCap;           ///< share of the steps of all: not converged, without a sweep left or held [%]
};

/// Radii, the largest first; each size has the same share of the volume, two sizes with one large sphere at least.
std::vector<double> radiiOf(const Mix& mix, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const double ofSmallest = std::pow(mix.smallest, -2), ofLargest = std::pow(mix.largest, -2);
    std::vector<double> radii;
    for (int k = 0; k < mix.count; ++k)
    {
        const bool isLarge = unit(random) < std::pow(mix.smallest/mix.largest, 3) || k == 0;
        if (mix.areTwo) radii.push_back(0.5*(isLarge ? mix.largest : mix.smallest));
        else radii.push_back(0.5/std::sqrt(ofLargest + unit(random)*(ofSmallest - ofLargest)));
    }
    std::sort(radii.begin(), radii.end(), std::greater<double>());
    return radii;
}

/// Spheres at random places of a box, a quarter of it or less, without overlap.
Scene scatter(const Mix& mix, int start)
{
    Scene scene(3, 0.5, 0.0);
    std::mt19937 random(3 + start);
    const std::vector<double> radii = radiiOf(mix, random);
    double volume = 0.0;
    for (double r : radii) volume += 4.19*r*r*r;
    const double width = std::max(2.2*mix.largest, std::cbrt(volume/0.25)), height = std::max(1.5*mix.largest, volume/0.2/width/width);
    scene.scatter(radii, Vec3(width, width, height), random);
    scene.addOpenBox(width);
    return scene;
}

/// What came of the runs of a mix.
struct Sums
{
    int off = 0;   ///< steps that did not converge, but for those whose forces alone are off
    double sweeps = 0.0, contacts = 0.0, overlap = 0.0;
};

void fall(Sums& sums, nscd::GrainDynamics dynamics)
{
    for (int k = 0; k < steps; ++k)
    {
        const nscd::StepReport report = step(dynamics, Vec3(0, 0, -gravity), deltaT);
        sums.off += report.solve.atCap || report.solve.isHeld;
        sums.sweeps += report.solve.sweeps;
        sums.contacts += static_cast<double>(report.solve.contacts);
        sums.overlap = std::max(sums.overlap, report.overlapMax);
    }
}

/// Share of the steps that did not converge [%].
double shareOff(const Mix& mix, bool haveClusters)
{
    nscd::ContactSettings settings;
    settings.strategy.clusters.isOn = haveClusters;
    Sums sums;
    const std::clock_t begun = std::clock();
    for (int start = 0; start < mix.starts; ++start) fall(sums, scatter(mix, start).build(settings));
    const double seconds = static_cast<double>(std::clock() - begun)/CLOCKS_PER_SEC;
    const int all = mix.starts*steps;
    std::printf("%s, %s: %d of %d steps at the cap or held, %.0f sweeps a step, %.2g us a loaded contact and step, overlap %.2g d\n", mix.name,
        haveClusters ? "clusters" : "no clusters", sums.off, all, sums.sweeps/all, 1e6*seconds/std::max(1.0, sums.contacts), sums.overlap);
    return 100.0*sums.off/all;
}

} // namespace

/// With a number: only with clusters, from so many starts.
int main(int count, char** arguments)
{
    // The aim is 1 %. The first mix misses it: src/nscd/measured.md, section 12.
    std::vector<Mix> mixes =
    {
        {"2000 of 0.5 to 10 mm", 2000, 0.5e-3, 10e-3, false, 1, 5.0},
        {"3000 of 0.5 and 10 mm", 3000, 0.5e-3, 10e-3, true, 1, 1.0},
        {"1500 of 0.2 to 10 mm", 1500, 0.2e-3, 10e-3, false, 4, 4.0},
    };
    if (count > 1)
    {
        for (Mix& mix : mixes)
        {
            mix.starts = std::atoi(arguments[1]);
            shareOff(mix, true);
        }
        return 0;
    }
    for (const Mix& mix : mixes)
    {
        const double without = shareOff(mix, false), off = shareOff(mix, true);
        require("steps at the cap or held, %", off, mix.mostAtCap);
        require("over those without clusters", off/std::max(0.1, without), 0.5);
    }
    shareOff({"2000 of 2 mm, for comparison", 2000, 2e-3, 2.0001e-3, false, 1, 0.0}, true);
    return bars::status();
}
