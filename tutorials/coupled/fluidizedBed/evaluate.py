# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Pressure drop of the fluidized bed against time, the bed itself, and the figures that expected.csv judges."""

import glob
import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, drawGrains, newPicture, savePicture, writeResults

SETTLED = 0.4                 # s, when the air comes on
WEIGHT = 24750*math.pi/6*2.5e-3**3*(2526 - 1.2)*9.81/(0.015*0.15)   # Pa: submerged weight over the cross-section


def pressureDrop():
    """Times and p_rgh at the distributor, which is 0 at the outlet; of the runs that followed one another."""
    runs = sorted(glob.glob("postProcessing/pressureDrop/*/surfaceFieldValue.dat"), key=lambda path: float(path.split("/")[2]))
    return numpy.concatenate([numpy.loadtxt(path) for path in runs]).T


def blockError(values, blocks=10):
    """Standard error of a mean, from the means of blocks."""
    means = [block.mean() for block in numpy.array_split(values, blocks)]
    return numpy.std(means, ddof=1)/math.sqrt(blocks)


def main():
    case = CaseFolder(".")
    report = {key: numpy.array(column) for key, column in case.report().items()}
    times, drop = pressureDrop()
    fluidized = drop[times > SETTLED + 0.6]
    flowing = report["time"] > SETTLED
    error = blockError(fluidized)
    print("mean pressure drop from %.1f s on: %.0f Pa, block standard error %.0f Pa, weight %.0f Pa"
          % (SETTLED + 0.6, fluidized.mean(), error, WEIGHT))
    writeResults([
        ("mean pressure drop over weight", fluidized.mean()/WEIGHT),
        ("largest overlap when fluidized [d]", report["overlapMax"][flowing].max()),
        ("largest mean overlap when fluidized [d]", report["overlapMean"][flowing].max()),
        ("share of steps at the cap when fluidized", 1 - report["converged"][flowing].mean()),
        ("grains", report["grains"][-1]),
        ("change of grain volume", numpy.ptp(report["grainVolume"])/report["grainVolume"][0]),
        ("largest momentum error", report["momentumError"].max()),
    ])

    figure, (plot, bed) = newPicture(9, 4, columns=2, width_ratios=(2, 1))
    plot.plot(times, drop, color=BLUE, linewidth=1, label="nscdDEMFoam")
    plot.axhline(WEIGHT, color=GRAY, linestyle="--", label="weight of the bed")
    plot.axvline(SETTLED, color=ORANGE, linewidth=1, label="air on")
    plot.set(xlim=(0, times[-1]), ylim=(0, 2*WEIGHT), xlabel="time [s]", ylabel="pressure drop [Pa]")
    plot.legend()
    positions = numpy.array(case.cloud("position"))
    speeds = numpy.linalg.norm(case.cloud("U"), axis=1)
    front = positions[:, 0] > 0.0025     # the layers next to the front
    grains = drawGrains(bed, positions[front][:, 1:], numpy.full(front.sum(), 2.5e-3), speeds[front])
    figure.colorbar(grains, ax=bed, label="grain speed [m/s]")
    bed.set(xlim=(-0.075, 0.075), ylim=(0, 0.35), xlabel="y [m]", ylabel="z [m]", title="%.1f s" % times[-1])
    savePicture(figure)


main()
