# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What each help of the contact solver is worth: processor time of steps without it over that with all of them, in four scenes of 3 000 and
of 25 000 grains, every ratio between runs from the same state. The table of src/nscd/measured.md. ablation.py [rounds]: 3 of each, an hour."""

import statistics
import sys

from coreRun import bed, rows, tableOf
from results import bars

SHAPES = ((10, 30), (29, 30))   # grains per side, layers: 3 000 and 25 230 grains
STEPS = 20
ALL = "all"                     # the variant that leaves nothing out


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    measured = [row for perSide, layers in SHAPES for row in rows("ablation", bed(perSide, layers), perSide, layers, rounds, STEPS)]
    table = tableOf("ablation", lambda: [({}, measured)], 1)     # the program has the rounds
    bars(table, ["scene", "grains", "moment", "round", "without"], "msPerStep", "ms per step (processor)")
    print(report(measured))


def report(measured):
    """A table in Markdown: a row for each help, a column for each scene and size, with the median of the ratios."""
    found = ratios(measured)
    scenes = unique((row["scene"], int(row["grains"])) for row in measured)
    helps = unique(row["without"] for row in measured if row["without"] != ALL)
    lines = ["| without | " + " | ".join("%s %d" % scene for scene in scenes) + " |", "|---|" + "---|"*len(scenes)]
    lines += ["| %s | " % name + " | ".join("%.2f" % statistics.median(found[name, scene]) for scene in scenes) + " |" for name in helps]
    times = (statistics.median(row["msPerStep"] for row in measured if row["without"] == ALL and (row["scene"], row["grains"]) == scene) for scene in scenes)
    return "\n".join(lines + ["| with all, ms per step | " + " | ".join("%.1f" % time for time in times) + " |"])


def ratios(measured):
    """Times over that with all helps in the same round from the same state, by name of the help and scene."""
    def state(row):
        return row["scene"], row["grains"], row["moment"], row["round"]
    withAll = {state(row): row["msPerStep"] for row in measured if row["without"] == ALL}
    found = {}
    for row in measured:
        found.setdefault((row["without"], (row["scene"], int(row["grains"]))), []).append(row["msPerStep"]/withAll[state(row)])
    return found


def unique(values):
    return list(dict.fromkeys(values))


if __name__ == "__main__":
    main()
