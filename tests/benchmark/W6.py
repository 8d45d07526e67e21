# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W6: 8000 grains of 0.2 mm on a lattice settle in periodic water (C08, C09; solid fraction 0.3): error of their settling speeds against the exact
one of Ergun's law, which both codes have, and run time, of nscdDEMFoam and OpenFOAM's DPMFoam. `start`: from rest, two response times later,
against the step over the response time (DPMFoam's is 0.58 of ours: the momentum of its mixture is held, and the volume flux of ours). `fall`: after
two and a half lattice steps, in cells of 1.2 to 4.8 diameters (those of 1.2, 2.4 and 4.8 hold equally many grains each), by methods of the void
fraction; `fall by step`: against the step.

errorPercent is rms over the grains, meanErrorPercent that of their mean; a grain's speed is the one relative to the mixture, and the exact one
that of a uniform suspension."""

import math
from collections import namedtuple

from dpmfoamCase import SOLUTION, copyParts, setFields, setGrains
from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

D, RHO_P, RHO, MU, G, PHI = 2e-4, 2650.0, 1000.0, 1e-3, 9.81, 0.3     # C05's grains
ALPHA, COUNT = 1 - PHI, 20
PITCH = D*(math.pi/(6*PHI))**(1/3)
SIDE = COUNT*PITCH
CASES = BUILD/"cases/W6"
START = 2                              # how long grains start [response times of the code's own]
SCHEMES = {"exact": "", "exact, diffusion 3 d": "diffusion 3;", "satellite": "method satellite;", "centroid": "method centroid;"}
SERIES = tuple(("nscdDEMFoam", scheme, mark) for scheme, mark in zip(SCHEMES, ("o-", "o--", "^-", "s-"))) + (("DPMFoam", "centroid", "kx-"),)
CELLS = (20, 16, 13, 10, 8, 5)         # along a side
RATIOS = (.02, .05, .1, .2, .5, 1, 2)  # step over response time, of the start
FALLING_RATIOS = (.3, 1, 3, 9)         # to ours


def dragDensity(slip):
    """Ergun's law of model A, per volume of mixture [N/m3], at an interstitial slip [m/s]."""
    return (150*PHI**2*MU/(ALPHA*D**2) + 1.75*PHI*RHO*slip/D)*slip


def drive():
    """What pulls the phases apart, per volume [N/m3]: weight less what the mixture's weight holds up."""
    return PHI*ALPHA*(RHO_P - RHO)*G


def steadySlip():
    """Where drag balances it; quadratic."""
    a, b = 1.75*PHI*RHO/D, 150*PHI**2*MU/(ALPHA*D**2)
    return (-b + math.sqrt(b*b + 4*a*drive()))/(2*a)


SLIP = steadySlip()
# What resists a change of the slip, per volume [kg/m3]: in ours the volume flux of the mixture is held at none, in DPMFoam its momentum is.
INERTIA = {"nscdDEMFoam": PHI*ALPHA*(ALPHA*RHO_P + PHI*RHO), "DPMFoam": PHI*ALPHA**2*RHO_P*RHO/(PHI*RHO_P + ALPHA*RHO)}
TAU = {code: inertia/(dragDensity(SLIP)/SLIP) for code, inertia in INERTIA.items()}
FALL = 2.5*PITCH/(ALPHA*SLIP)            # time that a fall of 2.5 lattice steps takes [s]


def exactSpeed(code, t, steps=4000):
    """Of grains relative to the mixture, from rest; Runge-Kutta of fourth order, or the steady one."""
    if t > 30*TAU[code]:
        return -ALPHA*SLIP
    rate = lambda slip: (drive() - dragDensity(slip))/INERTIA[code]
    slip, h = 0.0, t/steps
    for _ in range(steps):
        k1 = rate(slip); k2 = rate(slip + h/2*k1); k3 = rate(slip + h/2*k2); k4 = rate(slip + h*k3)
        slip += h/6*(k1 + 2*k2 + 2*k3 + k4)
    return -ALPHA*slip


def ours(cells, deltaT, steps, writes, scheme):
    case = box(cells, "ours", deltaT, steps, writes)
    case.write("system/fvSolution", SOLUTION)
    case.fluid(RHO, MU, (0, 0, -G))
    case.grains("materials { m { density %g; } } contacts { default { friction 0; } } forces { drag { law Ergun; } } meanFlow (0 0 0);\n"
                "voidFraction { %s } grains { type lattice; box (0 0 0) (%.17g %.17g %.17g); count (%d %d %d); diameter %g; }"
                % ((RHO_P, SCHEMES[scheme]) + 3*(SIDE,) + 3*(COUNT,) + (D,)))
    case.call("blockMesh")
    return pinned("nscdDEMFoam", case.folder).cpu, case


def theirs(cells, deltaT, steps, writes, _):
    """A jump of the pressure over the height holds the mixture up, as ours is by the pressure gradient of meanFlow."""
    case = box(cells, "theirs", deltaT, steps, writes)
    case.gravity((0, 0, -G))
    copyParts(case, RHO, MU)
    places = [(n + 0.5)*PITCH for n in range(COUNT)]
    setGrains(case, D, RHO_P, [(x, y, z) for z in places for y in places for x in places], collisions=False)
    jump = "type fixedJump; patchType cyclic; jump uniform %.17g; value uniform 0;" % - ((RHO + PHI*(RHO_P - RHO))/RHO*G*SIDE)
    setFields(case, "(0 0 0)", {}, {"zMin": jump, "zMax": jump})
    case.call("blockMesh")
    return pinned("DPMFoam", case.folder).cpu, case


def box(cells, name, deltaT, steps, writes):
    case = BoxCase(CASES/name, (0, 0, 0), 3*(SIDE,), 3*(cells,))
    case.control(deltaT, steps*deltaT, steps//writes*deltaT, "writeFormat binary;")
    return case


CODES = {"nscdDEMFoam": ours, "DPMFoam": theirs}
Names = namedtuple("Names", "velocity fraction cloud")
NAMES = {"nscdDEMFoam": Names("U", "alpha.fluid", "grains"), "DPMFoam": Names("U.air", "alpha.air", "kinematicCloud")}


def add(table, code, scene, scheme, cells, deltaT, length, writes):
    """A run of that length [s], and one of a step, whose cost is that of starting up; errors are of so many written times."""
    steps = writes*max(1, round(length/deltaT/writes))
    startUp = CODES[code](cells, deltaT, 1, 1, scheme)[0]
    cost, case = CODES[code](cells, deltaT, steps, writes, scheme)
    errors = [error for n, time in enumerate(case.times()[1:]) for error in errorsOf(code, case, time, (n + 1)*steps//writes*deltaT)]
    table.add(code, scene, scheme, SIDE/cells/D, deltaT/TAU[code], steps, 100*math.sqrt(sum(e*e for e in errors)/len(errors)), 100*sum(errors)/len(errors),
              max(cost - startUp, 0.0))


def errorsOf(code, case, time, t):
    """Of each grain's speed relative to the mixture."""
    names = NAMES[code]
    speeds = [v[2] for v in case.cloud("U", time, names.cloud)]
    alpha, u = case.fieldValues(names.fraction, time), [u[2] for u in case.fieldValues(names.velocity, time)]
    # Uniform fields are written as one value.
    alpha, u = (values if len(values) > 1 else values*max(len(alpha), len(u)) for values in (alpha, u))
    mixture = sum(a*w for a, w in zip(alpha, u))/len(u) + PHI*sum(speeds)/len(speeds)
    exact = exactSpeed(code, t)
    return [(v - mixture)/exact - 1 for v in speeds]


def measure(table):
    both = (("nscdDEMFoam", "exact"), ("DPMFoam", "centroid"))
    for ratio in RATIOS:
        for code, scheme in both:
            add(table, code, "start", scheme, 10, ratio*TAU[code], START*TAU[code], 1)
    deltaT = TAU["nscdDEMFoam"]
    for cells in CELLS:
        for scheme in SCHEMES:
            add(table, "nscdDEMFoam", "fall", scheme, cells, deltaT, FALL, 8)
        add(table, "DPMFoam", "fall", "centroid", cells, deltaT, FALL, 8)
    for ratio in FALLING_RATIOS:
        for code, scheme in both:
            add(table, code, "fall by step", scheme, 10, ratio*deltaT, FALL, 8)


def draw(table):
    figure, axes = pyplot.subplots(2, 2, figsize=(10, 8))
    for code, scheme, mark in SERIES:
        for row, scene, knob, label in ((0, "start", "dtOverTau", "time step [response times of the code]"), (1, "fall", "cellInDiameters", "cell [d]")):
            errors = table.column("errorPercent", code=code, scene=scene, scheme=scheme)
            if errors:
                axes[row][0].loglog(table.column(knob, code=code, scene=scene, scheme=scheme), errors, mark, label="%s, %s" % (code, scheme))
                # Neighbors in cell size are none in error: points alone.
                axes[row][1].loglog(table.column("seconds", code=code, scene=scene, scheme=scheme), errors, mark if scene == "start" else mark.rstrip("-"))
            axes[row][0].set_xlabel(label)
            axes[row][0].set_ylabel("%s: error of settling speeds, rms [%%]" % scene)
            axes[row][1].set_xlabel("processor time less start-up [s]")
    axes[1][0].legend(fontsize=7)
    savePicture(figure, "W6")


COLUMNS = ["code", "scene", "scheme", "cellInDiameters", "dtOverTau", "steps", "errorPercent", "meanErrorPercent", "seconds"]
if __name__ == "__main__":
    draw(Table("W6", COLUMNS, larger=("errorPercent", "seconds")).inRounds(measure))
