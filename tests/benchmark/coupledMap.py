# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where the coupled step is stable and right: grains of one speed in a periodic box of fluid at rest (C07, Stokes' law), by time step over relaxation
time, density ratio, cells and solid fraction. The grains stand on a lattice, disturbed by 1e-3 of their free gap: what is unstable grows from that."""

import argparse
import itertools
import math
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

D, RHO_FLUID, SPEED, PER_AXIS = 1e-3, 1000.0, 1.0, 4
RATIOS = (0.01, 0.1, 1.0, 10.0, 100.0, 1e4)                           # time step over relaxation time
DENSITIES = (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4)             # of grains over fluid
CELLS = (2.0, 1.0, 0.5, 0.25)                                         # spacings of the lattice to a cell
FRACTIONS = (0.01, 0.1, 0.3, 0.5)                                     # of volume that is grains
STEPS = 40
# Stable: grains gain no energy, and no fluid is faster than they were but for what it is between grains that stand closer than others.
# Right: mean slip within this share of the first slip, in each step.
GROWTH, FASTEST, RIGHT = 1.001, 1.1, 0.01
COLUMNS = ("solidFraction", "cellPerSpacing", "cellPerDiameter", "densityRatio", "stepOverTau", "slipError", "largestFluidSpeed", "energyGrowth",
           "stable", "right")


def arguments():
    parser = argparse.ArgumentParser(prog="tests/benchmark/run coupledMap", description=__doc__)
    parser.add_argument("--fractions", type=float, nargs="+", default=FRACTIONS)
    parser.add_argument("--cells", type=float, nargs="+", default=CELLS)
    parser.add_argument("--densities", type=float, nargs="+", default=DENSITIES)
    parser.add_argument("--ratios", type=float, nargs="+", default=RATIOS)
    parser.add_argument("--atOnce", type=int, default=1, help="runs at a time (default: 1)")
    return parser.parse_args()


def relaxationTime(phi, rhoGrain, mu):
    """tau of v - u = v0 exp(-t/tau) in a periodic box without weight."""
    return 1/(18*mu*phi/D**2*(1/(phi*rhoGrain) + 1/((1 - phi)*RHO_FLUID)))


def writeCase(phi, perCell, densityRatio, ratio):
    """Grains move 0.05 d a step, at their first speed; tau goes with 1/mu."""
    deltaT = 0.05*D/SPEED
    mu = relaxationTime(phi, densityRatio*RHO_FLUID, 1.0)*ratio/deltaT
    size = PER_AXIS*D*(math.pi/(6*phi))**(1/3)
    case = BoxCase(BUILD/("cases/coupledMap-%g-%g-%g-%g" % (phi, perCell, densityRatio, ratio)), (0, 0, 0), (size,)*3, (round(PER_AXIS/perCell),)*3)
    case.fluid(RHO_FLUID, mu, (0, 0, 0))
    case.grains("materials { m { density %.17g; } } contacts { default { friction 0; } }\nforces { drag { law Stokes; } }\n"
                "grains { type lattice; box (0 0 0) (%.17g %.17g %.17g); count (%d %d %d); diameter %.17g; jitter 1e-3; velocity (0 0 %g); }"
                % (densityRatio*RHO_FLUID, size, size, size, PER_AXIS, PER_AXIS, PER_AXIS, D, SPEED))
    case.control(deltaT, STEPS*deltaT, extra="""functions
{
    speed { type fieldMinMax; libs (fieldFunctionObjects); mode magnitude; fields (U); log false; }
    fluid { type volFieldValue; libs (fieldFunctionObjects); operation weightedVolAverage;
            weightField alpha.fluid; fields (U); writeFields false; log false; }
}""")
    return case


def written(case, name, file):
    """The lines that a function object wrote, without their comments."""
    path = next((Path(case.folder)/"postProcessing"/name).glob("*/" + file))
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def judge(case, densityRatio, ratio):
    """Largest error of the mean slip, largest speed of the fluid and largest energy of the grains, over all steps; in shares of the first."""
    energies = numpy.array(case.report()["kineticEnergy"])/(PER_AXIS**3*math.pi/12*D**3*densityRatio*RHO_FLUID*SPEED**2)
    fluid = numpy.array([float(line.split()[-1].strip(")")) for line in written(case, "fluid", "volFieldValue.dat")])
    fastest = max(float(line.split("\t")[4]) for line in written(case, "speed", "fieldMinMax.dat"))
    exact = numpy.exp(-ratio*numpy.arange(1, STEPS + 1))
    slips = numpy.sqrt(energies) - fluid/SPEED
    return abs(slips - exact).max(), fastest/SPEED, energies.max()


def outcome(point):
    """The row of one case."""
    phi, perCell, density, ratio = point
    case = writeCase(phi, perCell, density, ratio)
    case.run()
    error, fastest, energy = judge(case, density, ratio)
    case.remove()
    stable = energy <= GROWTH and fastest <= FASTEST
    cell = perCell*(math.pi/(6*phi))**(1/3)
    return phi, perCell, cell, density, ratio, error, fastest, energy, int(stable), int(stable and error <= RIGHT)


def measure(table, options):
    points = itertools.product(options.fractions, options.cells, options.densities, options.ratios)
    with ThreadPoolExecutor(options.atOnce) as pool:
        for row in pool.map(outcome, points):
            table.add(*row)


def draw(table, options):
    figure, axes = pyplot.subplots(len(options.fractions), len(options.cells), figsize=(11, 9), sharex=True, sharey=True, squeeze=False)
    rows = [dict(zip(table.columns, row)) for row in table.rows]
    for i, phi in enumerate(options.fractions):
        for j, perCell in enumerate(options.cells):
            part = [row for row in rows if (row["solidFraction"], row["cellPerSpacing"]) == (phi, perCell)]
            for row in part:
                color = "tab:green" if row["right"] else "tab:orange" if row["stable"] else "tab:red"
                axes[i][j].loglog(row["stepOverTau"], row["densityRatio"], "o", color=color, markersize=5)
            axes[i][j].set_title("solid fraction %g, cells of %.2g d" % (phi, part[0]["cellPerDiameter"]), fontsize=8)
    for ax in axes[-1]:
        ax.set_xlabel("time step over relaxation time", fontsize=8)
    for row in axes:
        row[0].set_ylabel("density, grains over fluid", fontsize=8)
    figure.suptitle("green: slip within 1 % in each step; orange: stable; red: energy or the fluid's speed grows", fontsize=9)
    savePicture(figure, table.name)


def main():
    options = arguments()
    table = Table("coupledMap", COLUMNS, larger=("slipError", "largestFluidSpeed", "energyGrowth"), smaller=("stable", "right"))
    draw(table.inRounds(lambda table: measure(table, options), 1), options)   # no times


main()
