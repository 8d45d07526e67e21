# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Temperatures along the bed against the closed form of Schumann (1929) with Gunn's law, and what the heat balance leaves."""

import math

from foamCase import CaseFolder
from pictures import BLUE, GRAY, ORANGE, newPicture, savePicture, writeResults

D, HEIGHT, AREA, COLD, HOT = 4e-3, 0.12, 0.024**2, 300.0, 400.0
SPEED, RHO, CP, K, NU = 1.0, 1.2, 1005.0, 0.026, 1.5e-5   # superficial; air
HEAT_CAPACITY = 2500*840.0
TIMES = (30, 60, 90)


def gunn(alpha):
    """h a by volume of bed [W/(m3 K)]."""
    Re, prandtl = SPEED*D/NU, (NU*RHO*CP/K)**(1/3)
    nusselt = (7 - 10*alpha + 5*alpha**2)*(1 + 0.7*Re**0.2*prandtl) + (1.33 - 2.4*alpha + 1.2*alpha**2)*Re**0.7*prandtl
    return nusselt*K/D*6*(1 - alpha)/D


def poisson(mean, terms=250):
    shares = [math.exp(-mean)]
    for k in range(1, terms):
        shares.append(shares[-1]*mean/k)
    return shares


def closedForm(alpha, x, t):
    """Temperatures of air and grains: tests/validation/heatedBed has the formula."""
    byPlace = poisson(gunn(alpha)/(SPEED*RHO*CP)*x)
    byTime = poisson(gunn(alpha)/((1 - alpha)*HEAT_CAPACITY)*(t - x*alpha/SPEED))
    fluid = solid = total = 0.0
    for place, time in zip(byPlace, byTime):
        solid += time*total
        total += place
        fluid += time*total
    return COLD + (HOT - COLD)*fluid, COLD + (HOT - COLD)*solid


def main():
    case = CaseFolder(".")
    diameters = case.cloud("d", "30")
    alpha = 1 - sum(math.pi/6*d**3 for d in diameters)/(AREA*HEIGHT)
    figure, axes = newPicture(6, 3.5)
    line = [HEIGHT*k/100 for k in range(101)]
    results = []
    for time in TIMES:
        air = case.fieldValues("T", str(time))
        middles = [(k + 0.5)*HEIGHT/len(air) for k in range(len(air))]
        places = [x[2] for x in case.cloud("positions", str(time))]
        grains = case.cloud("T", str(time))
        results.append(("largest error of the air at %d s over 100 K" % time,
                        max(abs(T - closedForm(alpha, x, time)[0]) for T, x in zip(air, middles))/(HOT - COLD)))
        warm = sum(grains)/len(grains)
        results.append(("mean temperature of the grains at %d s over the closed form" % time,
                        (warm - COLD)/(sum(closedForm(alpha, x, time)[1] for x in middles)/len(middles) - COLD)))
        axes.plot([1e3*x for x in places], grains, ".", color=ORANGE, markersize=2, label="grains" if time == 30 else None)
        axes.plot([1e3*x for x in middles], air, "o", color=BLUE, markersize=3, label="air" if time == 30 else None)
        for part in (0, 1):
            axes.plot([1e3*x for x in line], [closedForm(alpha, x, time)[part] for x in line], color=GRAY, linewidth=1,
                      label="Schumann 1929" if time == 30 and part == 0 else None)
    report = case.report()
    leftOver = max(abs(e)/(f + g) for e, f, g in zip(report["heatError"], report["heatFluid"], report["heatGrains"]))
    writeResults(results + [("heat not accounted for", leftOver)])
    axes.set(xlim=(0, 1e3*HEIGHT), xlabel="height [mm]", ylabel="temperature [K]")
    axes.legend()
    savePicture(figure)


main()
