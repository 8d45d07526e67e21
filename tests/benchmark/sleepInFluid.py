# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K4 in a fluid: what a bed of 9240 glass spheres at rest in still water costs a step, awake and asleep."""

import re
import shutil
from pathlib import Path

from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

G, D, DELTA_T = 9.81, 1.2e-3, 1e-3
DRY, SETTLED = 0.5, 0.8              # when the dry bed, and the bed in water, have come to rest [s]
FALLING_ASLEEP, WINDOW = 160, 100    # steps
PARTS = ["sampleFluid", "linearizeDrag", "solveFluid", "fluidForces", "advanceGrains", "depositGrains", "reportStep"]
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
    case.control(DELTA_T, SETTLED)
    pinned("nscdDEMFoam", case.folder)
    return case


def secondsOfParts(case, steps):
    """Of a run of some steps from the settled bed, and how many grains slept at its end."""
    case.control(DELTA_T, SETTLED + steps*DELTA_T, 1e6)
    pinned("nscdDEMFoam", case.folder)
    log = Path(case.folder, "log.nscdDEMFoam").read_text()
    seconds = [float(re.search(r"^\s*%s\s+(\S+)\s+\S+ %%" % part, log, flags=re.M).group(1)) for part in PARTS]
    return seconds, int(case.report()["asleep"][-1])


def addSteps(table, case, sleep):
    writeGrains(case, sleep)
    before, _ = secondsOfParts(case, FALLING_ASLEEP)
    after, asleep = secondsOfParts(case, FALLING_ASLEEP + WINDOW)
    parts = [1e3*(b - a)/WINDOW for a, b in zip(before, after)]
    table.add(sleep, asleep, sum(parts) - parts[PARTS.index("solveFluid")] - parts[PARTS.index("reportStep")], *parts)


def main():
    case = settle()

    def measure(table):
        for sleep in ("off", "on"):
            addSteps(table, case, sleep)

    table = Table("sleepInFluid", ["sleep", "asleep", "grainPart"] + PARTS, larger=("grainPart",)).inRounds(measure)
    figure, axes = pyplot.subplots(figsize=(6, 2.5))
    left = [0.0]*len(table.rows)
    for part in PARTS:
        widths = table.column(part)
        axes.barh(["sleep " + word for word in table.column("sleep")], widths, left=left, label=part)
        left = [a + b for a, b in zip(left, widths)]
    axes.set_xlabel("ms per step")
    axes.legend(fontsize=6)
    savePicture(figure, "sleepInFluid")
    case.remove()


main()
