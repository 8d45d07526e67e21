# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A fluidized bed that was measured (C18): its case, what was measured in it, and how far a run is from that."""

import math
from pathlib import Path

from foamCase import BoxCase

WIDTH, DEPTH, HEIGHT, CELLS = 0.044, 0.01, 0.12, (22, 1, 60)
NUMBER, D, DENSITY, VELOCITY = 9240, 1.2e-3, 1000.0, 0.6
RHO, NU = 1.2, 1.8e-5
START = 2.0    # of the averages [s]
WEIGHT = NUMBER*math.pi/6*D**3*DENSITY*9.81/(WIDTH*DEPTH)

# Digitised by the authors of sediFoam from Mueller and others (2008, 2009), who measured by magnetic resonance: x [mm], value
FLUID_FRACTION = {
    0.0164: [(2.79, .469), (4.66, .483), (6.43, .487), (8.49, .534), (10.38, .546), (12.17, .537), (14.13, .555), (16.04, .556), (17.93, .554),
             (19.73, .559), (21.53, .588), (23.44, .580), (25.42, .581), (27.20, .581), (29.11, .555), (30.95, .572), (32.92, .548), (34.74, .529),
             (36.61, .519), (38.50, .516), (40.36, .501), (42.23, .501)],
    0.0312: [(2.81, .400), (4.74, .404), (6.60, .420), (8.40, .455), (10.33, .504), (12.20, .558), (14.03, .628), (15.83, .628), (17.74, .637),
             (19.60, .644), (21.52, .651), (23.38, .678), (25.25, .667), (26.99, .648), (28.95, .655), (30.75, .641), (32.71, .602), (34.51, .578),
             (36.37, .537), (38.24, .490), (40.15, .440), (42.04, .452)]}
GRAIN_VELOCITY = {
    0.0199: [(1.0, -.0737), (3.1, -.0745), (5.0, -.0719), (7.0, -.0561), (9.0, -.0315), (11.0, -.0006), (13.05, .0363), (14.98, .0646),
             (16.99, .0893), (18.07, .1013), (20.0, .1030), (22.07, .1157), (24.03, .1007), (25.98, .0972), (27.0, .0836), (28.98, .0565),
             (30.98, .0255), (33.0, -.0098), (35.0, -.0390), (37.0, -.0606), (39.0, -.0729), (41.1, -.0746), (42.2, -.0738)]}
FUNCTIONS = """
functions
{
    fields { type grainFields; }
    mean
    {
        type fieldAverage; libs (fieldFunctionObjects); timeStart %g; writeControl writeTime;
        fields
        (
            alpha.fluid { mean on; prime2Mean off; base time; }
            U.grains { mean on; prime2Mean off; base time; }
        );
    }
    inlet
    {
        type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name zMin; operation areaAverage; fields (p_rgh);
        writeFields false; log false;
    }
}
"""
SOLUTION = """
solvers
{
    "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0; }
    "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; }
"""


def bed(build, law, restitution, impacts, deltaT, endTime):
    """In a folder of `build`. All sides are walls to the grains, as they were; the fluid slips along the two large ones, as one cell between them has no profile."""
    sides = {"xMin": "wall", "xMax": "wall", "yMin": "wall", "yMax": "wall", "zMin": "patch", "zMax": "patch"}
    case = BoxCase(build/("%s-%s-%s-%s" % (law, restitution, impacts, deltaT)), (0, 0, 0), (WIDTH, DEPTH, HEIGHT), CELLS, sides)
    case.fluid(RHO, RHO*NU, sides={
        "yMin": "type slip;", "yMax": "type slip;",
        "zMin": 'type exprFixedValue; valueExpr "vector(0, 0, %g)/alpha.fluid"; value uniform (0 0 0);' % VELOCITY,
        "zMax": "type pressureInletOutletVelocity; value uniform (0 0 0);"}, pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"})
    case.write("system/fvSolution", SOLUTION)
    case.grains("""
materials { bead { density %g; } }
contacts { default { friction 0.1; restitution %s; } }
wallMaterial bead;
patches { zMin { type wall; } zMax { type wall; } }
forces { drag { law %s; } }
timeStep { maxGrainImpacts %s; }
grains { type lattice; box (0 0 0) (%g %g 0.054); count (33 7 40); diameter %g; jitter 0.5; }
""" % (DENSITY, restitution, law, impacts, WIDTH, DEPTH, D))
    case.control(float(deltaT), endTime, extra=FUNCTIONS % START)
    return case


def row(values, z):
    """Of a field of cells, across the bed at a height: linear between the middles of cells."""
    nx, _, nz = CELLS
    place = z/HEIGHT*nz - 0.5
    k = int(place)
    share = place - k
    return [(1 - share)*values[k*nx + i] + share*values[(k + 1)*nx + i] for i in range(nx)]


def at(across, x):
    place = min(max(x/WIDTH*len(across) - 0.5, 0.0), len(across) - 1.0)
    k = min(int(place), len(across) - 2)
    return across[k] + (place - k)*(across[k + 1] - across[k])


def rms(across, measured):
    return math.sqrt(sum((at(across, 1e-3*x) - value)**2 for x, value in measured)/len(measured))


def inletPressure(case):
    """Mean over the time of the averages [Pa]."""
    rows = [line.split() for line in next(Path(case.folder, "postProcessing/inlet").rglob("surfaceFieldValue.dat")).read_text().splitlines()
            if not line.startswith("#")]
    values = [float(row[1]) for row in rows if float(row[0]) > START]
    return sum(values)/len(values)


class Profiles:
    """Means over the time of the averages, across the bed: fluid fraction at the heights of FLUID_FRACTION, grain velocity at that of GRAIN_VELOCITY."""

    def __init__(self, case):
        alpha, momentum = (case.fieldValues(name) for name in ("alpha.fluidMean", "U.grainsMean"))
        self.fluidFraction = {z: row(alpha, z) for z in FLUID_FRACTION}
        self.grainVelocity = {z: row([value[2] for value in momentum], z) for z in GRAIN_VELOCITY}
        self.fluidFractionRms = {z: rms(across, FLUID_FRACTION[z]) for z, across in self.fluidFraction.items()}
        self.grainVelocityRms = {z: rms(across, GRAIN_VELOCITY[z]) for z, across in self.grainVelocity.items()}
