// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// S36: a million random shots of up to 200 diameters a step, by one grain or two in a row, at closed walls of triangles and rectangles, coarse and
// fine, of one side and two, at rest and moving, from inside and from outside: none gets through. dryShots [shots]
#include "unit/nscd/scenes/shots.hpp"
#include "../resources/bars.hpp"

#include <cstdio>
#include <cstdlib>

using namespace scenes;
using bars::require;

namespace
{

/// Processor seconds of each step, and the grains that get through.
int volley()
{
    const Scene scene = volleyAtSheet();
    auto dynamics = scene.build(nscd::ContactSettings());
    std::printf("S36: 144 spheres at a sheet of 7200 triangles, seconds of each step:");
    for (int k = 0; k < 5; ++k)
    {
        const std::clock_t begun = std::clock();
        step(dynamics, scene.g, 1e-3);
        std::printf(" %.4f", static_cast<double>(std::clock() - begun)/CLOCKS_PER_SEC);
    }
    std::printf("\n");
    const std::vector<Vec3>& x = dynamics.grains().position;
    return static_cast<int>(std::count_if(x.begin(), x.end(), [](const Vec3& at) { return at[2] < waveHeight(at); }));
}

} // namespace

int main(int argc, char** argv)
{
    const int shots = argc > 1 ? std::atoi(argv[1]) : 1000000;
    const char* names[] = {"8 triangles", "32 triangles", "2048 triangles", "2048 of one side", "6 rectangles", "2048 that move", "2048 that turn"};
    int passed = volley();
    double energyGain = 0.0;
    for (int grains : {1, 2})
    for (const Surface surface : allSurfaces())
    {
        Tally tally;
        shoot(surface, shots/14, grains, 11, tally);
        std::printf("S36: %d at %-16s %6d shots, %5.1f us each (median; mean %5.1f), %6d stops on the way, %5d of %6d steps unconverged, %d through\n",
            grains, names[static_cast<int>(surface)], tally.shots, 1e6*tally.median(), 1e6*tally.mean(), tally.stopped, tally.unconverged,
            3*tally.shots, tally.passed);
        passed += tally.passed;
        energyGain = std::max(energyGain, tally.energyGain);
    }
    require("grains that got through", passed, 0);
    require("gain of energy in a step at walls at rest, share of the start", energyGain, 1e-9);
    return bars::status();
}
