# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where the dust is and went, and the mean flow across the cyclone."""

import glob
import math

import matplotlib.pyplot as plt
import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

DENSITY, MU, INLET_SPEED, FINDER, FINDER_MOUTH = 1000.0, 1.8e-5, 10.0, 0.02, 0.2    # SI; radius of the finder, height of its mouth over the bin
AIR_FLOW = 2.5*math.pi/2*0.05*0.03                                                  # through a quarter of a wall of 30 mm [m3/s]
SHOWN, MIDWAY, OUTSIDE = "0.4", 0.035, 0.045                                        # s; radii [m]


def profile():
    """x [m], tangential and upward velocity of the mean flow [m/s] across the axis."""
    x, _, v, w = numpy.loadtxt(sorted(glob.glob("postProcessing/profile/*/across_UMean.xy"))[-1]).T
    return x, v*numpy.sign(x), w


def atRadius(x, values, radius):
    """Mean of both sides."""
    return 0.5*(numpy.interp(radius, x, values) + numpy.interp(-radius, x, values))


def barthCutSize(x, tangential):
    """At which the drag of the air that flows inwards holds a grain against the turn, on the cylinder below the finder (Barth 1956) [m]."""
    inwards = AIR_FLOW/(2*math.pi*FINDER*FINDER_MOUTH)
    return math.sqrt(18*MU*inwards*FINDER/(DENSITY*atRadius(x, tangential, FINDER)**2))


def towardsWall(positions):
    """Mean distance of grains from the axis, over that of the wall at their heights."""
    walls = numpy.where(positions[:, 2] < 0.15, 0.02 + 0.2*positions[:, 2], 0.05)
    return (numpy.hypot(positions[:, 0], positions[:, 1])/walls).mean()


def outline(axes):
    """Walls in the plane y = 0 [mm]."""
    for side in (-1, 1):
        axes.plot([20*side, 50*side, 50*side, 23*side], [0, 150, 245, 245], color="black", linewidth=1)
        axes.plot([20*side, 20*side], [200, 285], color="black", linewidth=1)


def results(case, report, flux, x, tangential, upward):
    fastest, binned = max(tangential), flux["bin.mass"][-1]/report["enteredMass"][-1]
    cut, smallest = barthCutSize(x, tangential), min(case.cloud("d", SHOWN))
    print("%d grains entered, %d in the bin (%.3f of the mass); Barth's cut size %.2g um, smallest grain %.3g um; fastest turn %.3g m/s"
          % (report["entered"][-1], flux["bin.number"][-1], binned, 1e6*cut, 1e6*smallest, fastest))
    return [("entered less inside, in the bin and out", report["entered"][-1] - report["grains"][-1] - flux["bin.number"][-1] - flux["outlet.number"][-1]),
            ("out through the finder", flux["outlet.number"][-1]), ("share of the dust's mass in the bin", binned),
            ("distance of the dust from the axis over that of the wall", towardsWall(numpy.array(case.cloud("position")))),
            ("smallest grain over the cut size of Barth", smallest/cut),
            ("fastest turn over that midway to the wall", fastest/atRadius(x, tangential, MIDWAY)),
            ("radius of the fastest turn over that of the finder", abs(x[numpy.argmax(tangential)])/FINDER),
            ("upward velocity of the core [m/s]", atRadius(x, upward, 0.005)), ("upward velocity by the wall [m/s]", atRadius(x, upward, OUTSIDE)),
            ("waiting at the inlet", report["waiting"][-1])]


def drawDust(axes, case, columns, labels):
    positions, sizes = 1e3*numpy.array(case.cloud("position", SHOWN)), numpy.array(case.cloud("d", SHOWN))
    axes.set(xlabel=labels[0], ylabel=labels[1], aspect="equal")
    return axes.scatter(positions[:, columns[0]], positions[:, columns[1]], s=4, c=1e6*sizes, cmap="viridis", clim=(40, 160))


def main():
    case = CaseFolder(".")
    report, flux = case.report(), {key: numpy.array(column) for key, column in case.series("flux/grainFlux.dat").items()}
    x, tangential, upward = profile()
    writeResults(results(case, report, flux, x, tangential, upward))
    figure, axes = newPicture(12, 4.2, columns=4, width_ratios=(1, 1.4, 1.7, 1.7))
    dust = drawDust(axes[0], case, (0, 2), ("x [mm]", "z [mm]"))
    outline(axes[0])
    drawDust(axes[1], case, (0, 1), ("x [mm]", "y [mm]"))
    for radius in (20, 50):
        axes[1].add_patch(plt.Circle((0, 0), radius, fill=False, color="black"))
    axes[1].set(xlim=(-52, 52), ylim=(-52, 52), title="dust at %s s" % SHOWN)
    figure.colorbar(dust, ax=axes[1], label="diameter [$\\mu$m]", orientation="horizontal")
    axes[2].plot(1e3*x, tangential, color=BLUE, label="tangential")
    axes[2].plot(1e3*x, upward, color=ORANGE, label="upward")
    axes[2].axhline(INLET_SPEED, color=GRAY, linestyle="--", label="tangential, at the inlet")
    axes[2].set(xlabel="x [mm]", ylabel="mean velocity [m/s]", title="170 mm up", xlim=(-50, 50))
    axes[3].plot(report["time"], 1e6*numpy.array(report["enteredMass"]), color=BLUE, label="entered")
    axes[3].plot(flux["Time"], 1e6*flux["bin.mass"], color=ORANGE, label="in the bin")
    axes[3].plot(flux["Time"], 1e6*flux["outlet.mass"], color=GRAY, label="out with the air")
    axes[3].set(xlabel="time [s]", ylabel="mass [mg]", xlim=(0, report["time"][-1]))
    for part in axes[2:]:
        part.legend()
    savePicture(figure)


main()
