# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where the grains are: how many the paddle lifts off the floor, and whether their volume is that of the void fraction."""

import math

from foamCase import CaseFolder
from matplotlib.patches import Polygon
from pictures import BLUE, GRAY, newPicture, drawGrains, savePicture, writeResults

FLOOR, HALF, OMEGA = -0.05, 0.05, 4*math.pi
PADDLE = ((0.033, 0.006), (-0.033, 0.006), (-0.033, -0.006), (0.033, -0.006))
BED = 0.01    # above the four layers that the grains lie in at first [m]
SHOWN = ("0.25", "0.5", "1", "2")


def paddle(time):
    c, s = math.cos(OMEGA*time), math.sin(OMEGA*time)
    return [(c*x - s*y, s*x + c*y) for x, y in PADDLE]


def isInPaddle(x, time):
    """Whether a center is inside of the paddle."""
    c, s = math.cos(OMEGA*time), math.sin(OMEGA*time)
    return abs(c*x[0] + s*x[1]) < PADDLE[0][0] and abs(c*x[1] - s*x[0]) < PADDLE[0][1]


def centers(case, time):
    return [x[:2] for x in case.cloud("positions", time)]


def draw(case):
    figure, axes = newPicture(9, 2.7, columns=len(SHOWN))
    for panel, time in zip(axes, SHOWN):
        panel.set(xlim=(-HALF, HALF), ylim=(FLOOR, HALF), xticks=[], yticks=[], title="%s s" % time)
        panel.add_patch(Polygon(paddle(float(time)), color=GRAY))
        if time in case.times():
            drawGrains(panel, centers(case, time), case.cloud("d", time), facecolors=BLUE)
    savePicture(figure)


def main():
    case = CaseFolder(".")
    report = case.report()
    volume = max(abs(solid/grains - 1) for solid, grains in zip(report["solidVolume"], report["grainVolume"]))
    last = centers(case, case.times()[-1])
    inPaddle = max(sum(isInPaddle(x, float(time)) for x in centers(case, time)) for time in case.times() if float(time) > 0)
    writeResults([
        ("grains at the end", len(last)),
        ("share of grains off the floor at the end", sum(x[1] > FLOOR + BED for x in last)/len(last)),
        ("grains with their center in the paddle", inPaddle),
        ("volume of grains not in the void fraction", volume),
        ("impulse that fluid lost and grains did not get over weight", max(report["momentumError"])),
    ])
    draw(case)


main()
