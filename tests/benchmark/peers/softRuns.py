# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Runs of LIGGGHTS and LAMMPS: whole motions that leave restarts at some moments, and short timed windows that start from these."""

import json
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from pinnedRun import pinned
from results import BUILD
from softPeers import PEERS, RESTITUTION, dumpCommands, readDump, timeStep, writeData

FOLDER = BUILD/"peers"
SETTLING = 0.03     # s, in which soft grains find their overlaps
SKINS = {"bed": 0.1, "collapse": 0.2}   # d; the quickest of 0.03, 0.06, 0.1 and 0.2


# One thread, and no daemon of MPI's beside the one process: on a busy machine that takes seconds of the processor to start, each time another number.
ALONE = {"OMP_NUM_THREADS": "1", "OMPI_MCA_ess_singleton_isolated": "1"}


def isInstalled(peer):
    return shutil.which(PEERS[peer][0]) is not None


def processorSeconds(peer, text, name, core):
    """Of one run of an input, pinned."""
    program = PEERS[peer][0]
    path = FOLDER/(name + ".in")
    path.write_text(text)
    return pinned(program, FOLDER, core, name + ".screen", ["-in", path.name, "-screen", "none", "-log", name + ".log"], ALONE).cpu


def name(peer, modulus, scene, moment=None, restitution=RESTITUTION):
    own = "" if restitution == RESTITUTION else ".e%g" % restitution
    return "%s.%.0e.%s%s" % (peer, modulus, scene, own) + ("" if moment is None else ".%d" % moment)


def steps(seconds, modulus):
    return max(1, round(seconds/timeStep(modulus)))


def makeInput(peer, modulus, scene, width, start, commands, skin=None, restitution=RESTITUTION):
    skin = skin or SKINS["bed" if scene == "bed" else "collapse"]
    return PEERS[peer][1](start, scene, width, modulus, skin, commands, restitution)


def saveCommands(prefix, moment):
    return ["write_restart %s.%d.restart" % (prefix, moment)] + dumpCommands("%s.%d.dump" % (prefix, moment))


def moveWhole(peer, modulus, scene, grains, periods, every, moments, core, restitution=RESTITUTION):
    """From the grains at rest: settled (`moment` 0 of a bed; a box for a collapse), then so many times `every` seconds of motion.
    Returns processor seconds a second of motion; done once, and kept."""
    prefix = name(peer, modulus, scene, None, restitution)
    kept = FOLDER/(prefix + ".json")
    if kept.exists():
        return json.loads(kept.read_text())["secondsPerSecond"]
    first = "bed" if scene == "bed" else "box"
    data = "%s.data" % prefix
    writeData(grains, periods, FOLDER/data, scene == "bed")
    settled = processorSeconds(peer, makeInput(peer, modulus, first, periods[0], "read_data " + data,
                               ["run %d" % steps(SETTLING, modulus)] + saveCommands(prefix, 0), restitution=restitution), prefix + ".settle", core)
    cost = settled/SETTLING
    if moments:
        commands = []
        for moment in range(1, moments + 1):
            commands += ["run %d" % steps(every, modulus)] + saveCommands(prefix, moment)
        cost = processorSeconds(peer, makeInput(peer, modulus, scene, periods[0], "read_restart %s.0.restart" % prefix, commands,
                                                  restitution=restitution),
                                prefix + ".run", core)/(moments*every)
    kept.write_text(json.dumps({"secondsPerSecond": cost}))
    return cost


def timeWindow(peer, modulus, scene, width, moment, window, core, skin=None, restitution=RESTITUTION):
    """Processor seconds a step from a restart, start-up subtracted."""
    start = "read_restart %s.restart" % name(peer, modulus, scene, moment, restitution)
    costs = [processorSeconds(peer, makeInput(peer, modulus, scene, width, start, ["run %d" % n], skin, restitution), "window", core) for n in (1, 1 + window)]
    return (costs[1] - costs[0])/window


def timeFromData(peer, modulus, scene, grains, periods, window, core):
    """The same from grains as they lie, for grains too stiff to be run for long."""
    writeData(grains, periods, FOLDER/"stiff.data", scene == "bed")
    costs = [processorSeconds(peer, makeInput(peer, modulus, scene, periods[0], "read_data stiff.data", ["run %d" % n]), "stiff", core)
             for n in (1, 1 + window)]
    return (costs[1] - costs[0])/window


def tableOf(peer, modulus, scene, moment, restitution=RESTITUTION):
    """A snapshot as a table of grains, for `peers figures`; its path."""
    dump = FOLDER/(name(peer, modulus, scene, moment, restitution) + ".dump")
    table = dump.with_suffix(".grains")
    with open(table, "w") as file:
        file.writelines("%.17g %.17g %.17g\n" % tuple(row[:3]) for row in readDump(dump))
    return table
