# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The page that a set of trials comes down to, and its verdict."""

import math

from bars import HARMLESS, KNOWN, STEPS_AT_CAP

SHOWN = 8   # seeds, and findings in words


def byKind(trials):
    kinds = {}
    for trial in trials:
        for kind in trial.found or ["fine"]:
            kinds.setdefault(kind, []).append(trial)
    return kinds


def mostAllowed(name, kind, number):
    """Of so many trials; one of few is allowed where a share is."""
    return math.ceil(KNOWN[name].get(kind, (0, ""))[0]*number)


def isGood(name, kind, number, total):
    return kind == "fine" or kind in HARMLESS or number <= mostAllowed(name, kind, total)


def stepsAtCap(trials):
    """Steps at the cap, and all steps."""
    return [sum(trial.figures.get(name, 0) for trial in trials) for name in ("atCap", "steps")]


def isWithinBars(name, trials):
    atCap, steps = stepsAtCap(trials)
    return bool(trials) and atCap <= STEPS_AT_CAP*steps and all(
        isGood(name, kind, len(those), len(trials)) for kind, those in byKind(trials).items())


def printSummary(name, trials, seconds, folder):
    kinds = byKind(trials)
    print(f"== {name}: {len(trials)} trials from {trials[0].seed} to {trials[-1].seed}, {seconds:.0f} s; those with findings in {folder}")
    for kind, those in sorted(kinds.items(), key=lambda item: -len(item[1])):
        printKind(name, kind, those, len(trials))
    atCap, steps = stepsAtCap(trials)
    if steps:
        verdict = "ok" if atCap <= STEPS_AT_CAP*steps else "BAD"
        print("%-4s %-28s %.2f %% of %d, bar %g %%" % (verdict, "steps at the cap", 100*atCap/steps, steps, 100*STEPS_AT_CAP))
    slowest = max(trials, key=lambda trial: trial.seconds)
    print("     slowest: %d, %.0f s" % (slowest.seed, slowest.seconds), flush=True)


def printKind(name, kind, those, total):
    if kind == "fine" or kind in HARMLESS:
        print("     %-28s %d" % (kind, len(those)))
        return
    verdict = "ok" if isGood(name, kind, len(those), total) else "BAD"
    seeds = " ".join(str(trial.seed) for trial in those[:SHOWN]) + (" ..." if len(those) > SHOWN else "")
    print("%-4s %-28s %d, bar %d: %s" % (verdict, kind, len(those), mostAllowed(name, kind, total), seeds))
    if kind in KNOWN[name]:
        print("     %-28s   known: %s" % ("", KNOWN[name][kind][1]))
    for trial in those[:SHOWN] if verdict == "BAD" else []:
        print("     %-28s   %d: %s" % ("", trial.seed, " ".join(part for part in (trial.what, trial.found[kind]) if part)))
