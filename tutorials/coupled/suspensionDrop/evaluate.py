# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The drop at four times, its fall with steps of 10 and of 20 ms, and the speed of a drop between walls in creeping flow."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

G, D, DENSITY, LIQUID, MU, RADIUS, HALF_WIDTH = 9.81, 100e-6, 2450.0, 1030.0, 0.585, 3.3e-3, 0.05
FROM, TO = 2.0, 4.0           # s, between which the speed is taken
TIMES = ("0.5", "2", "3.5", "5")


def creepingSpeed(positions):
    """Of the mass center of discs at these places, half way between two walls, without inertia [m/s].

    W/(4 pi mu) (ln l - 1.4157 + 1.7244 (R/l)^2 + <-ln r + (y/r)^2>), the mean taken over all pairs. For a rigid cylinder that mean is 1/2 - ln R,
    which leaves Faxen's W/(4 pi mu) (ln(l/R) - 0.9157 + 1.7244 (R/l)^2) (1946, in Happel & Brenner 1965, 7-6)."""
    apart = positions[:, None, :2] - positions[None, :, :2]
    squares = (apart**2).sum(axis=2)
    numpy.fill_diagonal(squares, 1.0)
    number = len(positions)
    mean = (apart[..., 1]**2/squares - 0.5*numpy.log(squares)).sum()/(number*(number - 1))
    weight = number*math.pi/4*D**2*(DENSITY - LIQUID)*G
    return weight/(4*math.pi*MU)*(math.log(HALF_WIDTH) - 1.4157 + 1.7244*(RADIUS/HALF_WIDTH)**2 + mean)


def byId(case, time):
    """Positions in the order of ids [m]."""
    return numpy.array(case.cloud("position", time))[numpy.argsort(case.cloud("origId", time))]


def meanCreepingSpeed(case):
    times = [t for t in case.times() if FROM - 1e-6 < float(t) < TO + 1e-6]
    return numpy.mean([creepingSpeed(numpy.array(case.cloud("position", t))) for t in times])


def fall(report):
    """Times and heights of the mass center, and its mean speed between FROM and TO."""
    t, y = numpy.array(report["time"]), numpy.array(report["massCenterY"])
    use = (t > FROM - 1e-6) & (t < TO + 1e-6)
    return t, y, -numpy.polyfit(t[use], y[use], 1)[0]


def main():
    case, longCase = CaseFolder("."), CaseFolder("longSteps")
    report, longReport = case.report(), longCase.report()
    (t, y, speed), (tLong, yLong, longSpeed) = fall(report), fall(longReport)
    exact, start = meanCreepingSpeed(case), creepingSpeed(numpy.array(case.cloud("position", case.times()[1])))
    late = (yLong[-1] - y[-1])/speed
    print("speed %.4g m/s, with steps of 20 ms %.4g m/s; in creeping flow %.4g m/s, at the start %.4g m/s; long steps are late by %.3g s"
          % (speed, longSpeed, exact, start, late))
    positions = numpy.array(case.cloud("position"))
    writeResults([("speed over that in creeping flow", speed/exact), ("speed with long steps over that with short ones", longSpeed/speed),
                  ("speed over that of a disc alone", speed/(2*(DENSITY - LIQUID)*G*(D/2)**2/9/MU)),
                  ("width over the first one", numpy.ptp(positions[:, 0])/(2*RADIUS)), ("grains", report["grains"][-1]),
                  ("largest overlap", max(report["overlapMax"])), ("largest volume error", max(report["volumeError"]))])
    figure, axes = newPicture(11, 4, columns=5, width_ratios=(1, 1, 1, 1, 1.8))
    first = byId(case, TIMES[0])
    depth = numpy.linalg.norm(first - first.mean(axis=0), axis=1)      # colors: from the middle of the drop outwards, at the first time
    for part, time in zip(axes, TIMES):
        positions = 1e3*byId(case, time)
        middle = positions[:, 1].mean()
        part.scatter(positions[:, 0], positions[:, 1] - middle, s=3, c=depth, cmap="viridis")
        part.set(xlim=(-7, 7), ylim=(-8, 14), title="%s s: %.0f mm" % (time, 220 - middle), xlabel="x [mm]", aspect="equal")
    axes[0].set_ylabel("y less that of the mass center [mm]")
    axes[4].plot(t, 1e3*y, color=BLUE, label="steps of 10 ms")
    axes[4].plot(tLong[::5], 1e3*yLong[::5], "o", color=ORANGE, markersize=3, label="steps of 20 ms")
    at = numpy.interp(FROM, t, y)
    axes[4].plot([FROM, TO], [1e3*at, 1e3*(at - exact*(TO - FROM))], "--", color=GRAY, label="creeping flow")
    axes[4].set(xlabel="time [s]", ylabel="height of the mass center [mm]", xlim=(0, t[-1]))
    axes[4].legend()
    savePicture(figure)


main()
