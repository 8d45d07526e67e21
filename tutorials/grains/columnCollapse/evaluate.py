# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Height and reach of the collapsing column at the times of table A13, and how deep discs overlap; draws three moments."""

import numpy as np

from foamCase import CaseFolder
from pictures import drawGrains, newPicture, savePicture, writeResults

TIMES = (0.1734, 0.2496, 0.3257, 0.3993, 0.5990)
DRAWN = ("0.175", "0.325", "0.6")


def shape(case, time):
    """Height of the mass center, mean distance from the axis, and the distance that 99 % of the discs are within."""
    centers = np.array(case.cloud("position", time))
    area = np.array(case.cloud("d", time))**2
    away = np.abs(centers[:, 0])
    return [np.average(centers[:, 1], weights=area), away.mean(), np.quantile(away, 0.99)]


def draw(axes, case, start, time):
    """Discs in the color of the height they started from."""
    origin = np.argsort(case.cloud("origId", time))
    centers = np.array(case.cloud("position", time))[origin]
    diameters = np.array(case.cloud("d", time))[origin]
    grains = drawGrains(axes, centers, diameters, start, rasterized=True)
    axes.set(xlim=(-1.15, 1.15), ylim=(0, 0.55), ylabel="y [m]")
    axes.text(-1.1, 0.45, "%.3f s" % float(time))
    return grains


def main():
    case = CaseFolder(".")
    written = [time for time in case.times() if float(time) > 0]
    shapes = np.array([shape(case, time) for time in written])
    rows = []
    for k, name in enumerate(("mass center height", "mean distance", "99 % distance")):
        found = np.interp(TIMES, [float(time) for time in written], shapes[:, k])
        rows += [("%s at %.4f s" % (name, time), value) for time, value in zip(TIMES, found)]
    report = case.report()
    rows += [("largest overlap", max(report["overlapMax"])), ("mean overlap", max(report["overlapMean"])), ("discs lost", report["exited"][-1])]
    writeResults(rows)

    start = np.loadtxt("constant/column.dat")[:, 1]
    figure, axes = newPicture(7, 5.4, rows=len(DRAWN), sharex=True)
    for panel, time in zip(axes, DRAWN):
        grains = draw(panel, case, start, time)
    axes[-1].set_xlabel("x [m]")
    figure.colorbar(grains, ax=axes, shrink=0.5, label="height at the start [m]")
    savePicture(figure)


main()
