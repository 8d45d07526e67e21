# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Velocities in the periodic boxes against the closed form, and the fronts of the column against Kynch's theory (1952)."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

G, RHO_P, RHO_F, MU = 9.81, 2500.0, 1200.0, 0.1
PITCH = 1.5e-3                                     # of the lattice in the boxes [m]
D, SIDE, HEIGHT, LAYER = 1e-3, 8.27e-3, 0.06, 2e-3   # the column, and the layers in which its solid fraction is read [m]


def hinderedSpeed(phi, d):
    """With no net volume flux."""
    return (RHO_P - RHO_F)*G*d**2/(18*MU)*(1 - phi)**4.8


def responseTime(phi, d):
    return (RHO_P + RHO_F*phi/(1 - phi))*(1 - phi)**4.8*d**2/(18*MU)


def boxVelocity(name):
    """Times and velocities of the mass center, at the ends of steps; diameter and solid fraction."""
    case = CaseFolder(name)
    report = case.report()
    d = case.cloud("d")[0]
    t, z = numpy.array(report["time"]), numpy.array(report["massCenterZ"])
    z0 = 0.5*4*PITCH                               # of the lattice at the start
    return t, -numpy.diff(z, prepend=z0)/t[0], d, math.pi/6*d**3/PITCH**3


def drawBoxes(axes):
    """All three, and the figures to judge."""
    rows = []
    for name, color in (("box10", BLUE), ("box20", ORANGE), ("box30", GRAY)):
        t, v, d, phi = boxVelocity(name)
        exact = hinderedSpeed(phi, d)*(1 - numpy.exp(-t/responseTime(phi, d)))
        axes.plot(1e3*t[4::12], 1e3*v[4::12], "o", color=color, markersize=4, label="$\\phi_0$ = %.1f" % phi)
        axes.plot(1e3*t, 1e3*exact, color=color, linewidth=1)
        rows.append(("settling speed over closed form at solid fraction %.1f" % phi, v[-1]/exact[-1]))
        rows.append(("largest error on the way at solid fraction %.1f" % phi, abs(v - exact).max()/exact[-1]))
    axes.set(xlabel="time [ms]", ylabel="settling speed [mm/s]", title="periodic boxes", xlim=(0, 6), ylim=(0, None))
    axes.legend()
    return rows


def solidFractions(case, time):
    """By layers, from the bottom."""
    z = numpy.array(case.cloud("position", time))[:, 2]
    levels = LAYER*numpy.arange(round(HEIGHT/LAYER) + 1)
    h = numpy.clip(levels[:, None] - z[None, :] + D/2, 0, D)       # of each grain, below each level
    below = (math.pi*h**2*(D/2 - h/3)).sum(axis=1)
    return numpy.diff(below)/(SIDE**2*LAYER)


def crossing(profile, level, downward):
    """Height at which the solid fraction crosses a level, coming from above (downward) or from the bottom."""
    order = range(len(profile) - 1, -1, -1) if downward else range(len(profile))
    for k in order:
        if (profile[k] > level) == downward:
            other = k + 1 if downward else k - 1
            share = (profile[k] - level)/(profile[k] - profile[other]) if 0 <= other < len(profile) else 0
            return (k + 0.5 + share*(other - k))*LAYER
    return 0.0


def frontSpeed(times, heights, first, last):
    """Of a line through the front between two times."""
    use = (times >= first) & (times <= last)
    return numpy.polyfit(times[use], heights[use], 1)[0]


def drawColumn(figure, axes, case):
    names = case.times()[1:]
    times = numpy.array([float(t) for t in names])
    map2D = numpy.array([solidFractions(case, t) for t in names])
    phi0 = case.report()["grainVolume"][0]/(SIDE**2*HEIGHT)
    packed = map2D[-1][2:-1][map2D[-1][2:-1] > 0.5].mean()
    v = hinderedSpeed(phi0, D)
    rise, end = v*phi0/(packed - phi0), HEIGHT*(1 - phi0/packed)/v
    axes.grid(False)
    image = axes.pcolormesh(times, 1e3*(numpy.arange(map2D.shape[1]) + 0.5)*LAYER, map2D.T, cmap="viridis", shading="nearest", vmin=0)
    figure.colorbar(image, ax=axes, label="solid fraction")
    axes.plot((0, end), (1e3*HEIGHT, 1e3*rise*end), color="white", label="Kynch 1952")
    axes.plot((0, end), (0, 1e3*rise*end), color="white")
    axes.set(xlabel="time [s]", ylabel="height [mm]", title="batch settling", xlim=(0, times[-1]), ylim=(0, 1e3*HEIGHT))
    axes.legend(labelcolor="white")
    top = numpy.array([crossing(p, phi0/2, True) for p in map2D])
    deposit = numpy.array([crossing(p, (phi0 + packed)/2, False) for p in map2D])
    return [("fall of the upper front over theory", -frontSpeed(times, top, 1, 0.7*end)/v),
            ("rise of the deposit over theory", frontSpeed(times, deposit, 3, 0.8*end)/rise),
            ("solid fraction of the deposit", packed),
            ("largest overlap", max(case.report()["overlapMax"])),
            ("grains", case.report()["grains"][-1])]


def main():
    figure, (left, right) = newPicture(9, 3.8, columns=2)
    rows = drawBoxes(left)
    rows += drawColumn(figure, right, CaseFolder("."))
    writeResults(rows)
    savePicture(figure)


main()
