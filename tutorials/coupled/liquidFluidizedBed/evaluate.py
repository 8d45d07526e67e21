# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Expansion and pressure drop of the bed at three inflows against Richardson and Zaki, its drag law in a uniform bed, and the weight."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, drawGrains, newPicture, savePicture, writeResults

G, D, DENSITY, WATER, NU, SIDE = 9.81, 3.087e-3, 3585.9, 996.7775, 8.379e-7, 0.024
INFLOWS, STAGE, SETTLING = (0.08, 0.12, 0.157033), 2.5, 1.2    # superficial [m/s]; duration of each [s]; what of it is left out of means [s]
VOLUME = math.pi/6*D**3
WEIGHT = (DENSITY - WATER)*G*VOLUME


def root(function, low, high):
    """Where an increasing function is zero."""
    for _ in range(80):
        middle = 0.5*(low + high)
        low, high = (low, middle) if function(middle) > 0 else (middle, high)
    return low


def loneDrag(speed):
    """Of one grain alone at this speed [N]: the coefficient of Dalla Valle, which Rong et al. take."""
    return math.pi/8*D**2*WATER*(0.63 + 4.8/math.sqrt(speed*D/NU))**2*speed**2


def rongExponent(alpha, Re):
    return 2.65*(alpha + 1) - (5.3 - 3.5*alpha)*alpha**2*math.exp(-(1.5 - math.log10(Re))**2/2)


def uniformBed(inflow):
    """Fluid fraction at which the drag of Rong's law and the pressure gradient carry a grain."""
    Re = inflow*D/NU
    return root(lambda a: 1 - loneDrag(inflow)/WEIGHT*a**(-rongExponent(a, Re) - 1), 0.3, 0.99)


def richardsonZaki(inflow):
    """alpha = (U/u_t)^(1/n), n by the Archimedes number (Khan & Richardson 1989); far walls."""
    Ar = G*D**3*(DENSITY/WATER - 1)/NU**2
    n = (4.8 + 2.4*0.043*Ar**0.57)/(1 + 0.043*Ar**0.57)
    return (inflow/root(lambda u: loneDrag(u) - WEIGHT, 1e-3, 2))**(1/n)


def stageOf(times, stage):
    return (times > stage*STAGE + SETTLING) & (times <= (stage + 1)*STAGE + 1e-9)


def results(report, fraction, drop, weight):
    times, rows = report["time"], []
    for stage, inflow in enumerate(INFLOWS):
        found, published, law = fraction[stageOf(times, stage)].mean(), richardsonZaki(inflow), uniformBed(inflow)
        print("%.3f m/s: fluid fraction %.4f, Richardson and Zaki %.4f, Rong's law in a uniform bed %.4f" % (inflow, found, published, law))
        rows += [("fluid fraction at %.3g m/s" % inflow, found), ("the same less that of the law in a uniform bed at %.3g m/s" % inflow, found - law),
                 ("pressure drop over weight at %.3g m/s" % inflow, drop[1][stageOf(drop[0], stage)].mean()/weight)]
    return rows + [("grains", report["grains"][-1]), ("largest overlap", report["overlapMax"].max()),
                   ("largest volume error", report["volumeError"].max()), ("largest momentum error", report["momentumError"].max())]


def drawBed(axes, case, time):
    positions, speeds = numpy.array(case.cloud("position", time)), numpy.linalg.norm(case.cloud("U", time), axis=1)
    order = numpy.argsort(-positions[:, 1])
    axes.set(xlim=(0, 24), ylim=(0, 260), xlabel="x [mm]", title="%.3g m/s" % INFLOWS[round(float(time)/STAGE) - 1])
    return drawGrains(axes, 1e3*positions[order][:, [0, 2]], [1e3*D]*len(order), speeds[order], edgecolors="white", linewidths=0.2, clim=(0, 0.15))


def main():
    case = CaseFolder(".")
    report = {key: numpy.array(column) for key, column in case.report().items()}
    fraction = 1 - report["grains"]*VOLUME/(SIDE**2*2*report["massCenterZ"])   # of a bed as high as twice its mass center
    drop = numpy.array(list(case.series("pressureDrop/surfaceFieldValue.dat").values()))
    weight = report["grains"][-1]*WEIGHT/SIDE**2
    writeResults(results(report, fraction, drop, weight))
    figure, axes = newPicture(10.5, 4, columns=5, width_ratios=(1, 1, 1, 3.4, 3.4))
    for part, time in zip(axes, ("2.5", "5", "7.5")):
        grains = drawBed(part, case, time)
    figure.colorbar(grains, ax=axes[2], label="grain speed [m/s]")
    axes[0].set_ylabel("z [mm]")
    axes[3].plot(*drop, color=BLUE, linewidth=1)
    axes[3].axhline(weight, color=GRAY, linestyle="--", label="weight of the bed")
    axes[3].set(xlabel="time [s]", ylabel="pressure drop [Pa]", xlim=(0, 7.5), ylim=(0, 1.5*weight))
    inflows = numpy.linspace(0.06, 0.2, 50)
    axes[4].plot(inflows, [richardsonZaki(u) for u in inflows], ":", color=ORANGE, label="Richardson & Zaki")
    axes[4].plot(inflows, [uniformBed(u) for u in inflows], "--", color=GRAY, label="Rong's law, uniform bed")
    axes[4].plot(INFLOWS, [fraction[stageOf(report["time"], k)].mean() for k in range(3)], "o", color=BLUE, label="run")
    axes[4].set(xlabel="superficial velocity [m/s]", ylabel="fluid fraction", xlim=(0.06, 0.18), ylim=(0.4, 0.8))
    for part in axes[3:]:
        part.legend()
    savePicture(figure)


main()
