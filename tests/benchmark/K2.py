# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K2: what `fluid none` saves: steps of a settled box without fluid and in still air, from the same state."""

import shutil
from pathlib import Path

from pinnedRun import pinned
from results import BUILD, Table
from settledBox import settledBox, writeGrains
from timingTable import PARTS, drawParts, timesOf

SETTLED, STEPS, DELTA_T = 0.2, 50, 1e-3


def settle():
    case = settledBox(BUILD/"cases/K2", "fluid none;")
    case.control(DELTA_T, SETTLED)
    case.call("blockMesh")
    pinned("nscdDEMFoam", case.folder)
    return case


def steps(case, extra, count):
    """Processor seconds and log of some steps more."""
    writeGrains(case, extra)
    case.control(DELTA_T, SETTLED + count*DELTA_T, 1e6)
    cost = pinned("nscdDEMFoam", case.folder)
    return cost.cpu, Path(case.folder, "log.nscdDEMFoam").read_text()


def stepCost(case, extra):
    """Milliseconds of the processor a step, and the log."""
    startUp, _ = steps(case, extra, 1)
    long, log = steps(case, extra, 1 + STEPS)
    return 1e3*(long - startUp)/STEPS, log


def addSteps(table, case, name, extra):
    ms, log = stepCost(case, extra)
    table.add(name, ms, log.count("Solving for"), *timesOf(log, "ms"))


def addFluid(case):
    """Still air, also in the state that the bed settled to without a fluid."""
    case.fluid(1.2, 1.8e-5)
    for name in ("U", "p_rgh"):
        shutil.copy(Path(case.folder, "0", name), Path(case.folder, case.times()[-1]))


def measure(table):
    case = settle()
    written = Path(case.folder, case.times()[-1])
    addSteps(table, case, "none", "fluid none;")
    hasFields = (written/"U").exists() or Path(case.folder, "0/U").exists()
    addFluid(case)
    addSteps(table, case, "solved", "")
    print("fluid none: fields of the fluid %s" % ("there" if hasFields else "not even there"))
    case.remove()


def main():
    drawParts(Table("K2", ["fluid", "ms", "linearSolves"] + PARTS, larger=("ms",)).inRounds(measure), "K2", "fluid")


if __name__ == "__main__":
    main()
