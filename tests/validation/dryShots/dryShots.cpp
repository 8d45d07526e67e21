// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// S36: a million random shots of up to 200 diameters a step at closed walls of triangles and rectangles, coarse and fine, of one side and two, at
// rest and moving: none gets out. dryShots [shots]
#include "unit/nscd/scenes/shots.hpp"
#include "../resources/bars.hpp"

#include <cstdio>
#include <cstdlib>

using namespace scenes;
using bars::require;

int main(int argc, char** argv)
{
    const int shots = argc > 1 ? std::atoi(argv[1]) : 1000000;
    const char* names[] = {"32 triangles", "2048 triangles", "2048 of one side", "6 rectangles", "2048 that move", "2048 that turn"};
    Tally all;
    for (const Surface surface : allSurfaces())
    {
        Tally tally;
        shoot(surface, shots/6, 11, tally);
        std::printf("S36: %-18s %7d shots, %6.1f us of steps a shot, %6d stops on the way, %6d of %7d steps unconverged\n",
            names[static_cast<int>(surface)], tally.shots, 1e6*tally.seconds/tally.shots, tally.held, tally.unconverged, tally.steps);
        all.passed += tally.passed;
        all.energyGain = std::max(all.energyGain, tally.energyGain);
        all.unconvergedGain = std::max(all.unconvergedGain, tally.unconvergedGain);
    }
    require("shots that got out", all.passed, 0);
    require("gain of energy in a step at walls at rest, share of the start", all.energyGain, 1e-9);
    require("likewise in steps that say they did not converge", all.unconvergedGain, 1e-6);
    return bars::status();
}
