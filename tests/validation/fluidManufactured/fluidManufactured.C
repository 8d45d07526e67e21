// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Errors and orders of the averaged fluid on manufactured solutions: M1 to M3 in time and space, Lethe's three steady
// cases against Lethe's own errors at equal numbers of cells.

#include "manufacturedMeasure.H"
#include "manufacturedRun.H"

#include "../../accuracy/figures.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

bool isFailed = false;
label nLevels = 3;

void require(const bool condition, const char* what)
{
    if (condition) return;
    isFailed = true;
    std::printf("      FAILED: %s\n", what);
}


// Every scheme here is of second order; what is above is no error.
void requireOrder(const char* scene, const char* quantity, const scalar found, const scalar least)
{
    require(found >= least, quantity);
    figures::row(scene, quantity, 2, found, max(scalar(0), 1 - found/2), 1 - least/2);
}


Errors errorsAfter(const Manufactured& solution, const label n, const label nSteps)
{
    ManufacturedRun run(solution, n);
    run.advance(nSteps);
    return run.errors();
}


scalar order(const scalar coarse, const scalar fine)
{
    return std::log2(coarse/fine);
}


// Errors at t = 0.98 on 16, 32, 64... cells, dt = h/4.
std::vector<Errors> refine(const Manufactured& solution)
{
    std::vector<Errors> errors;
    std::printf("%s\n", solution.name);
    for (label level = 0; level < nLevels; ++level)
    {
        errors.push_back(errorsAfter(solution, 16 << level, 10 << level));
        const Errors& e = errors.back();
        std::printf("   %3d  u %.3e", 16 << level, e.u);
        if (level) std::printf(" (%.2f)", order(errors[level - 1].u, e.u));
        std::printf("  p %.3e", e.p);
        if (level) std::printf(" (%.2f)", order(errors[level - 1].p, e.p));
        std::printf("\n");
    }
    return errors;
}


void requireOrders(const Manufactured& solution, const scalar u, const scalar p)
{
    const auto errors = refine(solution);
    const Errors& coarse = errors[nLevels - 2];
    requireOrder(solution.name, "order of u", order(coarse.u, errors.back().u), u);
    requireOrder(solution.name, "order of p", order(coarse.p, errors.back().p), p);
    figures::row(solution.name, "rms error of u, finest mesh", figures::none, figures::none, errors.back().u, figures::none);
    figures::row(solution.name, "rms error of p, finest mesh", figures::none, figures::none, errors.back().p, figures::none);
}


void checkOrders()
{
    const ManufacturedFluid viscous{1.3, 0.07, 2.1}, sharp{1.3, 1e-4, 2.1}, free{1.3, 0.07, 0}, stiff{1.3, 0.07, 2.1e4};
    requireOrders({"M1 Taylor-Green over bumps", taylorGreen, viscous}, 1.9, 1.5);
    requireOrders({"M2 traveling wave of the fluid fraction", travelingWave, viscous, true}, 1.9, 1.5);
    requireOrders({"M3 sharp bed edges", sharpBed, viscous}, 1.9, 1.5);
    requireOrders({"M1, mu 1e-4", taylorGreen, sharp}, 1.9, 1.5);
    requireOrders({"M1, no drag", taylorGreen, free}, 1.9, 1.5);
    requireOrders({"M1, beta 2.1e4", taylorGreen, stiff}, 1.9, 1.5);
    requireOrders({"M2, beta 2.1e4", travelingWave, stiff, true}, 1.9, 1.5);

    // Drag so strong leaves u next to no error: all of it comes from grad p's, at the edges of the bed.
    const Manufactured stiffBed{"M3, beta 2.1e4", sharpBed, stiff};
    requireOrders(stiffBed, 1, 1.5);
    require(errorsAfter(stiffBed, 32, 20).u < 1e-5, "u follows strong drag");
}


// One outer iteration is enough, but for M1: PISO's splitting errs where viscosity is strong and G changes fast, and there
// two corrections leave 2 % of the pressure on 64 cells.
void checkOneOuterLoop()
{
    const ManufacturedFluid viscous{1.3, 0.07, 2.1};
    Manufactured wave{"M2, one outer iteration", travelingWave, viscous, true};
    wave.pimple = "nOuterCorrectors 1; nCorrectors 2; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    requireOrders(wave, 1.9, 1.5);
    Manufactured decaying{"M1, one outer iteration, five corrections", taylorGreen, viscous};
    decaying.pimple = "nOuterCorrectors 1; nCorrectors 5; momentumPredictor yes; pRefCell 0; pRefValue 0;";
    requireOrders(decaying, 1.9, 1.5);
}


void checkDistortedMeshes()
{
    const ManufacturedFluid viscous{1.3, 0.07, 2.1};
    for (Manufactured distorted : {
        Manufactured{"M1, 20 % distorted mesh", taylorGreen, viscous},
        Manufactured{"M2, 20 % distorted mesh", travelingWave, viscous, true},
        Manufactured{"M3, 20 % distorted mesh", sharpBed, viscous}})
    {
        distorted.pimple = "nOuterCorrectors 3; nCorrectors 2; nNonOrthogonalCorrectors 1; momentumPredictor yes;"
            "pRefCell 0; pRefValue 0;";
        distorted.distortion = 0.2;
        distorted.convection = "Gauss skewCorrected linear";
        requireOrders(distorted, 1.7, 1.5);
    }
}


// Distance of the velocities with a step and with half of it, at t = 0.8.
scalar stepError(Manufactured solution, const label n, const label nSteps)
{
    solution.deltaT = 0.8/nSteps;
    ManufacturedRun coarse(solution, n);
    coarse.advance(nSteps);
    solution.deltaT /= 2;
    ManufacturedRun fine(solution, n);
    fine.advance(2*nSteps);
    return std::sqrt(gAverage(magSqr(coarse.U().primitiveField() - fine.U().primitiveField())()));
}


void checkTimeOrder(const char* scheme, const scalar expected)
{
    Manufactured decaying{"M1 in time", taylorGreen, {1.3, 0.07, 2.1}};
    decaying.ddt = scheme;
    const scalar coarse = stepError(decaying, 48, 16), fine = stepError(decaying, 48, 32);
    std::printf("%s, %s: %.3e %.3e (%.2f)\n", decaying.name, scheme, coarse, fine, order(coarse, fine));
    require(mag(order(coarse, fine) - expected) < 0.15, "order in time");
    figures::compared(std::string(decaying.name) + ' ' + scheme, "order in time", order(coarse, fine), expected, 0.15);
}


// M2's velocity changes so little in time that its own order hides behind the mesh's error; what is left must be small.
void checkStepErrorOfTheWave()
{
    Manufactured wave{"M2 in time", travelingWave, {1.3, 0.07, 2.1}, true};
    wave.deltaT = 0.04;
    const scalar step = stepError(wave, 24, 20), mesh = errorsAfter(wave, 24, 20).u;
    std::printf("%s, backward: change with half the step %.1e of the mesh's error %.1e\n", wave.name, step, mesh);
    require(step < 0.05*mesh, "error in time");
}


void checkThatStressFormsDiffer()
{
    Manufactured other{"M1 with the source of div(alpha tau): must not converge", taylorGreen, {1.3, 0.07, 2.1}};
    other.isStressFormD = true;
    const auto errors = refine(other);
    require(order(errors[nLevels - 2].p, errors.back().p) < 0.5, "the test cannot tell the stress forms apart");
}


// L2 over [-1, 1]^2 as Lethe states it: its area is 4, so twice the RMS.
void checkAgainstLethe()
{
    struct Case { const char* name; Solution at; scalar u[3], p[3]; };
    const Case cases[] = {
        {"B05 Lethe case 0", steadyVortex, {3.790e-2, 1.010e-2, 2.595e-3}, {0.338, 0.120, 0.0397}},
        {"B05 Lethe case 1", vortexInHills, {7.471e-2, 1.992e-2, 5.120e-3}, {0.691, 0.244, 0.0803}},
        {"B05 Lethe case 2", uniformFlux, {4.581e-2, 1.205e-2, 3.052e-3}, {0.388, 0.104, 0.0265}}};
    for (const Case& lethe : cases)
    {
        Manufactured steady{lethe.name, lethe.at, {1, 1, 0}};
        steady.hasWalls = true;
        steady.ddt = "Euler";
        steady.pimple = "nOuterCorrectors 1; nCorrectors 3; momentumPredictor yes; pRefCell 0; pRefValue 0;";
        std::printf("%s: errors / Lethe's\n", lethe.name);
        Errors last;
        for (label level = 0; level < 3; ++level)
        {
            const label n = 16 << level;
            Errors e = errorsAfter(steady, n, 4*n);
            e.u *= 2;
            e.p *= 2;
            std::printf("   %3d  u %.3e / %.3e = %.2f", n, e.u, lethe.u[level], e.u/lethe.u[level]);
            std::printf("  p %.3e / %.3e = %.2f", e.p, lethe.p[level], e.p/lethe.p[level]);
            if (level) std::printf("  orders %.2f %.2f", order(last.u, e.u), order(last.p, e.p));
            std::printf("\n");
            require(e.u < lethe.u[level] && e.p < lethe.p[level], "errors below Lethe's");
            const std::string where = lethe.name + (", " + std::to_string(n)) + "^2 cells";
            figures::row(where, "L2 error of u, bar: Lethe's", figures::none, figures::none, e.u, lethe.u[level]);
            figures::row(where, "L2 error of p, bar: Lethe's", figures::none, figures::none, e.p, lethe.p[level]);
            if (n == 64) requireOrder(lethe.name, "order of u", order(last.u, e.u), 1.9);
            if (n == 64) requireOrder(lethe.name, "order of p", order(last.p, e.p), 1.5);
            last = e;
        }
    }
}

} // End anonymous namespace


// fluidManufactured [number of meshes: 3], or fluidManufactured measure ...
int main(int argc, char** argv)
{
    if (argc > 1 && std::string(argv[1]) == "measure") return measureManufactured(argc - 2, argv + 2);
    if (argc > 1) nLevels = std::atoi(argv[1]);
    checkOrders();
    checkOneOuterLoop();
    checkDistortedMeshes();
    checkTimeOrder("Euler", 1);
    checkTimeOrder("backward", 2);
    checkStepErrorOfTheWave();
    checkThatStressFormsDiffer();
    checkAgainstLethe();
    return isFailed;
}
