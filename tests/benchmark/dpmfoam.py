# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The fluidized bed with nscdDEMFoam and with OpenFOAM's DPMFoam, from the same packed grains: tests/benchmark/run dpmfoam --help"""

import argparse
import csv
import shutil
from pathlib import Path

from foamFiles import firstEntry, readNumbers, setEntry
from pinnedRun import CORE, Cost, pinned
from results import BUILD as CASES, ROOT, Table, bars

HERE = Path(__file__).resolve().parent
BUILD = CASES/"dpmfoam"
DEFAULT = ROOT/"tutorials/coupled/fluidizedBed/0.4"


def arguments():
    parser = argparse.ArgumentParser(prog="tests/benchmark/run dpmfoam", description=__doc__.split(":")[0])
    parser.add_argument("state", nargs="?", type=Path, default=DEFAULT, help="time folder that nscdDEMFoam wrote (default: %(default)s)")
    parser.add_argument("--case", type=Path, help="case whose 0, constant and system ours runs with (default: that of the state)")
    parser.add_argument("--steps", type=int, default=100, help="DPMFoam steps to time, after the first 10 (default: 100)")
    parser.add_argument("--window", type=float, default=0.2, help="seconds of ours to time, after its first step (default: 0.2)")
    parser.add_argument("--core", type=int, default=CORE, help="core both are pinned to (default: BENCHMARK_CORE, else 0)")
    return parser.parse_args()


def difference(long, short):
    """What the longer run costs more: start-up, in both, drops out."""
    return Cost(long.cpu - short.cpu, long.wall - short.wall)


def vectorList(numbers):
    return "".join("(%.17g %.17g %.17g)\n" % tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3))


def prepareTheirs(state, folder):
    """DPMFoam's case with the grains of the state, at rest as they nearly are there."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(HERE/"DPMFoam", folder)
    grains = state/"lagrangian/grains"
    diameters = readNumbers(grains/"d", 1)
    if max(diameters) - min(diameters) > 1e-9*max(diameters):
        raise SystemExit("the grains of %s differ in size; this comparison is of equal ones" % state)
    setEntry(folder/"constant/kinematicCloudProperties", r"fixedValueDistribution \{ value", "%.17g" % diameters[0])
    head = "FoamFile { version 2.0; format ascii; class vectorField; object kinematicCloudPositions; }\n"
    (folder/"constant/kinematicCloudPositions").write_text(head + "(\n" + vectorList(readNumbers(grains/"position", 3)) + ")\n")
    return len(diameters)


def timeTheirs(state, steps, core):
    """Cost of so many steps of DPMFoam and the time it simulates."""
    folder = BUILD/"DPMFoam"
    count = prepareTheirs(state, folder)
    pinned("blockMesh", folder, core)
    deltaT = float(firstEntry(folder/"system/controlDict", "deltaT"))
    costs = []
    for n in (10, 10 + steps):
        setEntry(folder/"system/controlDict", "endTime", "%.17g" % (n*deltaT))
        log = "log.DPMFoam.%d" % n
        costs.append(pinned("DPMFoam", folder, core, log))
        checkTheirs((folder/log).read_text(), n, count)
    return difference(costs[1], costs[0]), steps*deltaT


def checkTheirs(log, steps, grains):
    """A run that lost grains or made fewer steps would be no reference."""
    parcels = [int(line.split("=")[1]) for line in log.splitlines() if "Current number of parcels" in line]
    if log.count("\nTime = ") != steps or not parcels or parcels[-1] != grains:
        raise SystemExit("DPMFoam made %d steps with %s grains, not %d with %d" % (log.count("\nTime = "), parcels[-1:], steps, grains))


def prepareOurs(state, case, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for part in ("constant", "system"):
        shutil.copytree(case/part, folder/part, ignore=shutil.ignore_patterns("polyMesh"))
    # A state of dry grains has no fields: those of the start then.
    start = case/("0.orig" if (case/"0.orig").is_dir() else "0")
    shutil.copytree(start, folder/state.name)
    shutil.copytree(state, folder/state.name, dirs_exist_ok=True)
    for name, value in (("startFrom", "latestTime"), ("writeInterval", "1e6")):
        setEntry(folder/"system/controlDict", name, value)


def timeOurs(state, case, window, core):
    """Cost of the window for nscdDEMFoam, and the rows of its report."""
    costs = []
    start, deltaT = float(state.name), float(firstEntry(case/"system/controlDict", "deltaT"))
    for length in (deltaT, deltaT + window):
        folder = BUILD/"nscdDEMFoam"
        prepareOurs(state, case, folder)
        setEntry(folder/"system/controlDict", "endTime", "%.12g" % (start + length))
        pinned("blockMesh", folder, core)
        costs.append(pinned("nscdDEMFoam", folder, core))
    with open(next((folder/"postProcessing/grains").glob("*/report.csv"))) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return difference(costs[1], costs[0]), [row for row in rows if float(row["time"]) > start + 1.5*deltaT]


def windowFigures(rows):
    """What happened in the timed window of ours."""
    def column(name):
        return [float(row[name]) for row in rows]

    contacts = column("contacts")
    return [
        ("steps", len(rows)), ("simulated time [s]", sum(column("deltaT"))), ("grains", column("grains")[-1]),
        ("contacts, fewest", min(contacts)), ("contacts, mean", sum(contacts)/len(rows)), ("contacts, most", max(contacts)),
        ("sweeps, mean", sum(column("sweeps"))/len(rows)),
        ("largest overlap [d]", max(column("overlapMax"))), ("largest mean overlap [d]", max(column("overlapMean"))),
        ("steps at the cap [%]", 100*sum(column("atCap"))/len(rows)),
        ("largest momentum error", max(column("momentumError"))),
        ("largest volume error", max(column("volumeError"))),
    ]


OURS, THEIRS = "nscdDEMFoam, processor s per simulated s", "DPMFoam, processor s per simulated s"
RATIO = "ratio of processor time"


def measure(table, state, options):
    """One window of each, from the same grains."""
    ours, rows = timeOurs(state, (options.case or state.parent).resolve(), options.window, options.core)
    theirs, simulated = timeTheirs(state, options.steps, options.core)
    window = sum(float(row["deltaT"]) for row in rows)

    table.addNamed(dict([(OURS, ours.cpu/window), (THEIRS, theirs.cpu/simulated), (RATIO, theirs.cpu/simulated/(ours.cpu/window))] + windowFigures(rows) + [
        ("DPMFoam steps", options.steps), ("DPMFoam simulated time [s]", simulated),
        ("nscdDEMFoam, clock s per simulated s", ours.wall/window), ("DPMFoam, clock s per simulated s", theirs.wall/simulated),
        ("ratio of clock time", theirs.wall/simulated/(ours.wall/window)),
    ]))


def main():
    options = arguments()
    state = options.state.resolve()
    if not (state/"lagrangian/grains/position").exists():
        raise SystemExit("%s holds no grains; run tutorials/coupled/fluidizedBed/Allrun first, or name a written time" % state)
    table = Table("dpmfoam", larger=(OURS, "largest overlap [d]"), smaller=(RATIO,))
    table.inRounds(lambda table: measure(table, state, options))
    for name, value in zip(table.columns, table.rows[0]):
        print("%-42s %.6g" % (name, value))
    bars(table, ["grains"], RATIO, "DPMFoam's processor time over ours, by grains")


if __name__ == "__main__":
    main()
