# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Random small cases for nscdDEMFoam: boxes with walls, an inlet and an exit, or periodic sides; any fluid, grains, laws, methods."""

import math
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]/"validation/resources"))
from foamCase import SOLUTION, BoxCase

LAWS = ["Gidaspow", "Stokes", "SchillerNaumann", "DiFelice", "Ergun", "DallaValle", "none"]


@dataclass
class CoupledCase:
    """A case, and what a judge needs to know of it. Lengths in m."""
    isPlane: bool           # one cell and empty sides in y: discs
    kind: str               # closed, exit, cyclic
    size: float             # largest diameter
    ratio: float            # largest over smallest diameter
    cells: list
    high: list              # upper corner of the mesh, whose lower one is the origin
    step: float             # [s]
    half: int               # steps up to the restart, and as many after it
    isAdjusted: bool        # adjustTimeStep
    g: float
    density: float
    fluidDensity: float
    nu: float
    inflow: float           # [m/s]
    areForcesWhole: bool    # what the fluid loses all goes to the grains
    isFelt: bool = True     # by the fluid
    stream: float = 0.0     # [m/s] what flows in or is held as mean flow
    grains: str = ""

    @property
    def end(self):
        return 2*self.half*self.step

    def sides(self, rng):
        types = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"), "wall")
        if self.isPlane:
            types["yMin"] = types["yMax"] = "empty"
        if self.kind == "cyclic" or rng.random() < 0.25:
            types["xMin"] = types["xMax"] = "cyclic"
        if self.kind == "cyclic" and not self.isPlane and rng.random() < 0.5:
            types["yMin"] = types["yMax"] = "cyclic"
        if self.kind == "exit":
            types["zMin"] = types["zMax"] = "patch"
        return types

    def write(self, folder, rng):
        case = BoxCase(folder, (0, 0, 0), self.high, self.cells, self.sides(rng))
        inlet = {"zMin": "type fixedValue; value uniform (0 0 %.17g);" % self.inflow,
                 "zMax": "type pressureInletOutletVelocity; value uniform (0 0 0);"}
        case.fluid(self.fluidDensity, self.nu*self.fluidDensity, (0, 0, -self.g), sides=inlet if self.kind == "exit" else {},
                   pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"} if self.kind == "exit" else {})
        # Starts are sudden here: each correction of the pressure takes what is left of momentum down.
        case.write("system/fvSolution", (SOLUTION % (1e-10, 1e-10)).replace("nCorrectors 3", "nCorrectors 8"))
        case.grains(self.grains)
        adjusted = "adjustTimeStep yes; maxCo 0.5; maxDeltaT %.17g;" % self.step if self.isAdjusted else ""
        case.control(self.step, self.end, self.half*self.step, "writeFormat binary;\n" + adjusted)


def randomCase(rng):
    size, ratio = 10**rng.uniform(-4, -2), rng.choice([1, 1, 2, 5, 10])
    isPlane, kind = rng.random() < 0.35, rng.choice(["closed", "exit", "cyclic"])
    cell = size*rng.choice([1.5, 2, 3, 5])
    cells = [rng.randint(2, 6), 1 if isPlane else rng.randint(2, 6), rng.randint(3, 8)]
    high = [cell*n for n in cells]
    if isPlane:
        high[1] = size
    g, step = rng.choice([0, 9.81, 9.81, 9.81]), 10**rng.uniform(-5, -2)
    # Most keep to steps that a user could want: a fall by a tenth of a diameter.
    if g and rng.random() < 0.85:
        step = min(step, math.sqrt(0.1*size/ratio/g))
    rho = rng.choice([1.2, 1000, 10**rng.uniform(-1, 4)])
    density = rho*10**rng.uniform(-2, 1) if rng.random() < 0.6 else 2500.0
    inflow = min(2.0, rng.choice([0, 0.02, 0.2])*cell/step) if kind == "exit" else 0
    # Written times have names of 12 digits, and a run goes on from what the name says.
    step = float("%.3g" % step)
    case = CoupledCase(isPlane, kind, size, ratio, cells, high, step, rng.randint(10, 25), rng.random() < 0.2, g, density, rho,
                       10**rng.uniform(-7, -2), inflow, areForcesWhole=True, stream=inflow)
    case.grains = grainProperties(rng, case, cell)
    return case


def onOff(rng, share):
    return "on" if rng.random() < share else "off"


def grainProperties(rng, case, cell):
    pressure, viscous = onOff(rng, 0.7), onOff(rng, 0.7)
    case.areForcesWhole = pressure == viscous == "on"
    feedback = onOff(rng, 0.75)
    case.isFelt = feedback == "on"
    parts = ["materials { m { density %.17g; } }" % case.density,
             "contacts { default { friction %g; restitution %g; %s } }" % (
                 rng.choice([0, 0.3, 0.5, 1, 2]), rng.choice([0, 0, 0.5, 0.9, 1]), rng.choice(["", "", "rollingFriction 0.1;"])),
             lattice(rng, case), forces(rng, case, pressure, viscous),
             "voidFraction { method %s; diffusion %g; minFluidFraction %g; }" % (
                 rng.choice(["exact", "exact", "satellite", "centroid"]), rng.choice([0, 0, 1, 3]), rng.choice([0.2, 0.1, 0.4])),
             "feedback %s;" % feedback, "timeStep { subCycles %d; }" % rng.choice([1, 1, 2, 5])]
    if case.kind == "exit":
        parts.append("patches { zMin { type %s; } zMax { type exit; } }" % rng.choice(["wall", "wall", "exit"]))
    if case.kind == "cyclic" and rng.random() < 0.4:
        case.stream = 0.1*cell/case.step
        parts.append("meanFlow (%.17g 0 0);" % case.stream)
    return "\n".join(parts)


def forces(rng, case, pressure, viscous):
    lift = "" if case.isPlane or rng.random() < 0.8 else "saffmanLift on; magnusLift on;"
    return "forces { drag { law %s; weight %s; } pressureGradient %s; viscous %s; spinDrag %s; %s }" % (
        rng.choice(LAWS), rng.choice(["exponential", "backwardEuler"]), pressure, viscous, onOff(rng, 0.7), lift)


def lattice(rng, case):
    """Up to 200 grains, as many as fit or fewer."""
    most = [max(1, int(0.95*length/case.size)) for length in case.high]
    most[2] = max(1, most[2]//rng.choice([1, 2, 3]))
    while math.prod(most) > 200:
        most[most.index(max(most))] -= 1
    count = [rng.randint(max(1, n//2), n) for n in most]
    if case.isPlane:
        count[1] = 1
    low = 1.02*case.size*count[2]
    top = [case.high[0], case.high[1], min(case.high[2], max(low, case.high[2]*rng.uniform(0.4, 1)))]
    spread = (case.ratio - 1)/(case.ratio + 1)
    return "grains { type lattice; box (0 0 0) (%.17g %.17g %.17g); count (%d %d %d); diameter %.17g; spread %.17g; jitter %g; seed %d; }" % (
        *top, *count, 0.98*case.size/(1 + spread), spread, rng.choice([0, 0.5, 1]), rng.randint(1, 10**6))
