# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W7: flow through held grains at random places: error of the pressure gradient against Ergun's law on the true solid fraction, and run time,
in cells of 3 to 3/8 diameters, of nscdDEMFoam (its default, and without its filter of small cells) and OpenFOAM's DPMFoam."""

from dpmfoamCase import FLUX_PRESSURE, copyParts, setFields, setGrains
from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from randomBeds import HeldBed, randomGrains

D, U, RHO, MU = 1e-3, 1e-2, 1000.0, 1e-3
SIDE, HEIGHT, FREE = 6, 16, 8      # of the bed, and free above and below it [d]
LOW, HIGH = 5, 11                  # between which the gradient is taken [d]
CELLS = (3, 2, 1.5, 1, 0.75, 0.5, 0.375)
STEPS = 100
BED = HeldBed(randomGrains(0.33, SIDE, HEIGHT), SIDE, HEIGHT, FREE, D)
EXACT = BED.ergun(U, RHO, MU, LOW, HIGH)
CASES = BUILD/"cases/W7"


def errorOf(pressure, cell):
    return BED.gradient(pressure, cell, LOW, HIGH)/EXACT - 1


def ours(cell, settings):
    """Error and processor seconds of the steps after the first."""
    costs = []
    deltaT = 0.25*cell*D/U
    for steps in (1, STEPS):
        case = BED.case(CASES/"ours", cell, U, RHO, MU, settings)
        case.control(deltaT, steps*deltaT)
        case.call("blockMesh")
        costs.append(pinned("nscdDEMFoam", case.folder).cpu)
    return errorOf(case.fieldValues("p_rgh"), cell), costs[1] - costs[0]


def theirs(cell):
    """DPMFoam's grains are held by their mass; where alpha.air is as low as it lets cells be, drag is what that makes of it."""
    costs = []
    deltaT = 0.25*cell*D/U
    for steps in (1, STEPS):
        case = BED.box(CASES/"theirs", cell)
        copyParts(case, RHO, MU)
        case.gravity((0, 0, 0))
        case.control(deltaT, steps*deltaT)
        setGrains(case, D, 1e15, [[D*x for x in center] for center in BED.centers], ("zMin", "zMax"), collisions=False)
        setFields(case, "(0 0 %g)" % U, {"zMin": "type fixedValue; value uniform (0 0 %g);" % U, "zMax": "type zeroGradient;"},
                  {"zMin": FLUX_PRESSURE, "zMax": "type fixedValue; value uniform 0;"})
        case.call("blockMesh")
        costs.append(pinned("DPMFoam", case.folder).cpu)
    return errorOf([RHO*p for p in case.fieldValues("p")], cell), costs[1] - costs[0]


CODES = {
    "nscdDEMFoam": lambda cell: ours(cell, ""), "nscdDEMFoam, filterWidth 0": lambda cell: ours(cell, "voidFraction { filterWidth 0; }"), "DPMFoam": theirs
}


def measure(table):
    for cell in CELLS:
        for code, simulate in CODES.items():
            error, seconds = simulate(cell)
            table.add(code, cell, 100*error, seconds)


def draw(table):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4))
    for code in CODES:
        errors = [abs(e) for e in table.column("errorPercent", code=code)]
        left.loglog(CELLS, errors, "o-", label=code)
        right.loglog(table.column("seconds", code=code), errors, "o-")
    left.set_xlabel("cell [d]")
    right.set_xlabel("processor time less start-up [s]")
    left.set_ylabel("error of the pressure gradient [%]")
    left.legend(fontsize=7)
    savePicture(figure, "W7")


draw(Table("W7", ["code", "cellInDiameters", "errorPercent", "seconds"], larger=("seconds",)).inRounds(measure))
