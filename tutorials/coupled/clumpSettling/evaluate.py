# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Speeds of lone rods against the law, and what the heap of rods weighs and holds."""

import math

from foamCase import CaseFolder
from pictures import drawGrains, newPicture, savePicture, writeResults

G, R, RHO_P, RHO_F, NU, RODS = 9.81, 2e-3, 2500.0, 1200.0, 1e-4, 192
# Three balls of radius R whose centers are R apart: volume, surface, and shadow along and across the rod.
VOLUME, SURFACE = 19/6*math.pi*R**3, 8*math.pi*R**2
SHADOWS = {"along": math.pi*R**2, "across": 3*math.pi*R**2 - 2*R**2*(2*math.pi/3 - math.sqrt(3)/2)}
D = (6*VOLUME/math.pi)**(1/3)
SPHERICITY = math.pi*D**2/SURFACE


def terminalSpeed(shadow):
    """Where weight less buoyancy is drag: Hoelzer & Sommerfeld 2008, by bisection."""
    crosswise = math.pi/4*D**2/shadow
    low, high = 1e-6, 10.0
    for _ in range(100):
        v = math.sqrt(low*high)
        re = v*D/NU
        cd = (8/math.sqrt(crosswise) + 16/math.sqrt(SPHERICITY))/re + 3/math.sqrt(re)/SPHERICITY**0.75 \
            + 0.42*10**(0.4*(-math.log10(SPHERICITY))**0.2)/crosswise
        if 0.5*RHO_F*math.pi/4*D**2*cd*v**2 > (RHO_P - RHO_F)*VOLUME*G:
            high = v
        else:
            low = v
    return low


def lastSpeed(report):
    (t0, t1), (z0, z1) = report["time"][-2:], report["massCenterZ"][-2:]
    return (z0 - z1)/(t1 - t0)


def draw(case):
    """The rods from the side; the members of one have one color."""
    figure, panels = newPicture(7, 5, columns=3, sharey=True)
    for axes, time in zip(panels, ("0.5", "1", "4")):
        centers = [(1e3*x, 1e3*z) for x, _, z in case.cloud("position", time)]
        diameters = [1e3*d for d in case.cloud("d", time)]
        colors = [rod*7919 % 101 for rod in case.cloud("clump", time)]
        drawGrains(axes, centers, diameters, colors, linewidths=0.3, edgecolors="black")
        axes.set(xlim=(-25, 25), ylim=(0, 200), xlabel="x [mm]", title=time + " s")
    panels[0].set_ylabel("z [mm]")
    savePicture(figure)


def main():
    case = CaseFolder(".")
    report = case.report()
    weight = RODS*(RHO_P - RHO_F)*VOLUME*G
    rows = [("speed over law %s" % way, lastSpeed(CaseFolder(way).report())/terminalSpeed(SHADOWS[way])) for way in ("across", "along")]
    rows.append(("largest error of solid volume", max(abs(v/(RODS*VOLUME) - 1) for v in report["solidVolume"])))
    rows.append(("largest momentum error", max(report["momentumError"])))
    rows.append(("force on the floor over weight", -report["wallForceZ"][-1]/weight))
    rows.append(("largest overlap", max(report["overlapMax"])))
    rows.append(("balls lost", 3*RODS - report["grains"][-1]))
    writeResults(rows)
    draw(case)


main()
