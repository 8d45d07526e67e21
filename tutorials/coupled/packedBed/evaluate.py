# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Pressure drop of the bed against Ergun's law over the bed's own alpha(z), and against the bed's weight once it is lifted."""

import math
import sys

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

G, D, RHO_P, RHO_F, MU = 9.81, 1e-3, 2000.0, 10.0, 10*1.5e-4
R, HEIGHT, LAYERS, SIDES = 13.85e-3, 55.3e-3, 24, 32
AREA = SIDES/2*R**2*math.sin(2*math.pi/SIDES)     # of the meshed cylinder, which has 32 flat sides
BELOW = ("0.4", "0.425", "0.45")                  # before the bed is lifted


def inflow(time):
    """Superficial velocity, as in 0/U."""
    return 0.002 + 0.018*min(max((time - 0.4)/0.1, 0), 1)


def volumeBelow(z, center):
    """Volume of the part of a grain below the height z."""
    h = min(max(z - center + D/2, 0), D)
    return math.pi*h**2*(D/2 - h/3)


def fluidFractions(case, time):
    """alpha(z), one value for each layer of cells."""
    step = HEIGHT/LAYERS
    share = [0.0]*(LAYERS + 1)
    for _, _, z in case.cloud("position", time):
        lowest = int((z - D/2)/step)
        for k in range(max(lowest, 0), min(lowest + 2, LAYERS)):
            share[k] += (volumeBelow((k + 1)*step, z) - volumeBelow(k*step, z))/(AREA*step)
    return [1 - phi for phi in share[:LAYERS]]


def ergunDrop(alphas, U):
    return sum((150*(1 - a)**2*MU*U/(a**3*D**2) + 1.75*(1 - a)*RHO_F*U**2/(a**3*D))*HEIGHT/LAYERS for a in alphas)


def measuredDrop(case):
    """{time: pressure at the inlet less that at the outlet, which is 0}."""
    times, pressures = case.series("inletPressure/surfaceFieldValue.dat").values()
    return {round(t, 6): p for t, p in zip(times, pressures)}


def overLaw(case, drop, times):
    """Pressure drop over that of the law for the bed at these written times: the mean over the 10 ms before each."""
    rows = []
    for time in times:
        alphas, end = fluidFractions(case, time), float(time)
        ratios = [p/ergunDrop(alphas, inflow(t)) for t, p in drop.items() if end - 0.01 < t <= end]
        rows.append(("drop over law at %g mm/s" % (1e3*inflow(end)), sum(ratios)/len(ratios)))
    return rows


def draw(case, drop, fineDrop):
    figure, axes = newPicture(6.5, 4)
    alphas = fluidFractions(case, BELOW[0])
    speeds = [1e-3*U for U in range(2, 21)]
    axes.plot([1e3*U for U in speeds], [ergunDrop(alphas, U) for U in speeds], color=GRAY, label="Ergun's law for the settled bed")
    weight = len(case.cloud("d"))*math.pi/6*D**3*(RHO_P - RHO_F)*G/AREA
    axes.axhline(weight, color=GRAY, linestyle="--", label="weight less buoyancy, over the area")
    ramp = sorted(t for t in drop if 0.4 <= t <= 0.5)
    axes.plot([1e3*inflow(t) for t in ramp], [drop[t] for t in ramp], color=BLUE, label="run, steps of 0.5 ms")
    if fineDrop:
        axes.plot([1e3*inflow(t) for t in fineDrop], list(fineDrop.values()), ":", color=ORANGE, lw=3, label="run, steps of 0.05 ms")
    axes.set(xlabel="superficial velocity [mm/s]", ylabel="pressure drop [Pa]", xlim=(2, 20), ylim=(0, 270))
    axes.legend()
    savePicture(figure)


def main():
    case = CaseFolder(".")
    drop, fineDrop = measuredDrop(case), {}
    report = case.report()
    lifted = [p for t, p in drop.items() if t > 0.55]
    atRest = [error for t, error in zip(report["time"], report["momentumError"]) if 0.2 < t < 0.4]
    writeResults(overLaw(case, drop, BELOW) + [("plateau", sum(lifted)/len(lifted)), ("largest overlap", max(report["overlapMax"])),
                 ("momentum error at rest", max(atRest)), ("largest momentum error", max(report["momentumError"])),
                 ("grains lost", report["exited"][-1])])
    if sys.argv[1:] == ["fine"]:
        fine = CaseFolder("fine")
        fineDrop = measuredDrop(fine)
        writeResults(overLaw(fine, fineDrop, BELOW[1:]), "resultsFine.csv")
    draw(case, drop, fineDrop)


main()
