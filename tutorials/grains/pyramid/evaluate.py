# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Impulses of the standing pyramid over m g dt, and how far each top disc has come down; draws both pyramids."""

import math

from foamCase import CaseFolder
from pictures import ORANGE, drawGrains, newPicture, savePicture, writeResults

G, DELTA_T, DENSITY, THICKNESS, D = 9.81, 1e-3, 2500.0, 0.01, 0.02
UNIT = DENSITY*math.pi/4*D**2*THICKNESS*G*DELTA_T      # m g dt
FLOOR = -1


def impulses(case):
    """Impulse that each contact gives its first grain, over m g dt: {(idA, idB): (x, y)}."""
    rows = zip(*(case.cloud(name, cloud="contacts") for name in ("idA", "idB", "impulse")))
    return {(int(a), int(b)): (r[0]/UNIT, r[1]/UNIT) for a, b, r in rows}


def frame(impulse, angle):
    """Normal and tangential part, for a normal at this angle to the x axis."""
    n = (math.cos(angle), math.sin(angle))
    return impulse[0]*n[0] + impulse[1]*n[1], abs(impulse[0]*n[1] - impulse[1]*n[0])


def sink(case):
    """How far the top disc has come down."""
    return D/2 + D*math.sin(math.pi/3) - case.cloud("position")[2][1]


def draw(axes, case, title, found=None):
    centers = case.cloud("position")
    drawGrains(axes, centers, case.cloud("d"), edgecolors="white")
    for (a, b), r in (found or {}).items():
        if math.hypot(*r) < 1e-6:
            continue
        other = (centers[a][0], 0) if b == FLOOR else centers[b]
        reach = 1.0 if b == FLOOR else 0.5
        x, y = ((1 - reach)*c + reach*o for c, o in zip(centers[a][:2], other))
        axes.annotate("", xytext=(x, y), xy=(x + 0.008*r[0], y + 0.008*r[1]),
                      arrowprops={"arrowstyle": "->", "color": ORANGE, "lw": 2})
    axes.axhline(0, color="black")
    axes.set(xlim=(-0.043, 0.043), ylim=(-0.003, 0.042), title=title, xlabel="x [m]")


def main():
    standing, slippery = CaseFolder("."), CaseFolder("slippery")
    found = impulses(standing)
    base, top = frame(found[(0, FLOOR)], math.pi/2), frame(found[(0, 2)], -2*math.pi/3)
    writeResults([("floor normal impulse", base[0]), ("floor friction impulse", base[1]),
                  ("top normal impulse", top[0]), ("top friction impulse", top[1]),
                  ("base impulse", math.hypot(*found.get((0, 1), (0, 0)))),
                  ("standing sink", sink(standing)), ("slippery sink", sink(slippery))])
    figure, (left, right) = newPicture(9, 2.8, columns=2, sharey=True)
    draw(left, standing, "friction 0.270: stands", found)
    draw(right, slippery, "friction 0.265: falls")
    left.set_ylabel("y [m]")
    savePicture(figure)


main()
