# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Discharge of the hopper in water and dry: against Beverloo's law, against each other, and what is left of all grains."""

import math

import numpy

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, drawGrains, newPicture, savePicture, writeResults

G, D, DENSITY, WATER, MU = 9.81, 2e-3, 2500.0, 1000.0, 1e-3
SLOT, DEPTH, OPENED = 16e-3, 8e-3, 0.4
BULK = 0.6*DENSITY                          # density of the packing [kg/m3]
MASS = DENSITY*math.pi/6*D**3


def discharge(folder):
    """Times since the gate dropped, and the mass that has come through the slot [kg], net."""
    column = CaseFolder(folder).series("flux/grainFlux.dat")
    mass = numpy.array(column["slot.massForward"]) - numpy.array(column["slot.massBackward"])
    return numpy.array(column["Time"]) - OPENED, mass


def rate(times, mass, first, last):
    """While shares first to last of all that comes out come out [kg/s]."""
    use = (mass > first*mass[-1]) & (mass < last*mass[-1])
    return numpy.polyfit(times[use], mass[use], 1)[0]


def beverloo():
    """Of a slot: 1.03 rho_b g^1/2 W (D - 1.4 d)^3/2 (Brown & Richards 1970), times (tan 30 tan 45)^-0.35 for a funnel whose walls lean by
    30 degrees from the vertical (Rose & Tanaka 1959, Nedderman 1992)."""
    return 1.03*BULK*math.sqrt(G)*DEPTH*(SLOT - 1.4*D)**1.5*math.tan(math.radians(30))**-0.35


def terminalSpeed():
    """Of one bead in water, Schiller and Naumann's law."""
    low, high = 0.0, 5.0
    while high - low > 1e-9:
        u = 0.5*(low + high)
        Re = WATER*u*D/MU
        drag = 3*math.pi*MU*D*u*max(1 + 0.15*Re**0.687, 0.44*Re/24)
        low, high = (u, high) if drag < (DENSITY - WATER)*G*math.pi/6*D**3 else (low, u)
    return low


def results(case, dry, wet):
    wetRate, dryRate = rate(*wet, 0.15, 0.85), rate(*dry, 0.15, 0.85)
    scale = BULK*terminalSpeed()*DEPTH*(SLOT - 2.4*D)
    report = case.report()
    print("rate at 0.6 to 0.85 of the discharge over that at 0.15 to 0.4: dry %.3f, in water %.3f"
          % tuple(rate(*run, 0.6, 0.85)/rate(*run, 0.15, 0.4) for run in (dry, wet)))
    print("discharge dry %.4g kg/s, Beverloo %.4g kg/s; in water %.4g kg/s, terminal speed %.3g m/s over the slot less 2.4 d %.4g kg/s"
          % (dryRate, beverloo(), wetRate, terminalSpeed(), scale))
    return [("discharge dry over Beverloo's law for slots and funnels", dryRate/beverloo()),
            ("discharge in water over dry", wetRate/dryRate),
            ("discharge in water over slot times terminal speed", wetRate/scale),
            ("rate at 0.3 to 0.45 of the discharge over that before, dry", rate(*dry, 0.3, 0.45)/rate(*dry, 0.15, 0.3)),
            ("grains counted in the slot, inside above and below it, over all", (wet[1][-1]/MASS + sum(p[2] > 0.06 for p in case.cloud("position")))
             /report["grains"][0]),
            ("largest overlap", max(report["overlapMax"])),
            ("largest volume error", max(report["volumeError"])),
            ("grains", report["grains"][-1])]


def outline(axes):
    """Of the hopper and the tank [mm]."""
    axes.plot([-40, 40, 40, -40, -40], [0, 0, 190, 190, 0], color="black", linewidth=1)
    for side in (-1, 1):
        axes.fill([24*side, 8*side, 16*side, 16*side, 24*side], [60, 60, 74, 170, 170], color="0.7")


def main():
    case, dryCase = CaseFolder("."), CaseFolder("dry")
    wet, dry = discharge("."), discharge("dry")
    figure, axes = newPicture(10, 4, columns=4, width_ratios=(1.7, 1, 1, 1))
    axes[0].plot(dry[0], 1e3*dry[1], color=ORANGE, label="dry")
    axes[0].plot(wet[0], 1e3*wet[1], color=BLUE, label="in water")
    start = dry[0][numpy.argmax(dry[1] > 0.02*dry[1][-1])]
    axes[0].plot([start, start + 1e-3/beverloo()*1e3*dry[1][-1]], [0, 1e3*dry[1][-1]], "--", color=GRAY, label="Beverloo")
    axes[0].set(xlabel="time since the gate dropped [s]", ylabel="mass through the slot [g]", xlim=(-0.05, 0.8), ylim=(0, None))
    axes[0].legend()
    for part, (run, time, title) in zip(axes[1:], ((dryCase, "0.6", "dry, 0.2 s"), (case, "0.6", "in water, 0.2 s"), (case, "1", "in water, 0.6 s"))):
        positions = run.cloud("position", time)
        speeds = [math.sqrt(sum(u*u for u in v)) for v in run.cloud("U", time)]
        grains = drawGrains(part, [(1e3*p[0], 1e3*p[2]) for p in positions], [1e3*D]*len(positions), speeds, clim=(0, 0.5))
        outline(part)
        part.set(xlim=(-42, 42), ylim=(-2, 192), title=title, xlabel="x [mm]")
    axes[1].set_ylabel("z [mm]")
    figure.colorbar(grains, ax=axes[3], label="speed [m/s]")
    savePicture(figure)
    writeResults(results(case, dry, wet))


main()
