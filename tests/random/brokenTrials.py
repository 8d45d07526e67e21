# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Broken scenes and cases: each has to end in words that name the place, or, where what was broken still makes sense, run to finite
numbers."""

import random
import re
from pathlib import Path

from brokenInputs import CASES, SCENES, break_, case, put, scene
from entryBreaks import ENTRY_BREAKS
from fileBreaks import FIELD_BREAKS, FILE_BREAKS, TABLE_BREAKS, TOKEN_BREAKS
from program import find, oneLine, run
from reports import notFinite, readTable
from trial import Trial

SECONDS = 20
# In a dictionary of ours these make no sense whatever they break, but for keys that are names of the user's choice.
SENSELESS = {"misspelt key", "key with an accent", "brace missing", "semicolon missing", "bracket missing", "garbage for value",
             "open brackets for value", "garbage bytes", "random file", "UTF-16", "no file", "deep list", "deep dictionaries",
             "number: nan", "number: inf", "number: -inf", "number: 1e999", "number: a word", "number: a comma", "number: hexadecimal",
             "number: a unit", "list too short"}
NAMED = re.compile(r"(materials|grains|walls|planes|driven|variables|periodic)\.[^.]+|(materials|grains|walls|planes|driven)")
WHOLE = set(FILE_BREAKS) | {"tokens exchanged"}     # no line to name
# What follows from a number that could be meant: which grains are where, or what to change.
TOLD_OF_GRAINS = ("maxInitialOverlap is exceeded", "outside the mesh", "use a smaller time step")
TIMES = ("deltaT", "endTime", "startTime", "stopAt", "startFrom")
KINDS = sorted({**ENTRY_BREAKS, **FILE_BREAKS, **TOKEN_BREAKS, **TABLE_BREAKS})
CASE_KINDS = sorted({*KINDS, *FIELD_BREAKS})


def names(error, broken):
    """Whether a message says where it is: the file, or what leads there, and the line or keyword."""
    key = broken.place.rsplit(".", 1)[-1].strip('"')
    hasFile = Path(broken.file).name in error
    hasPlace = re.search(r"(at|from|on|line|lines):? (line )?\d+|:\d+|keyword", error) or (len(key) > 1 and key in error)
    return hasFile and (hasPlace or broken.kind in WHOLE) or any(words in error for words in TOLD_OF_GRAINS)


def judge(broken, outcome, report):
    """Findings by kind; {"accepted": ...} is none of the wrong ones."""
    rows = readTable(report) if report and report.exists() else []
    if outcome.crash == "hang":
        # Steps of a billionth of a second go on for ever, as they were asked to.
        return {"long": f"{len(rows)} steps in {SECONDS} s"} if len(rows) > 10 and not notFinite(rows) else {"hang": f"{SECONDS} s"}
    if outcome.crash:
        return {"signal": oneLine(outcome.log[-300:])}
    if outcome.status == 0:
        return judgeAccepted(broken, rows)
    if not names(outcome.error, broken):
        return {"poor message" if broken.isOurs else "poor message, OpenFOAM's": oneLine(outcome.error)}
    return {}


def judgeAccepted(broken, rows):
    if not rows:    # its end may be before its first step
        isOfTime = broken.place.rsplit(".", 1)[-1] in TIMES
        return {"accepted": "no step"} if isOfTime else {"nothing done": "status 0, no step"}
    bad = notFinite(rows)
    if bad:
        return {"not finite": bad}
    isSenseless = broken.isOurs and broken.kind in SENSELESS and not NAMED.fullmatch(broken.place)
    return {"nonsense accepted": "ran"} if isSenseless else {"accepted": f"{len(rows)} steps"}


def latestReport(folder, pattern):
    return max(folder.glob(pattern), default=None, key=lambda path: path.stat().st_mtime)


def brokenTrial(seed, folder, inputs, kinds, program, reports, isCandidate):
    """The kind goes round with the seed, so that few trials have all of them; the rest is random."""
    rng = random.Random(f"{program} {seed}")
    kind = kinds[seed % len(kinds)]
    broken = None
    for name in rng.sample(sorted(inputs), len(inputs)):
        candidates = sorted(filter(isCandidate, inputs[name]))
        broken = broken or break_(inputs[name], kind, candidates, rng)
    put(broken.files, folder)
    outcome = run([find(program)], folder, SECONDS)
    (folder/"log").write_text(outcome.log)
    return Trial(seed, judge(broken, outcome, latestReport(folder, reports)), {}, what=str(broken))


def sceneInputs(folder):
    return {name: scene(name) for name in SCENES}


def caseInputs(folder):
    return {name: case(name, folder/name) for name in CASES}


def sceneTrial(seed, folder, inputs):
    return brokenTrial(seed, folder, inputs, KINDS, "nscdGrains", "results/report.csv", lambda file: True)


def caseTrial(seed, folder, inputs):
    """blockMesh is not run again: what it reads is not broken."""
    return brokenTrial(seed, folder, inputs, CASE_KINDS, "nscdDEMFoam", "postProcessing/grains/*/report.csv",
                       lambda file: not file.startswith(("system/blockMeshDict", "log")))
