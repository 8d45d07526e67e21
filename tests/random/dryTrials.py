# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A random scene of nscdGrains: run, judged, and run again with a restart in the middle."""

import random

import dryJudge
from dryScenes import randomScene
from program import find, fresh, oneLine, run, write
from trial import Trial

SECONDS = 60
GROWTH = "energy growth, unconverged"


def runScene(folder, scene, steps, *options):
    write(folder/"scene", scene.text(steps))
    outcome = run([find("nscdGrains"), *options], folder, SECONDS)
    write(folder/("log" + "".join(options)), outcome.log)
    return outcome


def endOf(folder):
    """What a restart has to have like the run without one."""
    state = sorted((folder/"results/state").iterdir())[-1]
    return {path.name: path.read_bytes() for path in (state, folder/"results/report.csv", folder/"results/walls.csv")}


def differences(folder, scene):
    """Of a run in two halves from one in one piece."""
    halves = fresh(folder/"halves")
    for outcome in (runScene(halves, scene, scene.half), runScene(halves, scene, 2*scene.half, "-restart")):
        if outcome.status != 0:
            isDeep = "maxInitialOverlap is exceeded" in outcome.error
            return {outcome.crash or ("restart refused, overlap" if isDeep else "restart differs"): oneLine(outcome.error)}
    whole, end = endOf(folder), endOf(halves)
    return {"restart differs": ", ".join(name for name in whole if whole[name] != end.get(name))} if whole != end else {}


def trial(seed, folder):
    scene = randomScene(random.Random(f"dry {seed}"))
    outcome = runScene(folder, scene, 2*scene.half)
    if outcome.status != 0:
        isFast = "use a smaller time step" in outcome.error
        return Trial(seed, {outcome.crash or ("too fast" if isFast else "refused"): oneLine(outcome.error)}, {})
    found, figures = dryJudge.examine(folder, scene)
    if GROWTH in found and "energy from nowhere" not in outcome.log:
        found[GROWTH + ", not named"] = found.pop(GROWTH)
    return Trial(seed, {**found, **differences(folder, scene)}, figures)
