// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Solutions by their names, and one run timed.

#include "manufacturedMeasure.H"
#include "manufacturedRun.H"

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

namespace
{

const ManufacturedFluid viscous{1.3, 0.07, 2.1}, lethe{1, 1, 0};

// Name, solution, fluid, whether the fluid fraction changes, whether there are walls.
const Manufactured solutions[] =
{
    {"M1", taylorGreen, viscous},
    {"M2", travelingWave, viscous, true},
    {"M3", sharpBed, viscous},
    {"case0", steadyVortex, lethe, false, true},
    {"case1", vortexInHills, lethe, false, true},
    {"case2", uniformFlux, lethe, false, true}
};


void measure(const Manufactured& solution, const label n, const label nSteps)
{
    ManufacturedRun run(solution, n);
    const std::clock_t start = std::clock();
    run.advance(nSteps);
    const double seconds = double(std::clock() - start)/CLOCKS_PER_SEC;
    const Errors errors = run.errors(), sizes = run.sizes();
    std::printf("%.6g %.6g %.6g\n", errors.u/sizes.u, errors.p/sizes.p, seconds);
}

} // End anonymous namespace


int measureManufactured(const int count, char** arguments)
{
    for (Manufactured solution : solutions)
    {
        if (count != 7 || std::string(arguments[0]) != solution.name) continue;

        const label n = std::atoi(arguments[1]), nSteps = std::atoi(arguments[2]);
        const std::string pimple = std::string("nOuterCorrectors ") + arguments[4] + "; nCorrectors " + arguments[5]
            + "; momentumPredictor yes; pRefCell 0; pRefValue 0;";
        solution.pimple = pimple.c_str();
        solution.deltaT = std::atof(arguments[3])/nSteps;
        solution.tolerance = std::atof(arguments[6]);
        if (solution.hasWalls) solution.ddt = "Euler";
        measure(solution, n, nSteps);
        return 0;
    }
    std::fprintf(stderr, "measure takes: M1, M2, M3, case0, case1 or case2, cells, steps, end, outer iterations, corrections, tolerance\n");
    return 2;
}

} // End namespace testing
} // End namespace nscdCoupling
} // End namespace Foam
