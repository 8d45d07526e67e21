# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cold solves of settled beds by every solver: sweeps and work (time in plain sweeps) to 1e-2 and 1e-3 against size and depth.

Beds that are missing in build/beds are settled first, some minutes each."""

from coreRun import bed, rows, tableOf
from results import pyplot, savePicture

# grains per side, layers; the first three have one shape.
SHAPES = ((10, 12), (13, 16), (20, 25), (10, 25), (10, 50), (10, 100))
DEPTHS = (25, 50, 100)
# And the number of solves of each, over which sweeps are averaged: they scatter by a third.
SOLVERS = {"NLGS": 10, "plain": 10, "NNCG": 10, "APG": 3, "queue": 3}
MAX_SWEEPS = 3000
HISTORY = (20, 25)


def main():
    measured = (({"perSide": perSide, "layers": layers}, rows("coldSolve", "sweeps", bed(perSide, layers), samples, MAX_SWEEPS, solver))
                for perSide, layers in SHAPES for solver, samples in SOLVERS.items())
    draw(tableOf("coldSolve", measured))


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
