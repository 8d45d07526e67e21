# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What ranks send in a step, part by part, as CSV: messages.py dry [largest number of ranks], or messages.py coupled [...].

dry: beds 50 layers deep, tiled: 5000 and 1250 grains a rank, and 40 000 grains on more and more ranks; runs.csv has sweeps and contacts.
coupled: steps of tutorials/coupled/fluidizedBed from 0.4 s, which its Allrun must have written."""

import csv
import shutil
import sys

from coreRun import PROGRAMS, numberOr
from foamFiles import setEntry
from rankedRun import said, setParts
from results import BUILD, ROOT, Table, bars, pyplot, savePicture

BED = BUILD/"bed10x50.dat"
TUTORIAL = ROOT/"tutorials/coupled/fluidizedBed"
# Ranks that wait give their core to others: there are more of them than cores.
MPIRUN = ["mpirun", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1"]

# Ranks: tiles of 5000 grains, steps, starts without impulses.
SERIES = {
    "weak5000": {1: (1, 1, 5, 10), 2: (2, 1, 5, 5), 4: (2, 2, 5, 3), 8: (4, 2, 5, 3), 16: (4, 4, 3, 2), 32: (8, 4, 3, 1), 64: (8, 8, 1, 1)},
    "weak1250": {4: (1, 1, 5, 10), 8: (2, 1, 5, 3), 16: (2, 2, 3, 3), 32: (4, 2, 3, 2), 64: (4, 4, 3, 1)},
    "strong40k": {2: (4, 2, 3, 2), 4: (4, 2, 3, 2), 16: (4, 2, 3, 2), 32: (4, 2, 1, 1), 64: (4, 2, 1, 1)},
}
# Ranks: parts of the mesh along each axis.
CUTS = {2: (1, 2, 1), 4: (1, 4, 1), 8: (2, 4, 1), 16: (2, 8, 1)}
SOLVERS = {"GAMG": None, "PCG": "solver PCG; preconditioner DIC;"}


def rowsOf(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def appendRows(table, rows, **lead):
    """Rows of one run, behind those of the runs before; `lead` are columns in front. What was counted so far is saved."""
    for row in rows:
        table.addNamed({**lead, **{name: numberOr(value) for name, value in row.items()}})
    table.save()


def ranked(ranks, command, folder, environment=(), exports=()):
    """What a program printed on so many ranks."""
    exported = [word for name in exports for word in ("-x", name)]
    return said(folder, *MPIRUN, "-np", ranks, *exported, *command, environment=environment)


def dry(largest):
    if not BED.exists():
        said(BUILD, PROGRAMS/"rankedBed", "settle", BED, 10, 50, 600)
    counted = BUILD/"counted.csv"
    sweeps, messages = Table("runs"), Table("messages", larger=("messages", "bytes"))
    for name, runs in SERIES.items():
        for ranks, arguments in runs.items():
            if ranks > largest:
                continue
            printed = ranked(ranks, [PROGRAMS/"rankedBed", "run", BED, *arguments], BUILD, {"MESSAGE_COUNT_FILE": str(counted)})
            print(name, printed.splitlines()[-1], flush=True)
            appendRows(sweeps, csv.DictReader(printed.splitlines()[-2:]), series=name)
            appendRows(messages, rowsOf(counted), series=name)
    bars(sweeps, ["series", "ranks"], "sweepsPerStep", "sweeps a step")
    draw(messages)


def draw(table):
    figure, axes = pyplot.subplots(figsize=(7, 5))
    for part in dict.fromkeys(table.column("part")):
        axes.loglog(table.column("ranks", part=part), table.column("messages", part=part), "o", label=part)
    axes.set(xlabel="ranks", ylabel="messages of a rank in a call of the part, mean")
    axes.legend(fontsize=7)
    savePicture(figure, table.name)


def prepare(folder, ranks, solver):
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("0.4", "constant", "system"):
        shutil.copytree(TUTORIAL/part, folder/part)
    control = folder/"system/controlDict"
    control.write_text(control.read_text().split("functions")[0])
    for keyword, value in (("endTime", "0.402"), ("writeInterval", "10")):
        setEntry(control, keyword, value)
    if SOLVERS[solver]:
        solution = folder/"system/fvSolution"
        solution.write_text(solution.read_text().replace("solver GAMG; smoother GaussSeidel;", SOLVERS[solver]))
    # What a sweep sends does not depend on their number.
    properties = folder/"constant/grainProperties"
    properties.write_text(properties.read_text() + "\nsolver { maxSweeps 30; }\n")
    setParts(folder, CUTS[ranks])
    said(folder, "decomposePar", "-time", "0.4")


def coupled(largest):
    counted, folder = BUILD/"counted.csv", BUILD/"cases/messages"
    messages = Table("messagesCoupled", larger=("messages", "bytes"))
    for solver in SOLVERS:
        for ranks in CUTS:
            if ranks > largest:
                continue
            prepare(folder, ranks, solver)
            log = ranked(ranks, ["nscdDEMFoam", "-parallel"], folder,
                         exports=["LD_PRELOAD=%s" % (PROGRAMS/"libmessageCount.so"), "MESSAGE_COUNT_FILE=%s" % counted])
            iterations = [line.split()[1] for line in log.splitlines() if "pressure iterations" in line]
            print(solver, ranks, "ranks, pressure iterations of the steps:", *iterations, flush=True)
            appendRows(messages, rowsOf(counted), pressureSolver=solver)
    draw(messages)


def main():
    what = sys.argv[1] if len(sys.argv) > 1 else "dry"
    largest = int(sys.argv[2]) if len(sys.argv) > 2 else 64
    if what not in ("dry", "coupled"):
        raise SystemExit(__doc__)
    {"dry": dry, "coupled": coupled}[what](largest)


main()
