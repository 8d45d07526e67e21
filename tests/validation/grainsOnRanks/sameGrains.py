# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases on one rank and on many: cutting and running them, and telling how far their reports and grains are apart."""

import glob
import math
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]/"resources"))
from foamCase import readList
from ranks import copied, decompose, onRanks

BUILD = Path(__file__).resolve().parents[3]/"build/validation/grainsOnRanks"
ROOT = Path(__file__).resolve().parents[3]
G = 9.81
# Up to which gap pairs are listed [d]: changes the order of sweeps and nothing else.
SKINS = (0.05, 0.06, 0.07, 0.08, 0.1)


def nameOf(case):
    return os.path.basename(case.folder)


def size(parts):
    return parts[0]*parts[1]*parts[2]


def runCut(case, parts, times=("0",), suffix=""):
    """A copy of the case, cut by decomposePar into parts along x, y, z and run on as many ranks."""
    cut = copied(case, "%s-%dx%dx%d%s" % ((nameOf(case),) + parts + (suffix,)), times)
    cut.ranks = size(parts)
    decompose(cut, cut.ranks, "simple", "simpleCoeffs { n (%d %d %d); delta 0.001; }" % parts, options=("-latestTime",))
    onRanks(cut, "nscdDEMFoam", cut.ranks)
    cut.label = "%s, %d ranks %dx%dx%d" % ((nameOf(case), cut.ranks) + parts)
    return cut


def folders(case, time):
    """Where grains of a written time are: in the case, or in those of its processors that have any."""
    ranks = getattr(case, "ranks", 0)
    parts = ["processor%d" % rank for rank in range(ranks)] if ranks else [""]
    paths = [os.path.join(case.folder, part, time, "lagrangian") for part in parts]
    return [path for path in paths if os.path.exists(os.path.join(path, "grains/origId"))]


def byId(case, time, field):
    """A field of all grains of a written time, by identity."""
    values = {}
    for folder in folders(case, time):
        values.update(zip(readList(folder + "/grains/origId"), readList(folder + "/grains/" + field)))
    return values


def homes(case, time):
    """The rank of each grain's home, by identity."""
    return {int(grain): rank for rank in range(case.ranks)
            for path in glob.glob("%s/processor%d/%s/lagrangian/grains/origId" % (case.folder, rank, time)) for grain in readList(path)}


def farthest(a, b, time, field="position"):
    """Largest distance between the same grains of two cases; infinite when they have not the same grains."""
    mine, theirs = byId(a, time, field), byId(b, time, field)
    return max(math.dist(mine[grain], theirs[grain]) for grain in mine) if mine.keys() == theirs.keys() else math.inf


def wallForces(case, time, deltaT):
    """Force of the grains on each wall, by region, from the impulses on the grains of the last step."""
    forces = {}
    for folder in folders(case, time):
        for region, impulse in zip(readList(folder + "/contacts/idB"), readList(folder + "/contacts/impulse")):
            if region < 0:
                before = forces.get(region, (0, 0, 0))
                forces[region] = tuple(f - r/deltaT for f, r in zip(before, impulse))
    return forces


def apart(a, b, column, steps=None, sign=1):
    """Largest difference of a column of two reports in the first steps (in all); infinite when they have not as many rows."""
    a, b = a.report()[column], b.report()[column]
    if len(a) != len(b):
        return math.inf
    return max(abs(x - sign*y) for x, y in list(zip(a, b))[:steps])


def checkEveryStep(verdict, alone, cut, hasFluid):
    """What no number of ranks may change: how many grains there are, their volume, and balances."""
    verdict.below(cut.label + ": grains and exits, every step", max(apart(alone, cut, column) for column in ("grains", "exited")), 0)
    volume = alone.report()["grainVolume"][0]
    verdict.below(cut.label + ": grain volume, every step", apart(alone, cut, "grainVolume")/volume, 1e-12)
    if hasFluid:
        # A grain 5e-4 d deep in a wall has 7.5e-7 of its volume there, which cells inside get.
        verdict.below(cut.label + ": volume error, every step", max(cut.report()["volumeError"]), 1e-6)
        # Three corrections of PISO leave up to 3e-3 of grains thrown into a fluid at rest; ranks add nothing to it (checkSamePaths).
        verdict.below(cut.label + ": momentum error, every step", max(cut.report()["momentumError"]), 5e-3)


def checkSamePaths(verdict, alone, cut, time, tolerance):
    """For motion that a fine solve determines: the mass center in every step, and every grain at the end [m]."""
    centers = max(apart(alone, cut, "massCenter" + axis) for axis in "XYZ")
    verdict.below(cut.label + ": mass center, every step [m]", centers, tolerance)
    verdict.below(cut.label + ": farthest grain at the end [m]", farthest(alone, cut, time), tolerance)
    verdict.below(cut.label + ": difference of momentum errors, every step", apart(alone, cut, "momentumError"), 1e-6)


def bytesOf(case):
    """All that a run wrote but its logs: contents by path."""
    found = {}
    for pattern in ("postProcessing/**/*", "processor*/[0-9]*/**/*"):
        for path in glob.glob(os.path.join(case.folder, pattern), recursive=True):
            if os.path.isfile(path):
                found[os.path.relpath(path, case.folder)] = Path(path).read_bytes()
    return found


def checkSameBits(verdict, case, cut, parts):
    """The same run again on as many ranks."""
    first, second = bytesOf(cut), bytesOf(runCut(case, parts, suffix="-again"))
    different = [path for path in first.keys() | second.keys() if first.get(path) != second.get(path)]
    verdict.below("%s, run again: files that differ" % cut.label, len(different), 0, "of %d %s" % (len(first), " ".join(different[:3])))
