# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Our side of the comparison: the program `peers`, the settings it is compared with, and what its runs left."""

import csv
import subprocess

from softRuns import FOLDER
from results import ROOT

PROGRAM = ROOT/"build/core/benchmark/peers"
# By whose worst overlap they may reach; `default` are the library's own (rms 1e-2, overlap below 1e-3 d), `reference` a quarter of their step.
SETTINGS = {
    "default": {},
    "as 1e8": {"tolerance": 0.05, "displacementTolerance": 2e-3, "overlapTolerance": 2.7e-3},
    "as 5e6": {"tolerance": 0.1, "displacementTolerance": 1e-2, "overlapTolerance": 1e-2},
    "reference": {"deltaT": 2.5e-4},
}
REST = {"tolerance": 1e-3}


def call(*arguments, core):
    return subprocess.run(["taskset", "-c", str(core), PROGRAM, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True).stdout


def rows(text):
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(text.splitlines())]


def options(settings):
    return ["%s=%.9g" % item for item in settings.items()]


def readTable(path):
    with open(path) as file:
        return [[float(word) for word in line.split()] for line in file]


def settle(bed, core):
    """States at rest: bed.state and box.state, and their grains."""
    # Only a bed whose last grains have stopped rolling shows what rest costs, and falls asleep.
    for scene, steps, settings in (("bed", 1000, REST), ("box", 200, {})):
        state, table = FOLDER/(scene + ".state"), FOLDER/(scene + ".grains")
        if not state.exists():
            call("settle", scene, bed, state, "steps=%d" % steps, *options(settings), core=core)
        if not table.exists():
            call("table", state, table, core=core)
    return {scene: readTable(FOLDER/(scene + ".grains")) for scene in ("bed", "box")}


def fileOf(setting, moment=None, restitution=0.0):
    own = "" if restitution == 0 else ".e%g" % restitution
    return FOLDER/("ours.%s%s%s" % (setting.replace(" ", ""), own, ".csv" if moment is None else ".%d" % moment))


def moveWhole(bed, setting, every, moments, core, restitution=0.0):
    """The collapse in one go, a state and a row every so often; done once, and kept. Returns the rows."""
    kept = fileOf(setting, None, restitution)
    if not kept.exists():
        text = call("run", "collapse", bed, FOLDER/"box.state", "time=%.9g" % (every*moments), "every=%.9g" % every,
                    "out=%s" % str(fileOf(setting, 0, restitution))[:-1], *options(dict(SETTINGS[setting], restitution=restitution)), core=core)
        kept.write_text(text)
    return rows(kept.read_text())


def window(scene, bed, state, core, settings, **more):
    return rows(call("window", scene, bed, state, *options(dict(settings, **more)), core=core))[0]


def deviations(run, reference):
    """Largest differences of a run from the reference at the times both have, in shares of its value there; and the last such time."""
    pairs = [(a, b) for a in run for b in reference if abs(a["time"] - b["time"]) < 1e-9]
    if not pairs:
        return None
    return {name: max(abs(a[name]/b[name] - 1) for a, b in pairs) for name in ("centerX", "centerZ", "runOut90", "runOut99")}, pairs[-1][0]["time"]
