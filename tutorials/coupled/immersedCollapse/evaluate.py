# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The discs at four times, and what is left of motion, force and volume when they lie at the bottom."""

import math

from foamCase import CaseFolder
from pictures import drawGrains, newPicture, savePicture, writeResults

G, DENSITY, WATER, D, WIDTH = 9.81, 1500.0, 1000.0, 5e-3, 0.4
TIMES = ("0.2", "1.6", "2.4", "3.2", "11")


def results(case):
    report = case.report()
    volume = report["grainVolume"][-1]
    weight = volume*(DENSITY - WATER)*G
    lost = volume*DENSITY*G*D/report["grains"][-1]     # energy of one disc over one diameter
    last = [k for k, t in enumerate(report["time"]) if t > 10.5]
    floorForce = sum(-report["wallForceY"][k] for k in last)/len(last)
    heights = [p[1] for p in case.cloud("position")]
    area = volume/0.005/WIDTH
    return [("discs", report["grains"][-1]),
            ("force on the walls at rest over submerged weight", floorForce/weight),
            ("kinetic energy at the end over that of a fall by a diameter", report["kineticEnergy"][-1]/(lost*report["grains"][-1])),
            ("solid fraction of the deposit", area/(2*sum(heights)/len(heights))),
            ("largest overlap", max(report["overlapMax"])),
            ("largest volume error", max(report["volumeError"])),
            ("largest momentum error", max(report["momentumError"]))]


def draw(axes, case, time):
    """Discs by their speed."""
    speeds = [math.hypot(u[0], u[1]) for u in case.cloud("U", time)]
    grains = drawGrains(axes, case.cloud("position", time), case.cloud("d", time), speeds, clim=(0, 0.3))
    axes.set(xlim=(-0.2, 0.2), ylim=(0, 0.6), title="%s s" % time, xlabel="x [m]")
    return grains


def main():
    case = CaseFolder(".")
    figure, axes = newPicture(10, 3.6, columns=5, sharey=True)
    for part, time in zip(axes, TIMES):
        grains = draw(part, case, time)
    axes[0].set_ylabel("y [m]")
    figure.colorbar(grains, ax=axes, label="speed [m/s]")
    savePicture(figure)
    writeResults(results(case))


main()
