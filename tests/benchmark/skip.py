# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K1 to K8, K10, S29, S30: what scenes cost with what they do not need, and without it. K9, messages on one rank, is counted by `messages`."""

from pathlib import Path

import K1
import K2
import sleepInFluid
from coreRun import bed, rows
from foamCase import BoxCase
from pinnedRun import pinned
from results import BUILD, Table, bars
from settledBox import settledBox
from timingTable import PARTS, timesOf

COLUMNS = ["id", "scene", "part", "with", "msWith", "without", "msWithout", "ratio"]
LID_CELLS, LID_STEPS = 64, 5
LID_SOLUTION = """
solvers
{
    "p_rgh.*" { solver GAMG; smoother GaussSeidel; tolerance 1e-7; relTol 0.01; }
    "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; }
"""


def core(which, *arguments):
    """Rows of the program `skips`, by their variant."""
    return {row["variant"]: row for row in rows("skips", which, *arguments)}


def add(table, name, scene, part, withIt, without):
    """withIt, without: in words, and milliseconds a step."""
    table.add(name, scene, part, *withIt, *without, without[1]/withIt[1])


def withoutGrains(table):
    mine, other = K1.costsOfSteps(K1.PCG)
    add(table, "K1", "cavity, no grains", "step", ("pimpleFoam", 10*other), ("nscdDEMFoam", 10*mine))


def partOf(log, *names):
    return sum(timesOf(log, "ms")[PARTS.index(name)] for name in names)


def settledBed(table):
    """9240 spheres at rest in air."""
    case = K2.settle()
    dry, _ = K2.stepCost(case, "fluid none;")
    K2.addFluid(case)
    coupled, _ = K2.stepCost(case, "")
    oneWay, _ = K2.stepCost(case, "feedback off;")
    add(table, "K2", "bed in air", "step", ("fluid solved", coupled), ("fluid none", dry))
    add(table, "K2", "bed in air", "step", ("feedback on", coupled), ("feedback off", oneWay))
    written = writtenEachStep(case)
    add(table, "K10", "bed in air", "step", ("written each step", written), ("not written", coupled))
    case.remove()


def fixedGrains(table):
    """A lattice of 9240 spheres in air that rises through it."""
    logs = {}
    for motion in ("free", "fixed"):
        case = settledBox(BUILD/"cases/K3", "", {"zMin": "patch"})
        case.fluid(1.2, 1.8e-5, sides={"zMin": "type fixedValue; value uniform (0 0 0.2);"}, pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"})
        text = Path(case.folder, "constant/grainProperties").read_text()
        text = text[text.index("materials"):].replace("zMax {", "zMin { type wall; } zMax {")
        case.grains(text.replace("jitter", "motion fixed; jitter") if motion == "fixed" else text)
        case.control(K2.DELTA_T, K2.STEPS*K2.DELTA_T, 1e6)
        case.call("blockMesh")
        pinned("nscdDEMFoam", case.folder)
        logs[motion] = Path(case.folder, "log.nscdDEMFoam").read_text()
        case.remove()
    for name, part in (("K3", "depositGrains"), ("K8", "solveFluid")):
        add(table, name, "lattice in rising air", part, *((motion, partOf(log, part)) for motion, log in logs.items()))


def writtenEachStep(case):
    """Milliseconds a step of the same bed with output in each one."""
    seconds = []
    for count in (1, 1 + K2.STEPS):
        K2.writeGrains(case, "")
        case.control(K2.DELTA_T, K2.SETTLED + count*K2.DELTA_T, K2.DELTA_T)
        seconds.append(pinned("nscdDEMFoam", case.folder).cpu)
        for time in case.times()[2:]:
            K2.shutil.rmtree(Path(case.folder, time))
    return 1e3*(seconds[1] - seconds[0])/K2.STEPS


def bedInWater(table):
    case = sleepInFluid.settle()
    cost = {}
    for sleep in ("off", "on"):
        sleepInFluid.writeGrains(case, sleep)
        cost[sleep] = sleepInFluid.grainPart(sleepInFluid.window(case)[0])
    case.remove()
    add(table, "K4", "bed in water", "all but solveFluid", ("awake", cost["off"]), ("asleep", cost["on"]))


def lidDriven(grains):
    """A box of water under a lid that moves, with these grains: its timing table."""
    case = BoxCase(BUILD/"cases/K7", (0, 0, 0), (0.064,)*3, (LID_CELLS,)*3, {side: "wall" for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")})
    case.fluid(1000, 1e-3, sides={"zMax": "type fixedValue; value uniform (0.1 0 0);"})
    case.write("system/fvSolution", LID_SOLUTION)
    case.grains("materials { glass { density 2500; } }\ncontacts { default { friction 0.3; } }\n" + grains)
    case.control(1e-3, LID_STEPS*1e-3, 1e6)
    case.call("blockMesh")
    pinned("nscdDEMFoam", case.folder)
    log = Path(case.folder, "log.nscdDEMFoam").read_text()
    case.remove()
    return log


def oneGrain(table):
    """K7: what a grain costs beside the fluid that it does not fill."""
    log = lidDriven("grains { type lattice; box (0.03 0.03 0.03) (0.034 0.034 0.034); count (1 1 1); diameter 1e-3; }")
    fluid, step = partOf(log, "solveFluid"), sum(timesOf(log, "ms"))
    add(table, "K7", "one grain in %d cells" % LID_CELLS**3, "step", ("all parts", step), ("solveFluid alone", fluid))


def grainsAlone(table):
    """What the library leaves out by itself."""
    still = core("still", bed(20, 25))
    add(table, "K4", "bed, dry", "step", *((name, still[name]["msPerStep"]) for name in ("awake", "may sleep")))
    planar = core("planar")
    add(table, "K5", "discs that land", "step", *((name, planar[name]["msPerStep"]) for name in ("spheres' kernel", "discs' kernel")))
    smooth = core("smooth")
    add(table, "K6", "heap without friction", "step", *((name, smooth[name]["msPerStep"]) for name in ("friction 1e-300", "friction 0")))
    sizes = core("sizes")
    add(table, "16.6", "bed of one size", "step", *((name, sizes[name]["msPerStep"]) for name in ("sizes 1 +- 1e-9", "one size")))
    cloud = core("cloud")["later"]
    contact = sum(cloud[name + "Ms"] for name in ("updateGeometry", "buildContacts", "packContacts", "solveContacts", "judgeContacts", "rebound"))
    add(table, "S29", "cloud of a million", "step", ("all", cloud["msPerStep"]), ("contacts", contact))
    rest = core("rest", bed(8, 15))
    add(table, "S30", "bed, 1e5 steps", "step", *((name, rest[name]["msPerStep"]) for name in ("coming to rest", "part 10")))


def measure(table):
    for part in (withoutGrains, settledBed, fixedGrains, bedInWater, oneGrain, grainsAlone):
        part(table)


def main():
    table = Table("skip", COLUMNS, larger=("msWithout", "ratio")).inRounds(measure)
    bars(table, ["id", "without"], "ratio", "time of a step without over with")


if __name__ == "__main__":
    main()
