# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cold solves of settled beds by every solver: sweeps and work (time in plain sweeps) to 1e-2 and 1e-3 against size and depth; and how sweeps
of the default solver grow with N at one shape, to 100 layers. coldSolve.py [growth]: that alone.

Beds that are missing in build/beds are settled first, some minutes each."""

import math
import sys

from coreRun import bed, rows, tableOf
from results import bars, pyplot, savePicture

# grains per side, layers; the first three have one shape.
SHAPES = ((10, 12), (13, 16), (20, 25), (10, 25), (10, 50), (10, 100))
DEPTHS = (25, 50, 100)
# And the number of solves of each, over which sweeps are averaged: they scatter by a third.
SOLVERS = {"NLGS": 10, "plain": 10, "NNCG": 10, "APG": 3, "queue": 3}
MAX_SWEEPS = 3000
# Beds of one shape: grains per side of a tile, layers, tiles along either side, solves; of each shape so many beds. The last has 640 000 grains
# and takes a minute a solve.
ONE_SHAPE = ((10, 12, 1, 5), (13, 16, 1, 5), (20, 25, 1, 5), (10, 50, 4, 2), (10, 100, 8, 2))
SEEDS = (1, 2, 3)
HISTORY = (20, 25)


def main():
    if sys.argv[1:] != ["growth"]:
        bySolver()
    growth()


def bySolver():
    def measure():
        return (({"perSide": perSide, "layers": layers}, rows("coldSolve", "sweeps", bed(perSide, layers), samples, MAX_SWEEPS, solver))
                for perSide, layers in SHAPES for solver, samples in SOLVERS.items())
    draw(tableOf("coldSolve", measure, 1, larger=("sweeps",)))      # sweeps do not scatter; hours


def growth():
    def measure():
        return (({"layers": layers, "tiles": tiles, "seed": seed}, rows("coldSolve", "sweeps", bed(perSide, layers, seed), samples, MAX_SWEEPS, "NLGS", tiles))
                for perSide, layers, tiles, samples in ONE_SHAPE for seed in SEEDS)
    table = tableOf("coldSolveGrowth", measure, 1, larger=("sweeps",))
    bars(table, ["layers", "tiles", "seed", "tolerance"], "sweeps", "sweeps")
    for tolerance in (1e-2, 1e-3):
        grains, sweeps = (table.column(name, tolerance=tolerance) for name in ("grains", "sweeps"))
        shallow = 2*len(SEEDS)
        print("sweeps to %g grow as N^%.2f over all, as N^%.2f from 25 layers on"
              % (tolerance, exponent(grains, sweeps), exponent(grains[shallow:], sweeps[shallow:])))


def exponent(x, y):
    """Slope of the least-squares line of log y over log x."""
    u, v = ([math.log(value) for value in values] for values in (x, y))
    meanU, meanV = sum(u)/len(u), sum(v)/len(v)
    return sum((a - meanU)*(b - meanV) for a, b in zip(u, v))/sum((a - meanU)**2 for a in u)


def draw(table):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    for solver in SOLVERS:
        history = rows("coldSolve", "history", bed(*HISTORY), 1000, solver)
        left.loglog([row["work"] for row in history], [row["residualRms"] for row in history], label=solver)
        sweeps = [table.column("sweeps", perSide=10, layers=layers, solver=solver, tolerance=1e-2)[0] for layers in DEPTHS]
        right.loglog(DEPTHS, sweeps, "o-", label=solver)
    left.set(xlabel="work, in plain sweeps", ylabel="residual rms / vs", title="bed of %d x %d x %d" % (HISTORY[0], *HISTORY))
    right.set(xlabel="layers", ylabel="sweeps to 1e-2 (at most %d)" % MAX_SWEEPS, title="10 x 10 grains a layer")
    left.legend()
    savePicture(figure, "coldSolve")


if __name__ == "__main__":
    main()
