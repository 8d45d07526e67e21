# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W3: 1000 spheres on a plane that do not meet, sliding until they roll (A05) and on an incline about the angle where they begin to slide (A06):
largest error of velocity and place against the analytic motion, and run time, for time steps of rigid spheres, ours and Siconos', and stiffnesses of
soft ones, LIGGGHTS', LAMMPS' and Yade's."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent/"peers"))
from plainRuns import atRest, installed, ours, theirs
from plainScene import Grain, PlainScene, Plane, softStep
from results import Table, pyplot, savePicture

G, PITCH, LANE = 9.81, 2e-3, 30e-3       # side by side, each in a lane along x of its own
GRAINS, RADIUS, DENSITY = 1000, 0.5e-3, 1e4
SLIDING = (0.2, 0.3, 0.5, 0.7, 1.0)                 # friction of A05
V0 = 0.1
TILT = math.radians(20)
CRITICAL = 2/7*math.tan(TILT)
LADDER = (0.5, 0.9, 0.97, 0.99, 0.997, 1.003, 1.01, 1.03, 1.1, 2.0)     # friction of A06 over the critical one
TIMES = {"A05": [4e-3*k for k in range(1, 9)], "A06": [16e-3*k for k in range(1, 9)]}
STEPS = {"A05": (4e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 2e-5), "A06": (16e-3, 4e-3, 1e-3, 2e-4)}
SICONOS_STEPS = {"A05": (4e-3, 1e-3, 2e-4), "A06": (16e-3, 4e-3, 1e-3)}
MODULI = (1e5, 1e6, 1e7, 1e8)
ROLLING = 1e-3      # slip over speed below which a grain rolls


def sceneOf(case):
    frictions = SLIDING if case == "A05" else tuple(CRITICAL*share for share in LADDER)
    grains = []
    for k in range(GRAINS):
        radius = RADIUS*(1 if case == "A05" else 0.8 + 0.4*(k//len(frictions))/99)
        speed = V0*(0.5 + 0.5*(k//len(frictions))/199) if case == "A05" else 0.0
        grains.append(Grain((PITCH, (k + 1)*PITCH, radius), radius, k % len(frictions), (speed, 0.0, 0.0)))
    tilt = 0.0 if case == "A05" else TILT
    return PlainScene(grains, [Plane(2, 0.0)], (0, 0, -PITCH), (LANE, (GRAINS + 1)*PITCH, PITCH), DENSITY, frictions, 0.5,
                      (G*math.sin(tilt), 0.0, -G*math.cos(tilt)), V0)


def sliding(grain, friction, t):
    """A05: distance, speed and speed of the surface omega R at a time."""
    v0 = grain.v[0]
    end = 2*v0/(7*friction*G)
    s = min(t, end)
    return v0*s - 0.5*friction*G*s*s + 5/7*v0*(t - s), v0 - friction*G*s, 2.5*friction*G*s


def inclined(grain, friction, t):
    """A06: rolls if friction >= 2/7 tan(tilt)."""
    a = 5/7*G*math.sin(TILT) if friction >= CRITICAL else G*(math.sin(TILT) - friction*math.cos(TILT))
    turn = a if friction >= CRITICAL else 2.5*friction*G*math.cos(TILT)
    return 0.5*a*t*t, a*t, turn*t


def errors(case, scene, times, found):
    """Percent: largest error over grains and times of velocity, spin and distance, in shares of the grain's largest speed or distance; by how much the
    friction at which grains start to roll is missed, as far as the ladder tells; the error of speeds, and of distances alone."""
    exact = sliding if case == "A05" else inclined
    speed, distance, threshold = 0.0, 0.0, 0.0
    for i, grain in enumerate(scene.grains):
        friction = scene.friction[grain.material]
        end, last = exact(grain, friction, times[-1]), found[-1][i]
        largest = max(end[1], grain.v[0])
        for t, rows in zip(times, found):
            x, v, turn = exact(grain, friction, t)
            speed = max(speed, abs(rows[i][3] - v)/largest, abs(rows[i][7]*grain.radius - turn)/largest)
            distance = max(distance, abs(rows[i][0] - grain.x[0] - x)/end[0])
        isRolling = abs(last[3] - last[7]*grain.radius) < ROLLING*last[3]
        if case == "A06" and isRolling != (friction >= CRITICAL):
            threshold = max(threshold, abs(friction/CRITICAL - 1))
    return 100*max(speed, distance), 100*threshold, 100*speed, 100*distance


def addRow(table, case, code, knob, scene, deltaT, times, run):
    figures, found = run
    error, *each = errors(case, scene, times, found)
    table.add(case, code, knob, deltaT, error, figures["seconds"], *each, int(figures["steps"]))


def measure(table, softPeers, rigidPeers):
    for case in TIMES:
        scene, times = sceneOf(case), TIMES[case]
        for deltaT in STEPS[case]:
            addRow(table, case, "nscdDEMFoam", "dt %g s" % deltaT, scene, deltaT, times, ours("W3", scene, times, deltaT=deltaT, sleep=0))
        for modulus in MODULI:
            deltaT = softStep(scene, modulus)
            at = [max(1, round(t/deltaT))*deltaT for t in times]
            for peer in softPeers:
                addRow(table, case, peer, "E %.0e Pa" % modulus, scene, deltaT, at, theirs(peer, "W3", atRest(scene, modulus), modulus, times))
        for peer in rigidPeers:
            for deltaT in SICONOS_STEPS[case]:
                addRow(table, case, peer, "dt %g s" % deltaT, scene, deltaT, times, theirs(peer, "W3", scene, deltaT, times))


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for case, axis in zip(TIMES, axes):
        for code in dict.fromkeys(table.column("code")):
            axis.loglog(table.column("seconds", case=case, code=code), table.column("errorPercent", case=case, code=code), "o-", label=code)
        axis.set_title(case)
        axis.set_xlabel("processor time less start-up [s]")
        axis.set_ylabel("largest error of velocity, spin and place [%]")
        axis.legend(fontsize=7)
    savePicture(figure, "W3")


if __name__ == "__main__":
    there = installed("LIGGGHTS", "LIGGGHTS undamped", "LAMMPS", "Yade"), installed("Siconos")
    draw(Table("W3", ["case", "code", "knob", "deltaT", "errorPercent", "seconds", "thresholdErrorPercent", "speedErrorPercent", "distanceErrorPercent", "steps"],
               larger=("errorPercent", "thresholdErrorPercent", "seconds")).inRounds(lambda table: measure(table, *there)))
