# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Pressure drop against the inflow, up and down, with that of sediFoam and with the weight of the bed."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

G, D, DENSITY, AIR, AREA, PEAK, START, RAMP = 9.8, 1.5e-3, 2000.0, 1.2, 0.04*0.0075, 1.5, 0.5, 3.0
# Xiao and Sun 2011, as sediFoam keeps it for its own test: (inflow [m/s], pressure drop [Pa]), up and down, at 0.1 m/s each second.
UP = ((0.131, 14.5), (0.283, 40.9), (0.438, 80.2), (0.528, 108.8), (0.616, 139.7), (0.741, 190.3), (0.824, 230.3), (1.077, 235.9), (1.269, 238.6),
      (1.483, 224.9))
DOWN = ((1.125, 229.1), (0.820, 219.9), (0.675, 223.1), (0.628, 199.9), (0.547, 160.9), (0.469, 125.0), (0.358, 82.2), (0.228, 41.0), (0.072, 9.8))


def curves():
    """(inflow, pressure drop) up and down, means over 20 ms."""
    t, p = map(numpy.array, CaseFolder(".").series("pressureDrop/surfaceFieldValue.dat").values())
    t, p = (x[:len(x)//20*20].reshape(-1, 20).mean(axis=1) for x in (t, p))
    inflow = PEAK*numpy.maximum(0, 1 - abs(t - START - RAMP)/RAMP)
    up, down = (t > START) & (t <= START + RAMP), t > START + RAMP
    return (inflow[up], p[up]), (inflow[down][::-1], p[down][::-1])


def crossing(curve, weight):
    """Inflow at which the line of the resting bed, from a third to four fifths of the weight, gets to the weight: quadratic in the inflow."""
    inflow, p = curve
    first = numpy.argmax(p > 0.95*weight)
    rest = (numpy.arange(len(p)) < (first or len(p))) & (p > 0.33*weight) & (p < 0.8*weight)
    a, b = numpy.linalg.lstsq(numpy.stack((inflow[rest], inflow[rest]**2), axis=1), p[rest], rcond=None)[0]
    return (-a + math.sqrt(a*a + 4*b*weight))/(2*b)


def at(curve, inflow, width=0.03):
    return curve[1][abs(curve[0] - inflow) < width].mean()


def main():
    report = CaseFolder(".").report()
    weight = report["grains"][-1]*math.pi/6*D**3*(DENSITY - AIR)*G/AREA
    up, down = curves()
    lifted = [c[1][(c[0] > 1) & (c[0] < 1.4)].mean() for c in (up, down)]
    published = [at(up, U)/p for U, p in UP[1:6]]
    print("weight %.1f Pa; over that of sediFoam on the way up: %s" % (weight, " ".join("%.3f" % r for r in published)))
    writeResults([("plateau going up over weight", lifted[0]/weight), ("plateau going down over weight", lifted[1]/weight),
                  ("plateau of sediFoam over ours", 230/numpy.mean(lifted)),
                  ("inflow that lifts the bed, going up [m/s]", crossing(up, weight)), ("inflow that lifts the bed, going down [m/s]", crossing(down, weight)),
                  ("pressure drop at 0.53 m/s over that of sediFoam, going up", at(up, 0.528)/108.8),
                  ("pressure drop at 0.53 m/s over that of sediFoam, going down", at(down, 0.53)/153.0),
                  ("down over up at 0.5 m/s", at(down, 0.5)/at(up, 0.5)),
                  ("largest overlap", max(report["overlapMax"])), ("grains", report["grains"][-1])])
    figure, axes = newPicture(6.5, 4)
    axes.plot(*up, color=BLUE, label="going up")
    axes.plot(*down, color=ORANGE, label="going down")
    axes.plot(*zip(*UP), "o", color=BLUE, markersize=4, markerfacecolor="none", label="sediFoam, up")
    axes.plot(*zip(*DOWN), "s", color=ORANGE, markersize=4, markerfacecolor="none", label="sediFoam, down")
    axes.axhline(weight, color=GRAY, linestyle="--", label="weight of the bed")
    axes.set(xlabel="superficial velocity [m/s]", ylabel="pressure drop [Pa]", xlim=(0, PEAK), ylim=(0, 1.6*weight))
    axes.legend()
    savePicture(figure)


main()
