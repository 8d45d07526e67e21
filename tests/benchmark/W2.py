# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W2: 9240 spheres of 1.2 mm drop into a box of 44 x 10 mm and come to rest (C18's bed, dry; friction 0.1, restitution 0.3): force on the box against
their weight, overlaps, time to rest and run time, beside LIGGGHTS, LAMMPS and Yade.

The error is the larger one of that force's, worst over windows of 2 ms in the last 50 ms (weight and what the grains' momentum changes by, in all codes),
and of the largest overlap at the end in diameters."""

import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent/"peers"))
from plainRuns import installed, ours, theirs
from plainScene import Grain, PlainScene, Plane, softStep
from results import Table, pyplot, roundsOr, savePicture

WIDTH, DEPTH, HEIGHT, COUNT, D = 0.044, 0.01, 0.06, (33, 7, 40), 1.2e-3
G = 9.81
REST = 1e-8                                                 # kinetic energy of a grain in the mean, over m g d
END, LAST, WINDOW, EVERY = 0.3, 0.05, 2e-3, 1e-2            # s; the last grains land at about 0.1 s
TIMES = [EVERY*(k + 1) for k in range(round((END - LAST)/EVERY))] + [END - LAST + WINDOW*(k + 1) for k in range(round(LAST/WINDOW))]
RUNS = ((2e-3, 1e-1), (1e-3, 1e-1), (2e-3, 1e-2), (1e-3, 1e-2), (5e-4, 1e-2), (2.5e-4, 1e-2))     # time step [s], tolerance; the default is 1e-2
MODULI = (1e5, 1e6, 1e7)
COLUMNS = ["code", "knob", "deltaT", "errorPercent", "seconds", "forceErrorPercent", "overlapLargest", "overlapAtEnd", "timeToRest", "energyAtEnd", "steps"]


def box():
    """A lattice whose grains are moved by up to half of the gaps between them."""
    chance = random.Random(2)
    pitch = [length/count for length, count in zip((WIDTH, DEPTH, HEIGHT), COUNT)]
    places = ((i, j, k) for k in range(COUNT[2]) for j in range(COUNT[1]) for i in range(COUNT[0]))
    grains = [Grain(tuple(step*(at + 0.5) + 0.25*(step - D)*chance.uniform(-1, 1) for step, at in zip(pitch, place)), D/2) for place in places]
    planes = [Plane(0, 0.0), Plane(0, WIDTH, -1), Plane(1, 0.0), Plane(1, DEPTH, -1), Plane(2, 0.0)]
    return PlainScene(grains, planes, (-D, -D, -D), (WIDTH + D, DEPTH + D, 2*HEIGHT), 1000.0, (0.1,), 0.3, speed=1.0)


def overlap(scene, rows):
    """The largest of any pair and any wall [d]; grains in cells of a diameter, all are of one size."""
    cells = {}
    for row in rows:
        cells.setdefault(tuple(int(x//D) for x in row[:3]), []).append(row[:3])
    ahead = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) if (i, j, k) > (0, 0, 0)]
    closest = D
    for cell, here in cells.items():
        pairs = [(a, b) for n, a in enumerate(here) for b in here[:n]]
        pairs += [(a, b) for step in ahead for b in cells.get(tuple(map(sum, zip(cell, step))), ()) for a in here]
        closest = min([closest] + [math.dist(a, b) for a, b in pairs])
    deepest = max(D/2 - plane.side*(row[plane.axis] - plane.place) for plane in scene.planes for row in rows)
    return max(D - closest, deepest, 0.0)/D


def energy(rows):
    """Kinetic energy of a grain in the mean, over m g d."""
    return sum(v*v + 0.1*D*D*w*w for row in rows for v, w in zip(row[3:6], row[6:9]))/len(rows)/(2*G*D)


def forceError(times, found):
    """Worst, in shares of the weight."""
    mean = [sum(row[5] for row in rows)/len(rows) for rows in found]
    windows = zip(times, times[1:], mean, mean[1:])
    return max(abs(after - before)/(end - start)/G for start, end, before, after in windows if start > END - LAST - 0.5*WINDOW)


def timeToRest(times, found):
    """After it the energy stays below REST."""
    moving = [k for k, rows in enumerate(found) if energy(rows) >= REST]
    after = moving[-1] + 1 if moving else 0
    return times[after] if after < len(times) else math.nan


def addRow(table, code, knob, deltaT, scene, run):
    figures, found = run
    overlaps = [overlap(scene, rows) for rows in found]
    times = [max(1, round(t/deltaT))*deltaT for t in TIMES]
    force = forceError(times, found)
    table.add(code, knob, deltaT, 100*max(force, overlaps[-1]), figures["seconds"], 100*force, max(overlaps), overlaps[-1], timeToRest(times, found),
              energy(found[-1]), int(figures["steps"]))


def measure(table, peers):
    scene = box()
    for deltaT, tolerance in RUNS:
        run = ours("W2", scene, TIMES, deltaT=deltaT, tolerance=tolerance, displacementTolerance=3e-2*tolerance)
        addRow(table, "nscdDEMFoam", "dt %g s, tolerance %g" % (deltaT, tolerance), deltaT, scene, run)
    for modulus in MODULI:
        for peer in peers:
            addRow(table, peer, "E %.0e Pa" % modulus, softStep(scene, modulus), scene, theirs(peer, "W2", scene, modulus, TIMES))


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for axis, column, label in ((axes[0], "errorPercent", "error [%]"), (axes[1], "overlapLargest", "largest overlap [d]")):
        for code in dict.fromkeys(table.column("code")):
            axis.loglog(table.column("seconds", code=code), table.column(column, code=code), "o", label=code)
        axis.set_xlabel("processor time of %g s, less start-up [s]" % END)
        axis.set_ylabel(label)
    axes[0].legend(fontsize=7)
    savePicture(figure, "W2")


if __name__ == "__main__":
    there = installed("LIGGGHTS", "LAMMPS", "Yade")
    draw(Table("W2", COLUMNS, larger=("errorPercent", "seconds", "overlapLargest")).inRounds(lambda table: measure(table, there), roundsOr(1)))
