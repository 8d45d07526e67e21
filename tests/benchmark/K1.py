# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K1: what a run without grains costs over pimpleFoam's, with equal schemes and solvers, on a cavity of 128 x 128 cells."""

import shutil

from pinnedRun import pinned
from results import BUILD, ROOT, Table, bars

CAVITY = ROOT/"tests/validation/fluidWithoutGrains/cavity"
ROUNDS = 5
GAMG = "solver GAMG; smoother GaussSeidel;"
PCG = "solver PCG; preconditioner DIC;"


def prepare(folder, pressureSolver, steps):
    """Ours; and beside it pimpleFoam's, whose pressure is over the density."""
    shutil.rmtree(folder, ignore_errors=True)
    ours, theirs = folder/"ours", folder/"theirs"
    shutil.copytree(CAVITY, ours)
    (ours/"constant/model").write_text("simulationType laminar;\n")
    (ours/"system/cells").write_text("n 128;\n")
    (ours/"system/tolerance").write_text("pressureTolerance 1e-7;\n")
    (ours/"system/run").write_text("deltaT 2.5e-4; endTime %.12g; writeInterval 1000000;\n" % (steps*2.5e-4))
    solution = ours/"system/fvSolution"
    solver = solution.read_text().replace("solver          PCG;\n        preconditioner  DIC;", pressureSolver)
    if pressureSolver not in solver:
        raise SystemExit("the pressure solver of %s is not what this expects" % solution)
    solution.write_text(solver)
    pinned("blockMesh", ours)
    shutil.copytree(ours, theirs)
    (theirs/"0/p").write_text((ours/"0/p_rgh").read_text().replace("p_rgh", "p").replace("[1 -1 -2 ", "[0 2 -2 "))
    return ours, theirs


def cost(folder, program, steps):
    (folder/"system/run").write_text("deltaT 2.5e-4; endTime %.12g; writeInterval 1000000;\n" % (steps*2.5e-4))
    return pinned(program, folder).cpu


def costsOfSteps(solver, steps=100):
    """Processor seconds of nscdDEMFoam and of pimpleFoam."""
    ours, theirs = prepare(BUILD/"cases/K1", solver, 1)
    mine = cost(ours, "nscdDEMFoam", steps + 1) - cost(ours, "nscdDEMFoam", 1)
    return mine, cost(theirs, "pimpleFoam", steps + 1) - cost(theirs, "pimpleFoam", 1)


def measure(table):
    for name, solver in (("GAMG", GAMG), ("PCG", PCG)):
        mine, other = costsOfSteps(solver)
        table.add(name, mine, other, mine/other)


def main():
    table = Table("K1", ["pressureSolver", "nscdDEMFoam", "pimpleFoam", "ratio"], larger=("nscdDEMFoam", "ratio"))
    table.inRounds(measure, ROUNDS)
    bars(table, ["pressureSolver"], "ratio", "processor time of 100 steps over pimpleFoam's")


if __name__ == "__main__":
    main()
