# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The bed at three times, what goes up in the spout and down beside it, and the pressure drop."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, drawGrains, newPicture, savePicture, writeResults

G, D, DENSITY, AREA, NU, SINCE = 9.81, 2.5e-3, 2526.0, 0.15*0.0075, 1.81e-5, 0.3
TIMES = ("0.1", "0.2", "1")


def upward(case, times):
    """x [m] and vertical velocity [m/s] of grains between 10 and 30 mm above the floor, at these times together."""
    x, w = [], []
    for time in times:
        for position, velocity in zip(case.cloud("position", time), case.cloud("U", time)):
            if 0.01 < position[2] < 0.03:
                x.append(position[0])
                w.append(velocity[2])
    return numpy.array(x), numpy.array(w)


def columnMean(field, left, right):
    """Mean over the cells of the bed whose middles lie between two x and 10 to 30 mm above the floor. The blocks follow one another."""
    total, count, start = 0.0, 0, 2*8
    for first, columns in ((-0.075, 14), (-0.005, 2), (0.005, 14)):
        for k in range(columns*90):
            x, z = first + (k % columns + 0.5)*0.005, (k//columns + 0.5)*0.005
            if left < x < right and 0.01 < z < 0.03:
                total, count = total + field[start + k], count + 1
        start += columns*90
    return total/count


def results(case, report, drop, weight):
    late = [t for t in case.times() if float(t) > SINCE]
    x, w = upward(case, late)
    alpha = case.fieldValues("alpha.fluidMean")
    spout, beside = columnMean(alpha, -0.005, 0.005), (columnMean(alpha, -0.06, -0.03) + columnMean(alpha, 0.03, 0.06))/2
    nut = case.fieldValues("nut")
    print("fluid fraction in the spout %.3f, beside it %.3f; grains there %.3f and %.3f m/s"
          % (spout, beside, w[abs(x) < 0.005].mean(), w[(abs(x) > 0.03) & (abs(x) < 0.06)].mean()))
    return [("velocity of grains in the spout [m/s]", w[abs(x) < 0.005].mean()),
            ("velocity of grains beside it [m/s]", w[(abs(x) > 0.03) & (abs(x) < 0.06)].mean()),
            ("fluid fraction in the spout less that beside it", spout - beside),
            ("mean pressure drop over weight", drop.mean()/weight),
            ("mean eddy viscosity over viscosity", sum(nut)/len(nut)/NU),
            ("grains lost", report["exited"][-1]),
            ("largest overlap", report["overlapMax"].max()),
            ("largest volume error", report["volumeError"].max())]


def main():
    case = CaseFolder(".")
    report = {key: numpy.array(column) for key, column in case.report().items()}
    times, p = map(numpy.array, case.series("pressureDrop/surfaceFieldValue.dat").values())
    weight = report["grains"][-1]*math.pi/6*D**3*DENSITY*G/AREA
    writeResults(results(case, report, p[times > SINCE], weight))
    figure, axes = newPicture(11, 4, columns=4, width_ratios=(1, 1, 1, 1.3))
    for part, time in zip(axes, TIMES):
        speeds = [u[2] for u in case.cloud("U", time)]
        grains = drawGrains(part, [(1e3*x[0], 1e3*x[2]) for x in case.cloud("position", time)], [1e3*D]*len(speeds), speeds, clim=(-0.5, 1.5))
        part.set(xlim=(-75, 75), ylim=(-40, 200), title="%s s" % time, xlabel="x [mm]")
        part.plot([-75, -5, -5], [0, 0, -40], [75, 5, 5], [0, 0, -40], color="black", linewidth=1)
    axes[0].set_ylabel("z [mm]")
    figure.colorbar(grains, ax=axes[2], label="upward velocity [m/s]")
    x, w = upward(case, [t for t in case.times() if float(t) > SINCE])
    bins = numpy.linspace(-0.075, 0.075, 31)
    which = numpy.digitize(x, bins)
    axes[3].plot(1e3*(bins[:-1] + bins[1:])/2, [w[which == k].mean() if (which == k).any() else math.nan for k in range(1, 31)], "o-", color=BLUE,
                 markersize=4)
    axes[3].axhline(0, color=GRAY, linewidth=1)
    axes[3].set(xlabel="x [mm]", ylabel="upward velocity [m/s]", title="grains 10 to 30 mm up, mean", xlim=(-75, 75))
    savePicture(figure)


main()
