# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Speed of the settling grain against the exact equation of motion."""

import math

from foamCase import CaseFolder
from pictures import GRAY, ORANGE, newPicture, savePicture, writeResults

G, D, RHO_P, RHO_F, MU = 9.81, 2e-3, 2500.0, 997.0, 997*1.005e-6
MASS = RHO_P*math.pi/6*D**3
MILLISECONDS = (5, 20, 50, 55)


def acceleration(v):
    """Weight less buoyancy and drag, Cd = (0.63 + 4.8/sqrt(Re))^2 (DallaValle)."""
    drag = math.pi/8*D*MU*(0.63*math.sqrt(RHO_F*v*D/MU) + 4.8)**2*v
    return (1 - RHO_F/RHO_P)*G - drag/MASS


def exactSpeed(end, step=5e-5):
    """Times and speeds up to `end`, by Runge-Kutta of fourth order."""
    times, speeds = [0.0], [0.0]
    while times[-1] < end - step/2:
        v = speeds[-1]
        a = acceleration(v)
        b = acceleration(v + step/2*a)
        c = acceleration(v + step/2*b)
        d = acceleration(v + step*c)
        speeds.append(v + step/6*(a + 2*b + 2*c + d))
        times.append(times[-1] + step)
    return times, speeds


def main():
    report = CaseFolder(".").report()
    times = report["time"]
    speeds = [math.sqrt(2*energy/MASS) for energy in report["kineticEnergy"]]
    at = {round(t*1e3): v for t, v in zip(times, speeds)}
    writeResults([("speed at %d ms" % t, at[t]) for t in MILLISECONDS] + [("terminal speed", speeds[-1])])

    figure, axes = newPicture(6, 3.5)
    axes.plot(*exactSpeed(0.3), color=GRAY, label="exact")
    axes.plot(times, speeds, "o", color=ORANGE, markersize=4, label="nscdDEMFoam, steps of 5 ms")
    axes.set(xlim=(0, 0.3), ylim=(0, None), xlabel="time [s]", ylabel="speed [m/s]")
    axes.legend()
    savePicture(figure)


main()
