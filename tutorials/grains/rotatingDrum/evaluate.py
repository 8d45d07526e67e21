# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Torque on the drum against the lever of the discs' weight over the last turn, and the drum with its discs at three times."""

import csv
import math

from foamCase import CaseFolder
from pictures import drawGrains, newPicture, savePicture, writeResults

G, DENSITY, OMEGA = 9.81, 2500.0, 3.0
TURN = 2*math.pi/OMEGA


def wallColumns(path="postProcessing/grains/0/walls.csv"):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def drumPicture(time):
    """Polygons of the drum at a written time, as lists of points."""
    with open("postProcessing/walls/%s/drum.vtk" % time) as file:
        words = file.read().split()
    first = words.index("POINTS") + 3
    count = int(words[first - 2])
    points = [tuple(map(float, words[first + 3*k:first + 3*k + 3])) for k in range(count)]
    faces = words[words.index("POLYGONS") + 3:]
    polygons = []
    while faces:
        n = int(faces[0])
        polygons.append([points[int(k)] for k in faces[1:1 + n]])
        faces = faces[1 + n:]
    return polygons


def turned(before, after):
    """Angle between the first points of two pictures, in (-pi, pi]."""
    (x, y, _), (u, v, _) = before[0][0], after[0][0]
    return math.atan2(x*v - y*u, x*u + y*v)


def results(case):
    report, wall = case.report(), wallColumns()
    last = [k for k, t in enumerate(report["time"]) if t > report["time"][-1] - TURN]
    mass = DENSITY*report["grainVolume"][-1]
    lever = sum(-mass*G*report["massCenterX"][k] for k in last)/len(last)
    torque = sum(wall["drum.torqueZ"][k] for k in last)/len(last)
    times = [t for t in case.times() if float(t) > 0]
    pictures = [drumPicture(t) for t in times]
    first = OMEGA*float(times[0])
    return [("grains", report["grains"][-1]), ("torque over weight times lever", torque/lever),
            ("angle turned", first + sum(turned(a, b) for a, b in zip(pictures, pictures[1:]))),
            ("overlapMax", max(report["overlapMax"]))]


def draw(axes, case, time):
    speeds = [math.hypot(u[0], u[1]) for u in case.cloud("U", time)]
    grains = drawGrains(axes, case.cloud("position", time), case.cloud("d", time), speeds, clim=(0, 0.3))
    for polygon in drumPicture(time):
        axes.plot([p[0] for p in polygon], [p[1] for p in polygon], color="black", lw=1.5)
    axes.set(xlim=(-0.053, 0.053), ylim=(-0.053, 0.053), title="%s s" % time, xlabel="x [m]")
    return grains


def main():
    case = CaseFolder(".")
    writeResults(results(case))
    figure, axes = newPicture(10, 3.6, columns=3, sharey=True)
    for part, time in zip(axes, ("0.25", "1", "3")):
        grains = draw(part, case, time)
    axes[0].set_ylabel("y [m]")
    figure.colorbar(grains, ax=axes, label="speed [m/s]")
    savePicture(figure)


main()
