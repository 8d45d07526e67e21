# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What the box holds at the end, and how the grains got there; draws cuts through it."""

import numpy as np
from matplotlib.patches import Circle
from pictures import BLUE, ORANGE, newPicture, savePicture, writeResults
from vtkFiles import readReport, readVtp, timesOf

G, WIDTH, D = 9.81, 0.12, 0.01
CUT = 0.054                                # y of the picture, through a layer of the lattice [m]
DENSITY = np.array([2500.0, 7800.0])       # of glass and steel, as the scene lists them
SHOWN = (0.05, 0.15, 1.0)                  # s


def solidFraction(grains, lower, upper, points=36):
    """Share of a regular grid of points in a box that lie in grains."""
    axes = [np.linspace(lower[k], upper[k], points) for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    isSolid = np.zeros(len(grid), bool)
    for center, diameter in zip(grains["position"], grains["d"]):
        isSolid |= ((grid - center)**2).sum(axis=1) < diameter**2/4
    return isSolid.mean()


def contactsPerGrain(contacts, number):
    """Contacts of a grain in the mean, those with walls included."""
    return (len(contacts["idA"]) + np.count_nonzero(contacts["idB"] >= 0))/number


def draw(axes, grains, time):
    """A cut along the box; balls of steel from the side."""
    for center, diameter, material in zip(grains["position"], grains["d"], grains["material"]):
        off = 0 if material == 1 else center[1] - CUT
        if abs(off) < diameter/2:
            radius = np.sqrt(diameter**2/4 - off**2)
            isBall = material == 1
            axes.add_patch(Circle((center[0], center[2]), radius, facecolor=ORANGE if isBall else BLUE, edgecolor="white",
                                  linewidth=0.4, zorder=3 if isBall else 2))
    axes.plot([0, 0, WIDTH, WIDTH], [0.28, 0, 0, 0.28], color="black")
    axes.set(xlim=(-0.005, WIDTH + 0.005), ylim=(-0.005, 0.28), title="%g s" % time, xlabel="x [m]")
    axes.set_aspect("equal")
    axes.grid(False)


def main():
    report = readReport("results/report.csv")
    times = timesOf("results/grains.pvd")
    grains = readVtp("results/" + times[-1][1])
    contacts = readVtp("results/" + timesOf("results/contacts.pvd")[-1][1])
    mass = DENSITY[grains["material"]]*np.pi/6*grains["d"]**3
    weight = G*mass.sum()
    energy = 0.5*(mass*(grains["U"]**2).sum(axis=1)).sum()
    first, later = report[0], report[report["time"].searchsorted(0.0395)]
    with open("results/state/state.000001000", "rb") as whole, open("stopped/results/state/state.000001000", "rb") as stopped:
        isSame = whole.read() == stopped.read()
    writeResults([("fall of the mass center from 1 to 40 ms", first["massCenterZ"] - later["massCenterZ"]),
                  ("floor force over weight", -report["wallForceZ"][-1]/weight),
                  ("kinetic energy of the centers over m g d", energy/(weight*D)),
                  ("largest overlap", report["overlapMax"].max()),
                  ("steps at the cap", np.count_nonzero(report["converged"] == 0)),
                  ("contacts per grain", contactsPerGrain(contacts, len(grains["d"]))),
                  ("solid fraction in the middle", solidFraction(grains, (0.02, 0.02, 0.02), (0.1, 0.1, 0.08))),
                  ("bits that a stop at 0.5 s changes", 0 if isSame else 1)])
    figure, columns = newPicture(9, 5.2, columns=3, sharey=True)
    for axes, shown in zip(columns, SHOWN):
        time, name = min(times, key=lambda entry: abs(entry[0] - shown))
        draw(axes, readVtp("results/" + name), time)
    columns[0].set_ylabel("z [m]")
    savePicture(figure)


main()
