# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Velocities of granules along the duct, their slip against the terminal velocity, mass in and out, and the pressure that lifts them."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

G, DENSITY, AIR, NU, SIDE, HEIGHT, COARSE, FINE, BETWEEN = 9.81, 890.0, 1.205, 1.5e-5, 0.03, 3.0, 1e-3, 0.5e-3, 0.6e-3
START, SINCE, END = 0.2, 1.2, 1.8                   # of the grains; of what means are taken over [s]
FEEDER_FLOW, FINE_FLOW = 2e-3, 4000*DENSITY*math.pi/6*FINE**3    # [kg/s]
CELLS = (6, 6, 300)
FAR = 2.0                                   # above this, grains have the velocity that they keep [m]


def dragAcceleration(slip, d):
    """Of a lone sphere [m/s2], with Dalla Valle's coefficient as Di Felice takes it."""
    Re = abs(slip)*d/NU + 1e-12
    return 0.75*AIR/DENSITY/d*(0.63 + 4.8/math.sqrt(Re))**2*abs(slip)*slip


def terminal(d):
    """Speed at which the drag carries a lone sphere, less buoyancy [m/s]."""
    low, high = 1e-3, 20.0
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (low, middle) if dragAcceleration(middle, d) > G*(1 - AIR/DENSITY) else (middle, high)
    return low


def airAtGrains(case, time, positions):
    """Upward velocity of the air in each grain's cell [m/s]."""
    U = numpy.array(case.fieldValues("U", time))[:, 2].reshape(CELLS[::-1])
    i, j, k = (numpy.clip((positions[:, a]/size*n).astype(int), 0, n - 1) for a, (size, n) in enumerate(zip((SIDE, SIDE, HEIGHT), CELLS)))
    return U[k, j, i]


def grainsAt(case, time):
    """Height, diameter, upward velocity and the air's velocity of all grains, a row each."""
    x, d = numpy.array(case.cloud("position", time)), numpy.array(case.cloud("d", time))
    return numpy.array((x[:, 2], d, numpy.array(case.cloud("U", time))[:, 2], airAtGrains(case, time, x))).T


def lonePath(d, z, w, air):
    """Velocity over height of a lone sphere that starts at height z with w, in air that rises with air(z)."""
    path = [(z, w)]
    while z < HEIGHT:
        w += 1e-3*(dragAcceleration(air(z) - w, d) - G*(1 - AIR/DENSITY))
        z += 1e-3*w
        path.append((z, w))
    return numpy.array(path)


def binned(grains, isCoarse):
    """Middles of height bins, mean velocity of the coarse or fine grains in them, mean of the air at them."""
    edges = numpy.linspace(0, HEIGHT, 31)
    part = grains[(grains[:, 1] > BETWEEN) == isCoarse]
    which = numpy.digitize(part[:, 0], edges) - 1
    full = [k for k in range(30) if (which == k).sum() > 20]
    return [(0.5*(edges[k] + edges[k + 1]), part[which == k, 2].mean(), part[which == k, 3].mean()) for k in full]


def slipShare(grains, isCoarse):
    """Mean over the grains far up of their slip over the terminal velocity of each one's size."""
    part = grains[((grains[:, 1] > BETWEEN) == isCoarse) & (grains[:, 0] > FAR)]
    speeds = numpy.interp(part[:, 1], TERMINAL[0], TERMINAL[1])
    return ((part[:, 3] - part[:, 2])/speeds).mean()


TERMINAL = numpy.array([(d, terminal(d)) for d in numpy.linspace(0.3e-3, 1.4e-3, 23)]).T


def momentumShare(case, report, drop, times):
    """Pressure that the grains cost over what lifts and speeds them up: their weight, and the momentum that leaves with them (that at the inlet less)."""
    clear = drop[1][(drop[0] > 0.15) & (drop[0] <= START)].mean()
    cost = (drop[1][drop[0] > SINCE].mean() - clear)*SIDE**2
    mass = report["enteredMass"]
    late = report["time"] > SINCE
    weight = G*numpy.mean([(DENSITY*math.pi/6*numpy.array(case.cloud("d", t))**3).sum() for t in times])
    out = numpy.concatenate([grainsAt(case, t) for t in times])
    out = out[out[:, 0] > HEIGHT - 0.3]
    flux = (out[:, 1]**3*out[:, 2]).sum()/(out[:, 1]**3).sum()*(mass[late][-1] - mass[late][0])/(report["time"][late][-1] - report["time"][late][0])
    print("pressure drop: clear air %.1f Pa, grains %.1f Pa more; their weight %.1f Pa, momentum that leaves %.1f Pa, that comes %.1f Pa"
          % (clear, cost/SIDE**2, weight/SIDE**2, flux/SIDE**2, FINE_FLOW*8/SIDE**2))
    return cost/(weight + flux - FINE_FLOW*8), clear


def results(case, report, drop, times, out):
    grains = numpy.concatenate([grainsAt(case, t) for t in times])
    late = out["Time"] > SINCE
    rate = numpy.polyfit(out["Time"][late], out["outlet.mass"][late], 1)[0]
    fed = FEEDER_FLOW + FINE_FLOW
    inside = (DENSITY*math.pi/6*numpy.array(case.cloud("d"))**3).sum()
    share, clear = momentumShare(case, report, drop, times)
    print("slip over terminal velocity: granules %.3f, fine ones %.3f; mass out %.4g g/s for %.4g g/s" % (slipShare(grains, True), slipShare(grains, False),
                                                                                                     1e3*rate, 1e3*fed))
    return [("slip of granules over their terminal velocity", slipShare(grains, True)), ("slip of fine grains over theirs", slipShare(grains, False)),
            ("mass flow out over mass flow in", rate/fed), ("entered less inside and out", report["entered"][-1] - report["grains"][-1] - out["outlet.number"][-1]),
            ("mass inside and out over mass entered", (inside + out["outlet.mass"][-1])/report["enteredMass"][-1]),
            ("waiting to enter", report["waiting"][-1]), ("pressure drop of clear air [Pa/m]", clear/HEIGHT),
            ("pressure that grains cost over their weight and momentum", share),
            ("largest overlap", report["overlapMax"].max()), ("largest volume error", report["volumeError"].max())]


def main():
    case = CaseFolder(".")
    report = {key: numpy.array(column) for key, column in case.report().items()}
    drop = numpy.array(list(case.series("pressureDrop/surfaceFieldValue.dat").values()))
    out = {key: numpy.array(column) for key, column in case.series("flux/grainFlux.dat").items()}
    times = [t for t in case.times() if float(t) > SINCE]
    writeResults(results(case, report, drop, times, out))
    figure, axes = newPicture(11, 4, columns=4, width_ratios=(0.5, 2, 2, 2))
    positions, sizes = numpy.array(case.cloud("position")), numpy.array(case.cloud("d"))
    grains = numpy.concatenate([grainsAt(case, t) for t in times])
    for isCoarse, color, label, d in ((True, ORANGE, "granules, 1 mm", COARSE), (False, BLUE, "fine grains, 0.5 mm", FINE)):
        part = (sizes > BETWEEN) == isCoarse
        axes[0].plot(1e3*positions[part, 0], positions[part, 2], ".", markersize=1e3*d, color=color)
        z, w, air = numpy.array(binned(grains, isCoarse)).T
        axes[1].plot(z, w, "o", color=color, markersize=4, label=label)
        path = lonePath(d, z[0], w[0], lambda height: numpy.interp(height, z, air))
        axes[1].plot(*path.T, "-", color=color, linewidth=1, label="one alone in that air")
    axes[0].set(xlim=(0, 30), ylim=(0, 3), xlabel="x [mm]", ylabel="height [m]")
    axes[0].grid(False)
    axes[1].set(xlabel="height [m]", ylabel="upward velocity [m/s]", xlim=(0, 3), ylim=(0, None))
    mass = 1e3*numpy.array(report["enteredMass"])
    axes[2].plot(report["time"], mass, color=BLUE, label="entered")
    axes[2].plot(out["Time"], 1e3*out["outlet.mass"], color=ORANGE, label="left")
    axes[2].set(xlabel="time [s]", ylabel="mass [g]", xlim=(0, END), ylim=(0, None))
    axes[3].plot(*drop, color=BLUE)
    axes[3].set(xlabel="time [s]", ylabel="pressure drop [Pa]", xlim=(0, END), ylim=(0, 1.3*drop[1][len(drop[1])//2:].max()))
    for part in axes[1:3]:
        part.legend()
    savePicture(figure)


main()
