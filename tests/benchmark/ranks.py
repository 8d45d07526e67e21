# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Two ranks against one on 100 000 grains, in turn, on cores of their own: ranks.py [dry] [coupled]

dry: a settled bed with periodic sides, ten tiles of 10 000 grains, 20 steps.
coupled: the bed that tutorials/coupled/fluidizedBed/Allrun settled, four times side by side; 30 steps without inflow, then 60 with it are timed.
Nothing else should run meanwhile."""

import csv
import functools
import re
import shutil
import sys
import time

from foamFiles import readNumbers, setEntry
from rankedRun import said, setParts
from results import BUILD, ROOT, Table, pyplot, savePicture

BED = BUILD/"bed20x25.dat"
RANKED_BED = ROOT/"build/core/benchmark/rankedBed"
TUTORIAL = ROOT/"tutorials/coupled/fluidizedBed"
MPIRUN = ["mpirun", "--bind-to", "core", "-np"]
RANKS = (1, 2)
TILES = 4
WIDTH = 0.015           # m, of the tutorial's bed
SETTLED, END = 0.03, 0.09


def dry():
    """Clock seconds of a step, and sweeps of a step."""
    if not BED.exists():
        said(BUILD, *MPIRUN, 2, RANKED_BED, "settle", BED, 20, 25, 600)
    for ranks in RANKS:
        row = next(csv.DictReader(said(BUILD, *MPIRUN, ranks, RANKED_BED, "run", BED, 5, 2, 20).splitlines()[-2:]))
        yield "dry", ranks, 1e-3*float(row["msPerStep"]), float(row["sweepsPerStep"])


def widenMesh(path):
    text = path.read_text().replace("(2 30 90)", "(%d 30 90)" % (2*TILES))
    path.write_text(re.sub(r"\((-?)7\.5 ", r"(\g<1>%g " % (7.5*TILES), text))


def writeTiles(path):
    x = readNumbers(TUTORIAL/"0.4/lagrangian/grains/position", 3)
    rows = ["(%.17g %.17g %.17g)" % (x[i] + WIDTH*(tile - 0.5*(TILES - 1)), x[i + 1], x[i + 2])
            for tile in range(TILES) for i in range(0, len(x), 3)]
    path.write_text("FoamFile { version 2.0; format ascii; class vectorField; object positions; }\n(\n%s\n)\n" % "\n".join(rows))


def setTimes(case, endTime, interval):
    for keyword, value in (("endTime", endTime), ("writeInterval", interval)):
        setEntry(case/"system/controlDict", keyword, "%g" % value)


def makeCase(case):
    """The wider bed; its air comes on when it has settled."""
    shutil.rmtree(case, ignore_errors=True)
    for part in ("0", "constant", "system"):
        shutil.copytree(TUTORIAL/part, case/part, ignore=shutil.ignore_patterns("polyMesh"))
    widenMesh(case/"system/blockMeshDict")
    writeTiles(case/"constant/kinematicCloudPositions")
    inflow = case/"0/U"
    inflow.write_text(inflow.read_text().replace("time() > 0.4", "time() > %g" % SETTLED))
    properties = case/"constant/grainProperties"
    properties.write_text(properties.read_text().split("grains\n{")[0]
                          + "grains { type positionsFile; file kinematicCloudPositions; material glass; diameter 0.0025; }\n")
    setParts(case, (1, 2, 1))
    setTimes(case, SETTLED, SETTLED)
    said(case, "blockMesh")


def runOn(case, ranks):
    """The log of a run, and its clock seconds."""
    start = time.time()
    log = said(case, *(["taskset", "-c", "0", "nscdDEMFoam"] if ranks == 1 else [*MPIRUN, ranks, "nscdDEMFoam", "-parallel"]))
    return log, time.time() - start


@functools.lru_cache(None)
def settledCase():
    """The wider bed, settled; once."""
    if not (TUTORIAL/"0.4/lagrangian/grains/position").exists():
        raise SystemExit("tutorials/coupled/fluidizedBed has not settled: run its Allrun first")
    case = BUILD/"cases/ranks"
    makeCase(case)
    said(case, "decomposePar")
    runOn(case, 2)
    said(case, "reconstructPar", "-latestTime")
    setTimes(case, END, 10)
    return case


def coupled():
    """Clock seconds of a step (start included), and sweeps of a step."""
    case = settledCase()
    steps = round((END - SETTLED)/1e-3)
    for ranks in RANKS:
        log, seconds = runOn(case, ranks)
        yield "coupled", ranks, seconds/steps, sum(map(int, re.findall(r"(\d+) sweeps", log)))/steps
        print(log[log.index("Timing"):log.index("Summary")])


def main():
    kinds = {"dry": dry, "coupled": coupled}
    names = sys.argv[1:] or list(kinds)
    if not set(names) <= set(kinds):
        raise SystemExit(__doc__)
    (BUILD/"cases").mkdir(parents=True, exist_ok=True)
    table = Table("ranks", ["scene", "ranks", "secondsPerStep", "sweepsPerStep"], larger=("secondsPerStep",))
    table.inRounds(lambda table: [table.add(*row) for name in names for row in kinds[name]()])
    figure, axes = pyplot.subplots(figsize=(5, 4))
    for name in names:
        one, two = table.column("secondsPerStep", scene=name)
        print("%s: two ranks are %.2f times as fast" % (name, one/two))
        axes.plot(table.column("ranks", scene=name), table.column("secondsPerStep", scene=name), "o", label=name)
    axes.set(xlabel="ranks", ylabel="s a step", ylim=(0, None), xticks=RANKS)
    axes.legend()
    savePicture(figure, "ranks")


main()
