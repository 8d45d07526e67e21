# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A random case of nscdDEMFoam: run, judged, and run again from the middle."""

import math
import random
import shutil

from coupledCases import randomCase
from program import find, fresh, oneLine, run, write
from reports import notFinite, readTable, wrongContacts
from trial import Trial

from foamCase import CaseFolder

SECONDS = 90
VOLUME = 1e-9       # share of the grains' volume: round-off
ROUND_OFF = 1e-6
MOMENTUM = 1e-2     # of the grains' weight, what eight corrections of the pressure may leave of a sudden start
REACH = 20          # times the speed that weight, flow and a fifth of a diameter a step give: a run that blows up


def runCase(folder):
    outcome = run([find("nscdDEMFoam")], folder, SECONDS)
    write(folder/"log.nscdDEMFoam", outcome.log)
    return outcome


def end(folder):
    """Files of the last written time, but for OpenFOAM's own counts of what each rank has numbered."""
    last = folder/CaseFolder(folder).times()[-1]
    files = [path for path in last.rglob("*") if path.is_file() and path.name != "cloudProperties"]
    return last, {str(path.relative_to(last)): path.read_bytes() for path in files}


def differences(folder, isAdjusted):
    """Of a run that goes on from the middle from one that did not stop, to the bit.

    With adjustTimeStep OpenFOAM counts the steps to a written time from the start of a run, which rounds otherwise: then to ROUND_OFF."""
    last, whole = end(folder)
    rows = readTable(folder/"postProcessing/grains/0/report.csv")
    shutil.rmtree(last)
    outcome = runCase(folder)
    if outcome.status != 0:
        return {outcome.crash or "restart differs": oneLine(outcome.error)}
    again = end(folder)[1]
    if isAdjusted:
        return differencesOfEnd(rows[-1], readTable(sorted((folder/"postProcessing/grains").iterdir())[-1]/"report.csv")[-1])
    unlike = sorted(name for name in whole if whole[name] != again.get(name))
    return {"restart differs": ", ".join(unlike[:6])} if unlike else {}


def differencesOfEnd(whole, again):
    """Of the last rows: the scene at the end, without what only is a measure of an error."""
    columns = ["time", "grains", "exited", "kineticEnergy", "massCenterX", "massCenterY", "massCenterZ", "solidVolume"]
    unlike = [name for name in columns if abs(whole[name] - again[name]) > ROUND_OFF*abs(whole[name])]
    return {"restart differs": ", ".join(unlike)} if unlike else {}


def wrongBalances(case, rows):
    """Grains and volumes, which hold to round-off, and momentum."""
    found = {}
    if len({row["grains"] + row["exited"] for row in rows}) > 1:
        found["grain lost"] = "beside the exits"
    volumes = [row["grainVolume"] for row in rows]
    if case.kind != "exit" and max(volumes) - min(volumes) > VOLUME*volumes[0]:
        found["volume"] = f"of the grains changes by {max(volumes)/min(volumes) - 1:.2g}"
    # All of a grain is in the cells, also what reaches through an exit: volumeOutside is not lost.
    worst = max((abs(row["solidVolume"] - row["grainVolume"])/row["grainVolume"] for row in rows if row["grainVolume"] > 0), default=0)
    if case.isFelt and worst > VOLUME:
        found["volume"] = f"in the mesh off by {worst:.2g}"
    momentum = max(row["momentumError"] for row in rows)
    if case.areForcesWhole and momentum > MOMENTUM:
        found["momentum"] = f"off by {momentum:.2g} of the weight"
    return found


def wrongMotion(case, rows):
    found = wrongContacts(rows)
    weight = case.g*case.end*max(1, case.fluidDensity/case.density)
    bound = REACH*(weight + case.stream + 0.2*case.size/case.step)
    speeds = [math.sqrt(2*row["kineticEnergy"]/(case.density*row["grainVolume"])) for row in rows if row["grainVolume"] > 0]
    if speeds and max(speeds) > bound:
        found["energy growth"] = f"{max(speeds):.2g} m/s, more than {bound:.2g}"
    return found


def examine(case, folder):
    rows = readTable(folder/"postProcessing/grains/0/report.csv")
    broken = notFinite(rows) or notFiniteField(folder)
    if broken:
        return {"not finite": broken}, {}
    found = {**wrongBalances(case, rows), **wrongMotion(case, rows)}
    if not case.isAdjusted and len(rows) != 2*case.half:
        found["steps missing"] = f"{len(rows)} of {2*case.half}"
    return found, {"steps": len(rows), "atCap": sum(row["atCap"] for row in rows), "overlap": max(row["overlapMax"] for row in rows),
                   "momentum": max(row["momentumError"] for row in rows) if case.areForcesWhole else 0.0}


def notFiniteField(folder):
    case = CaseFolder(folder)
    for name in ("U", "p_rgh", "alpha.fluid"):
        for value in case.fieldValues(name):
            if not all(map(math.isfinite, value if isinstance(value, tuple) else (value,))):
                return f"{name} of the last time"
    return None


def trial(seed, folder):
    rng = random.Random(f"coupled {seed}")
    case = randomCase(rng)
    case.write(fresh(folder), rng)
    mesh = run([find("blockMesh")], folder, SECONDS)
    if mesh.status != 0:
        return Trial(seed, {"refused": "by blockMesh: " + oneLine(mesh.error)}, {})
    outcome = runCase(folder)
    if outcome.status != 0:
        isFast = "use a smaller time step" in outcome.error
        return Trial(seed, {outcome.crash or ("too fast" if isFast else "refused"): oneLine(outcome.error)}, {})
    found, figures = examine(case, folder)
    return Trial(seed, {**found, **differences(folder, case.isAdjusted)}, figures)
