# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K4 in a fluid: what a bed of 9240 glass spheres at rest in still water costs a step, awake and asleep."""

import re
import shutil
from pathlib import Path

from pinnedRun import pinned
from results import BUILD, Table
from timingTable import PARTS, drawParts, timesOf
from foamCase import BoxCase

G, D, DELTA_T = 9.81, 1.2e-3, 1e-3
DRY, SETTLED = 0.5, 0.8              # when the dry bed, and the bed in water, have come to rest [s]
FALLING_ASLEEP, WINDOW = 160, 100    # steps
GRAINS = """
materials {{ glass {{ density 2500; }} }}
contacts  {{ default {{ friction 0.3; rollingFriction 0.005; spinningFriction 0.005; }} }}
patches   {{ zMax {{ type exit; }} }}
grains    {{ type lattice; box (0 0 0) (0.044 0.01 0.06); count (33 7 40); diameter {d}; jitter 0.5; }}
solver    {{ sleep {sleep}; }}
"""


def writeGrains(case, sleep, extra=""):
    case.grains(GRAINS.format(d=D, sleep=sleep) + extra)


def settle():
    """The bed at rest in water, with the forces that it has there."""
    case = BoxCase(BUILD/"cases/sleepInFluid", (0, 0, 0), (0.044, 0.01, 0.12), (22, 5, 60),
                   {"xMin": "wall", "xMax": "wall", "yMin": "wall", "yMax": "wall", "zMin": "wall", "zMax": "patch"})
    case.gravity((0, 0, -G))
    writeGrains(case, "on", "fluid none;")
    case.control(DELTA_T, DRY)
    case.call("blockMesh")
    pinned("nscdDEMFoam", case.folder)
    case.fluid(1000, 1e-3)
    for name in ("U", "p_rgh"):
        shutil.copy(Path(case.folder, "0", name), Path(case.folder, case.times()[-1]))
    writeGrains(case, "on")
    case.control(DELTA_T, SETTLED, SETTLED - DRY)
    pinned("nscdDEMFoam", case.folder)
    return case


def window(case):
    """Of the last steps of a run from the settled bed: ms of each part, sweeps of prediction and trial together, and how many grains sleep."""
    seconds, sweeps = [], []
    for steps in (FALLING_ASLEEP, FALLING_ASLEEP + WINDOW):
        case.control(DELTA_T, SETTLED + steps*DELTA_T, 1e6)
        pinned("nscdDEMFoam", case.folder)
        log = Path(case.folder, "log.nscdDEMFoam").read_text()
        seconds.append(timesOf(log, "seconds"))
        sweeps.append(sum(map(int, re.findall(r"predictor (\d+) sweeps", log))))
    parts = [1e3*(after - before)/WINDOW for before, after in zip(*seconds)]
    return parts, (sweeps[1] - sweeps[0])/WINDOW, int(case.report()["asleep"][-1])


def grainPart(parts):
    """What of the parts of a step is the grains'."""
    return sum(time for part, time in zip(PARTS, parts) if part not in ("solveFluid", "reportStep"))


def addSteps(table, case, sleep):
    writeGrains(case, sleep)
    parts, sweeps, asleep = window(case)
    table.add(sleep, asleep, sweeps, grainPart(parts), *parts)


def main():
    case = settle()

    def measure(table):
        for sleep in ("off", "on"):
            addSteps(table, case, sleep)

    table = Table("sleepInFluid", ["sleep", "asleep", "predictorSweeps", "grainPart"] + PARTS, larger=("predictorSweeps", "grainPart"))
    drawParts(table.inRounds(measure), "sleepInFluid", "sleep")
    case.remove()


if __name__ == "__main__":
    main()
