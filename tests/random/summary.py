# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The page that a set of trials comes down to, and its verdict."""

import math

from bars import GROUPS, HARMLESS, KNOWN, STEPS_AT_CAP

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
    """Group of scenes: steps at the cap, of all steps, and the bar."""
    found = {}
    for trial in trials:
        group = trial.figures.get("group", "")
        atCap, steps, _ = found.get(group, (0, 0, 0))
        bar = GROUPS[group][0] if group else STEPS_AT_CAP
        found[group] = (atCap + trial.figures.get("atCap", 0), steps + trial.figures.get("steps", 0), bar)
    return {group: counts for group, counts in found.items() if counts[1]}


def isWithinBars(name, trials):
    kinds = byKind(trials)
    return bool(trials) and all(isGood(name, kind, len(those), len(trials)) for kind, those in kinds.items()) and all(
        atCap <= bar*steps for atCap, steps, bar in stepsAtCap(trials).values())


def printSummary(name, trials, seconds, folder):
    kinds = byKind(trials)
    print(f"== {name}: {len(trials)} trials from {trials[0].seed} to {trials[-1].seed}, {seconds:.0f} s; those with findings in {folder}")
    for kind, those in sorted(kinds.items(), key=lambda item: -len(item[1])):
        printKind(name, kind, those, len(trials))
    for group, (atCap, steps, bar) in stepsAtCap(trials).items():
        print("%-4s %-28s %.2f %% of %d, bar %g %%" % (
            "ok" if atCap <= bar*steps else "BAD", "steps at the cap", 100*atCap/steps, steps, 100*bar))
        if group:
            print("     %-28s   of %s: %s" % ("", group, GROUPS[group][1]))
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
