// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What each solver takes to solve a settled bed from cold, as CSV.
// coldSolve settle FILE perSide layers steps [seed]   makes a bed with periodic sides; another one for each seed
// coldSolve sweeps FILE samples maxSweeps SOLVER [tiles]   sweeps and work to 1e-2 and 1e-3, mean of so many slightly different problems;
//                                                  of a bed of tiles x tiles times FILE
// coldSolve history FILE maxSweeps SOLVER          residual after 1, 2, 4, ... sweeps
// SOLVER: a name the library knows, or plain for NLGS without help. Work is time in units of a plain sweep, timed in the same run.
#include "benchmark/coldSolve/frozenBed.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace scenes;

namespace
{

double now() { return static_cast<double>(std::clock())/CLOCKS_PER_SEC; }

nscd::ContactSettings settingsOf(const std::string& solver, double tolerance, int maxSweeps)
{
    nscd::ContactSettings settings;
    settings.solver = solver == "plain" ? "NLGS" : solver;
    settings.accelerate = solver != "plain";
    // Both limits of the default, 1e-2 and 3e-4 d, times the same factor; what follows once they are met is left out.
    settings.displacementTolerance *= tolerance/settings.tolerance;
    settings.tolerance = tolerance;
    settings.polishSweeps = 0;
    settings.maxSweeps = maxSweeps;
    return settings;
}

struct Solve
{
    nscd::SolveReport report;
    double seconds;
    double baseForce;   ///< of the weight
};

Solve solveFromCold(FrozenBed& bed, int sample, const nscd::ContactSettings& settings)
{
    nscd::ContactProblem problem = bed.start(sample);
    const double start = now();
    const nscd::SolveReport report = nscd::findContactSolver(settings.solver).solve(problem, settings);
    const double seconds = now() - start;
    return {report, seconds, bed.baseForce()};
}

/// Seconds of a sweep over the contacts that matter in the end, with nothing around it.
double timeSweep(FrozenBed& bed)
{
    nscd::ContactProblem problem = bed.start(1);
    constexpr int sweeps = 200;
    nscd::solveNlgs(problem, settingsOf("plain", 1e-2, 50));
    const double start = now();
    for (int k = 0; k < sweeps; ++k) nscd::sweepActive(problem);
    return (now() - start)/sweeps;
}

void countSweeps(FrozenBed& bed, int samples, int maxSweeps, const std::string& solver)
{
    std::printf("grains,solver,tolerance,samples,converged,sweeps,work,contacts,residualRms,residualMax,baseForce\n");
    for (const double tolerance : {1e-2, 1e-3})
    {
        int converged = 0;
        double sweeps = 0.0, seconds = 0.0, rms = 0.0, max = 0.0, base = 0.0;
        std::size_t contacts = 0;
        for (int sample = 1; sample <= samples; ++sample)
        {
            const Solve solve = solveFromCold(bed, sample, settingsOf(solver, tolerance, maxSweeps));
            converged += solve.report.converged;
            contacts = solve.report.contacts;
            sweeps += static_cast<double>(solve.report.sweeps)/samples;
            seconds += solve.seconds/samples;
            base += solve.baseForce/samples;
            rms = std::max(rms, solve.report.residualRms/solve.report.speedScale);
            max = std::max(max, solve.report.residualMax/solve.report.speedScale);
        }
        std::printf("%zu,%s,%g,%d,%d,%.1f,%.1f,%zu,%.2e,%.2e,%.4f\n", bed.grains(), solver.c_str(), tolerance, samples, converged, sweeps,
            seconds/timeSweep(bed), contacts, rms, max, base);
        std::fflush(stdout);
    }
}

void printHistory(FrozenBed& bed, int maxSweeps, const std::string& solver)
{
    std::printf("grains,solver,sweeps,work,residualRms,residualMax,baseForce\n");
    const double sweepTime = timeSweep(bed);
    for (int sweeps = 1; sweeps <= maxSweeps; sweeps = std::max(sweeps + 1, sweeps*3/2))
    {
        const Solve solve = solveFromCold(bed, 1, settingsOf(solver, 1e-12, sweeps));
        std::printf("%zu,%s,%d,%.1f,%.3e,%.3e,%.4f\n", bed.grains(), solver.c_str(), solve.report.sweeps, solve.seconds/sweepTime,
            solve.report.residualRms/solve.report.speedScale, solve.report.residualMax/solve.report.speedScale, solve.baseForce);
        std::fflush(stdout);
    }
}

int number(const char* word) { return std::atoi(word); }

} // namespace

int main(int argc, char** argv)
{
    const std::string what = argc > 2 ? argv[1] : "";
    if (what == "settle" && (argc == 6 || argc == 7))
    {
        settleBed(argv[2], number(argv[3]), number(argv[4]), number(argv[5]), argc == 7 ? number(argv[6]) : 1);
        return 0;
    }
    if ((what == "sweeps" && (argc == 6 || argc == 7)) || (what == "history" && argc == 5))
    {
        const int tiles = what == "sweeps" && argc == 7 ? number(argv[6]) : 1;
        FrozenBed bed(TiledBed(argv[2], tiles, tiles).whole());
        if (what == "sweeps") countSweeps(bed, number(argv[3]), number(argv[4]), argv[5]);
        else printHistory(bed, number(argv[3]), argv[4]);
        return 0;
    }
    std::printf("coldSolve settle FILE PERSIDE LAYERS STEPS [SEED] | sweeps FILE SAMPLES MAXSWEEPS SOLVER [TILES] | history FILE MAXSWEEPS SOLVER\n");
    return 1;
}
