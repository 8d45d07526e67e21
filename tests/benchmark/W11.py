# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W11: rms errors of u and p over the rms of the exact ones [%], and run time, against the cells along a side and the step over their size: the
averaged fluid on the manufactured solutions M1 to M3 (t = 0.98, backward; one and three outer iterations of PIMPLE) and B05 (steady at t = 2),
where Lethe's errors, which it keeps for its own tests, stand beside ours without a time; and, without grains, nscdDEMFoam and pimpleFoam with equal
schemes on the decaying vortices of Taylor and Green (t = 0.98, nu 0.07/1.3)."""

import math

from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

CELLS = (16, 32, 64, 128)
STEP_RATIOS = (.125, .25, .5, 1)       # step over cell size
END, STEADY = 0.98, 2.0                # [s]
RHO, MU = 1.3, 0.07
CASES = BUILD/"cases/W11"
# L2 errors of u and p over [-1, 1]^2 on 16, 32 and 64 cells a side: applications_tests/lethe-fluid-vans of Lethe.
LETHE = {"case0": ((3.790e-2, 1.010e-2, 2.595e-3), (.338, .120, .0397)), "case1": ((7.471e-2, 1.992e-2, 5.120e-3), (.691, .244, .0803)),
         "case2": ((4.581e-2, 1.205e-2, 3.052e-3), (.388, .104, .0265))}
SCHEMES = """
ddtSchemes           { default backward; }
gradSchemes          { default Gauss linear; }
divSchemes           { default Gauss linear; }
laplacianSchemes     { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes        { default corrected; }
"""
SOLUTION = """
solvers
{
    "p.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-9; relTol 0; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-9; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; momentumPredictor yes; pRefCell 0; pRefValue 0; }
"""


def manufactured(solution, cells, steps, end, outer):
    """Errors of u and p in percent, and processor seconds of the steps, which the program itself reads off."""
    folder = CASES/"manufactured"
    folder.mkdir(parents=True, exist_ok=True)
    pinned("fluidManufactured", folder, arguments=("measure", solution, cells, steps, end, outer, 3 if solution in LETHE else 2, 1e-9))
    u, p, seconds = map(float, (folder/"log.fluidManufactured").read_text().splitlines()[-1].split())
    return 100*u, 100*p, seconds


def lethesSizes(solution, n=200):
    """L2 of the exact u, and of the exact p less its mean, over [-1, 1]^2."""
    places = [math.pi*(2*(k + 0.5)/n - 1) for k in range(n)]
    waves = [math.sin(x)*math.sin(y) for x in places for y in places]
    u2 = {"case0": 3/32, "case1": 3/8, "case2": sum(2*math.exp(2*w - 2) for w in waves)/n**2}[solution]
    return 2*math.sqrt(u2), 1.0 if solution == "case1" else 0.5


def vortexCase(program, cells, deltaT, steps):
    case = BoxCase(CASES/program, (0, 0, 0), (2*math.pi, 2*math.pi, 2*math.pi/cells), (cells, cells, 1), {"zMin": "empty", "zMax": "empty"})
    case.write("system/fvSchemes", SCHEMES)
    case.write("system/fvSolution", SOLUTION)
    case.fluid(RHO, MU, (0, 0, 0))
    sides = "".join("%sMin { type cyclic; } %sMax { type cyclic; } " % (a, a) for a in "xy") + "zMin { type empty; } zMax { type empty; }"
    start = exact(cells, 0)
    case.write("0/U", "dimensions [0 1 -1 0 0 0 0]; internalField nonuniform List<vector> %d\n(\n%s);\nboundaryField { %s }"
               % (cells**2, "".join("(%.17g %.17g 0)\n" % u for u, _ in start), sides), "volVectorField")
    name, dimensions = ("p_rgh", "[1 -1 -2 0 0 0 0]") if program == "nscdDEMFoam" else ("p", "[0 2 -2 0 0 0 0]")
    case.write("0/" + name, "dimensions %s; internalField uniform 0; boundaryField { %s }" % (dimensions, sides), "volScalarField")
    case.grains("materials { m { density 2500; } } contacts { default { friction 0; } } grains {}")
    case.control(deltaT, steps*deltaT, None, "writeFormat binary;")
    return case


def exact(cells, t):
    """Of each cell, x first: velocity and pressure [Pa]."""
    h, decay = 2*math.pi/cells, math.exp(-2*MU/RHO*t)
    places = [(n + 0.5)*h for n in range(cells)]
    return [((decay*math.sin(x)*math.cos(y), -decay*math.cos(x)*math.sin(y)), RHO/4*decay**2*(math.cos(2*x) + math.cos(2*y))) for y in places for x in places]


def vortices(program, cells, ratio):
    """Errors of u and p in percent, and processor seconds less those of a run of one step."""
    steps = max(2, round(END/(ratio*2*math.pi/cells)))
    costs = []
    for count in (1, steps):
        case = vortexCase(program, cells, END/steps, count)
        case.call("blockMesh")
        costs.append(pinned(program, case.folder).cpu)
    truth = exact(cells, END)
    p = [value*(1 if program == "nscdDEMFoam" else RHO) for value in case.fieldValues("p_rgh" if program == "nscdDEMFoam" else "p")]
    mean = sum(p)/len(p)
    u2 = sum((u[0] - v[0])**2 + (u[1] - v[1])**2 for u, (v, _) in zip(case.fieldValues("U"), truth))
    p2 = sum((a - mean - b)**2 for a, (_, b) in zip(p, truth))
    size = [sum(v[0]**2 + v[1]**2 for v, _ in truth), sum(b*b for _, b in truth)]
    return 100*math.sqrt(u2/size[0]), 100*math.sqrt(p2/size[1]), max(0.0, costs[1] - costs[0])


def measure(table):
    for cells in CELLS:
        h = 2*math.pi/cells
        for solution in ("M1", "M2", "M3"):
            for ratio, outer in [(ratio, 1) for ratio in STEP_RATIOS] + [(.25, 3)]:
                table.add("nscdDEMFoam", solution, cells, ratio, outer, *manufactured(solution, cells, max(2, round(END/(ratio*h))), END, outer))
        for ratio in STEP_RATIOS:
            for program in ("nscdDEMFoam", "pimpleFoam"):
                table.add(program, "no grains", cells, ratio, 1, *vortices(program, cells, ratio))
    for solution, (u, p) in LETHE.items():
        sizes = lethesSizes(solution)
        for cells, errorU, errorP in zip(CELLS, u, p):
            table.add("Lethe", solution, cells, 0.0, 1, 100*errorU/sizes[0], 100*errorP/sizes[1], math.nan)
        for cells in CELLS[:3]:
            for ratio in (.25, 1):
                table.add("nscdDEMFoam", solution, cells, ratio, 1, *manufactured(solution, cells, round(STEADY/(ratio*2/cells)), STEADY, 1))


def draw(table):
    figure, axes = pyplot.subplots(2, 2, figsize=(11, 9))
    for color, solution in enumerate(("M1", "M2", "M3")):
        for row, quantity in enumerate(("errorPercent", "pressureErrorPercent")):
            for ratio, outer, mark in ((.25, 1, "o-"), (1, 1, "s--"), (.25, 3, "^:")):
                where = dict(code="nscdDEMFoam", case=solution, dtOverCell=ratio, outer=outer)
                axes[row][0].loglog(table.column("seconds", **where), table.column(quantity, **where), mark, color="C%d" % color,
                                    label="%s, dt %g h, %d outer" % (solution, ratio, outer))
    for program, mark in (("nscdDEMFoam", "o-"), ("pimpleFoam", "kx--")):
        for ratio in (.25, 1):
            where = dict(code=program, case="no grains", dtOverCell=ratio)
            axes[0][1].loglog(table.column("seconds", **where), table.column("errorPercent", **where), mark, label="%s, dt %g h" % (program, ratio))
    for color, solution in enumerate(LETHE):
        for code, ratio, mark in (("nscdDEMFoam", .25, "o-"), ("Lethe", 0.0, "x--")):
            axes[1][1].loglog(CELLS[:3], table.column("errorPercent", code=code, case=solution, dtOverCell=ratio), mark, color="C%d" % color,
                              label="B05 %s, %s" % (solution, code))
    for axis, across, up in ((axes[0][0], "processor time of the steps [s]", "error of u [%]"), (axes[1][0], "processor time of the steps [s]", "error of p [%]"),
                             (axes[0][1], "processor time less start-up [s]", "error of u, no grains [%]"), (axes[1][1], "cells along a side", "error of u [%]")):
        axis.set_xlabel(across)
        axis.set_ylabel(up)
        axis.legend(fontsize=6)
    savePicture(figure, "W11")


COLUMNS = ["code", "case", "cells", "dtOverCell", "outer", "errorPercent", "pressureErrorPercent", "seconds"]
if __name__ == "__main__":
    draw(Table("W11", COLUMNS, larger=("errorPercent", "pressureErrorPercent", "seconds")).inRounds(measure))
