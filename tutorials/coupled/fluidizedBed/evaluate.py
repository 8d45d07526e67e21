# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Pressure drop of the bed against time, the bed itself, and the figures that expected.csv judges: evaluate.py [width of the bed, m]"""

import math
import sys

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, drawGrains, newPicture, savePicture, writeResults

SETTLED = 0.4                 # s, when the air comes on
GRAIN = math.pi/6*2.5e-3**3*(2526 - 1.2)*9.81                  # submerged weight of one [N]
WIDTH = float(sys.argv[1]) if len(sys.argv) > 1 else 0.15     # of the bed [m]


def pressureDrop():
    """Times and p_rgh at the distributor, which is 0 at the outlet; of the runs that followed one another."""
    return numpy.array(list(CaseFolder(".").series("pressureDrop/surfaceFieldValue.dat").values()))


def blockError(values, blocks=10):
    """Standard error of a mean, from the means of blocks."""
    means = [block.mean() for block in numpy.array_split(values, blocks)]
    return numpy.std(means, ddof=1)/math.sqrt(blocks)


def figures(report, fluidized, weight):
    """What expected.csv judges; `fluidized`: pressure drops since the bed bubbles, `weight` in Pa."""
    flowing = report["time"] > SETTLED
    print("mean pressure drop from %.1f s on: %.0f Pa, block standard error %.0f Pa, weight %.0f Pa"
          % (SETTLED + 0.6, fluidized.mean(), blockError(fluidized), weight))
    return [
        ("mean pressure drop over weight", fluidized.mean()/weight),
        ("largest overlap when fluidized [d]", report["overlapMax"][flowing].max()),
        ("largest mean overlap when fluidized [d]", report["overlapMean"][flowing].max()),
        ("share of steps at the cap when fluidized", report["atCap"][flowing].mean()),
        ("share of steps with forces off when fluidized", (1 - report["converged"] - report["atCap"])[flowing].mean()),
        ("grains", report["grains"][-1]),
        ("solid volume less the grains'", abs(report["solidVolume"]/report["grainVolume"] - 1).max()),
        ("largest volume error", report["volumeError"].max()),
        ("largest momentum error", report["momentumError"].max()),
    ]


def drawBed(case, times, drop, weight):
    """Pressure drop against time beside the bed at the end, grains by speed, in drawing.png."""
    figure, (plot, bed) = newPicture(9, 4, columns=2, width_ratios=(2, 1))
    plot.plot(times, drop, color=BLUE, linewidth=1, label="nscdDEMFoam")
    plot.axhline(weight, color=GRAY, linestyle="--", label="weight of the bed")
    plot.axvline(SETTLED, color=ORANGE, linewidth=1, label="air on")
    plot.set(xlim=(0, times[-1]), ylim=(0, 2*weight), xlabel="time [s]", ylabel="pressure drop [Pa]")
    plot.legend()
    positions = numpy.array(case.cloud("position"))
    speeds = numpy.linalg.norm(case.cloud("U"), axis=1)
    front = positions[:, 0] > 0.0025     # the layers next to the front
    grains = drawGrains(bed, positions[front][:, 1:], numpy.full(front.sum(), 2.5e-3), speeds[front])
    figure.colorbar(grains, ax=bed, label="grain speed [m/s]")
    bed.set(xlim=(-WIDTH/2, WIDTH/2), ylim=(0, 0.35), xlabel="y [m]", ylabel="z [m]", title="%.1f s" % times[-1])
    savePicture(figure)


def main():
    case = CaseFolder(".")
    report = {key: numpy.array(column) for key, column in case.report().items()}
    times, drop = pressureDrop()
    weight = report["grains"][-1]*GRAIN/(0.015*WIDTH)   # over the cross-section [Pa]
    if times[-1] > SETTLED + 0.6:
        writeResults(figures(report, drop[times > SETTLED + 0.6], weight))
    drawBed(case, times, drop, weight)


main()
