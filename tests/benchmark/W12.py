# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W12: what a step costs in dense beds of 1000 to 289 000 spheres, 10 layers deep: tiles of one settled bed, at rest and stirred by random velocities
of 0.1 m/s, all grains awake; ours at dt 1e-3 s, LIGGGHTS at E 1e7 Pa and a twentieth of the time of an impact."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent/"peers"))
from coreRun import bed
from plainRuns import installed, ours, theirs
from plainScene import Grain, PlainScene, Plane, softStep
from results import Table, pyplot, savePicture

PER_SIDE, LAYERS, RADIUS, DENSITY = 10, 10, 1.25e-3, 2526.0
TILES = (1, 3, 10, 17)          # along x and y
DELTA_T, MODULUS, SPEED = 1e-3, 1e7, 0.1
OUR_STEPS, SOFT_STEPS = 10, {1: 2000, 3: 500, 10: 100, 17: 50}
WARM_UP = {"rest": 10, "stirred": 2}      # steps: the same ones of all beds, as the sweeps of a bed that was just made fall from step to step


def tiled(tiles, isStirred):
    with open(bed(PER_SIDE, LAYERS)) as file:
        width, depth = map(float, file.readline().split())
        tile = [tuple(map(float, line.split())) for line in file]
    chance = random.Random(1)
    grains = []
    for k in range(tiles*tiles):
        for x, y, z in tile:
            v = tuple(SPEED*chance.gauss(0, 1) for _ in range(3)) if isStirred else (0.0, 0.0, 0.0)
            grains.append(Grain((x % width + k % tiles*width, y % depth + k//tiles*depth, z), RADIUS, v=v))
    high = (tiles*width, tiles*depth, 2*max(x[2] for x in tile))
    return PlainScene(grains, [Plane(2, 0.0)], (0.0, 0.0, 0.0), high, DENSITY, (0.3,), 0.3, speed=0.3, periods=(*high[:2], 0.0))


def addRow(table, code, state, scene, deltaT, figures):
    each = figures["seconds"]/figures["steps"]
    table.add(code, state, len(scene.grains), deltaT, 1e3*each, 1e6*each/len(scene.grains), each/deltaT, figures.get("sweeps", math.nan),
              figures.get("contacts", math.nan))


def measure(table, peers):
    for tiles in TILES:
        for state in WARM_UP:
            scene = tiled(tiles, state == "stirred")
            deltaT = softStep(scene, MODULUS)
            addRow(table, "nscdDEMFoam", state, scene, DELTA_T,
                   ours("W12", scene, [OUR_STEPS*DELTA_T], deltaT=DELTA_T, sleep=0, warmUp=WARM_UP[state])[0])
            for peer in peers:
                addRow(table, peer, state, scene, deltaT, theirs(peer, "W12", scene, MODULUS, [SOFT_STEPS[tiles]*deltaT])[0])


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for axis, column, label in ((axes[0], "msPerStep", "processor time of a step [ms]"), (axes[1], "secondsPerSecond", "processor seconds a simulated second")):
        for code in dict.fromkeys(table.column("code")):
            for state, line in (("rest", "o-"), ("stirred", "s--")):
                axis.loglog(table.column("grains", code=code, state=state), table.column(column, code=code, state=state), line, label="%s, %s" % (code, state))
        axis.set_xlabel("grains")
        axis.set_ylabel(label)
    axes[0].legend(fontsize=7)
    savePicture(figure, "W12")


if __name__ == "__main__":
    there = installed("LIGGGHTS")
    draw(Table("W12", ["code", "state", "grains", "deltaT", "msPerStep", "usPerGrain", "secondsPerSecond", "sweeps", "contacts"],
               larger=("msPerStep", "secondsPerSecond")).inRounds(lambda table: measure(table, there)))
