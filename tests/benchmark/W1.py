# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W1: a column of 6048 grains collapses (A13; spheres with their centers in a plane for all codes, friction and restitution 0.5): root mean square
over five times of the relative errors of mass center, mean and 99 % distance, against our run at dt 1e-4 s and tolerance 1e-3, and run time."""

import json
import math
import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent/"peers"))
from plainRuns import installed, ours, theirs
from plainScene import Grain, PlainScene, Plane, softStep
from results import BUILD, ROOT, Table, pyplot, roundsOr, savePicture

COLUMN = ROOT/"tutorials/grains/columnCollapse/constant/column.dat"
# Table A13: time, and of the published discs (Gerris' example `column`; Staron and Hinch 2005) height of the mass center, mean and 99 % distance.
PUBLISHED = ((0.1734, (0.23050, 0.07632, 0.2094)), (0.2496, (0.15250, 0.11484, 0.3207)), (0.3257, (0.09888, 0.17815, 0.4547)),
             (0.3993, (0.07293, 0.24615, 0.6004)), (0.5990, (0.04792, 0.37913, 0.9809)))
TIMES = [time for time, _ in PUBLISHED]
RUNS = ((5e-3, 1e-1), (2e-3, 1e-1), (2e-3, 1e-2), (1e-3, 1e-1), (1e-3, 1e-2), (1e-3, 1e-3), (5e-4, 1e-2), (2.5e-4, 1e-2))     # time step, tolerance
REFERENCE = (1e-4, 1e-3)
MODULI = (1e6, 1e7, 1e8)
COLUMNS = ["code", "knob", "deltaT", "errorPercent", "seconds", "heightErrorPercent", "meanErrorPercent", "reachErrorPercent", "publishedErrorPercent",
           "steps", "overlapMax"]


def column():
    grains = []
    for line in COLUMN.read_text().splitlines():
        if not line.startswith("#"):
            x, z, _, d = map(float, line.split())
            grains.append(Grain((x, 0.0, z), d/2))
    return PlainScene(grains, [Plane(2, 0.0)], (-2.0, -3e-3, -0.01), (2.0, 3e-3, 0.75), isPlanar=True)


def mirrored(scene):
    """The same column as another one, to see what chance alone does."""
    return replace(scene, grains=[replace(g, x=(-g.x[0], *g.x[1:])) for g in scene.grains])


def shape(rows):
    """Height of the mass center, mean distance, distance that 99 % are within."""
    away = sorted(abs(row[0]) for row in rows)
    return sum(row[2] for row in rows)/len(rows), sum(away)/len(away), away[int(0.99*(len(away) - 1))]


def rms(values):
    return 100*math.sqrt(sum(value*value for value in values)/len(values))


def deviations(shapes, reference):
    """In percent: of all three figures together, and of each."""
    each = [[a[k]/b[k] - 1 for a, b in zip(shapes, reference)] for k in range(3)]
    return [rms(sum(each, []))] + [rms(part) for part in each]


def simulate(scene, deltaT, tolerance):
    figures, found = ours("W1", scene, TIMES, deltaT=deltaT, tolerance=tolerance, displacementTolerance=3e-2*tolerance, sleep=0)
    return figures, list(map(shape, found))


def reference(scene):
    """Done once, and kept."""
    kept = BUILD/"dry/W1.reference.json"
    if not kept.exists():
        figures, shapes = simulate(scene, *REFERENCE)
        kept.write_text(json.dumps((figures, shapes)))
    return json.loads(kept.read_text())


def addRow(table, code, knob, deltaT, run, best):
    figures, shapes = run
    published, (error, *each) = deviations(shapes, [values for _, values in PUBLISHED])[0], deviations(shapes, best)
    table.add(code, knob, deltaT, error, figures["seconds"], *each, published, int(figures["steps"]), figures.get("overlapMax", math.nan))


def measure(table, peers):
    scene = column()
    best = reference(scene)
    addRow(table, "reference", "dt %g s, tolerance %g" % REFERENCE, REFERENCE[0], best, best[1])
    softRuns = [(peer, modulus) for modulus in MODULI for peer in peers]
    for k in range(max(len(RUNS), len(softRuns))):
        for deltaT, tolerance in RUNS[k:k + 1]:
            addRow(table, "nscdDEMFoam", "dt %g s, tolerance %g" % (deltaT, tolerance), deltaT, simulate(scene, deltaT, tolerance), best[1])
        for peer, modulus in softRuns[k:k + 1]:
            figures, found = theirs(peer, "W1", scene, modulus, TIMES)
            addRow(table, peer, "E %.0e Pa" % modulus, softStep(scene, modulus), (figures, list(map(shape, found))), best[1])
    for code, other in (("nscdDEMFoam, mirrored", mirrored(scene)), ("nscdDEMFoam, discs", replace(scene, isDiscs=True))):
        addRow(table, code, "dt %g s, tolerance %g" % (1e-3, 1e-2), 1e-3, simulate(other, 1e-3, 1e-2), best[1])


def draw(table):
    figure, axis = pyplot.subplots(figsize=(7, 4.5))
    for code in dict.fromkeys(table.column("code")):
        if code != "reference":
            axis.loglog(table.column("seconds", code=code), table.column("errorPercent", code=code), "o", label=code)
    axis.set_xlabel("processor time of 0.6 s, less start-up [s]")
    axis.set_ylabel("error of the column's shape [%]")
    axis.legend(fontsize=7)
    savePicture(figure, "W1")


if __name__ == "__main__":
    there = installed("LIGGGHTS", "LAMMPS", "Yade")
    draw(Table("W1", COLUMNS, larger=("errorPercent", "seconds")).inRounds(lambda table: measure(table, there), roundsOr(1)))
